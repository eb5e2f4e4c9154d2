// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/validity/validity_checks.h"

#include "core/base/words.h"
#include "core/calibration/calibration_facts.h"
#include "core/identification/uncertainty/uncertainty_budget.h"
#include "core/math/normal_interval.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// The relative standard error above which m or k counts as not excited.
constexpr double largestRelativeError = 0.5;
/// The four tests with a p-value share a false-alarm rate of 1 % (Sidak 1967): 1 - (1 - 0.01)^(1/4). That the
/// effect must count too, and that the hold is accused in 0.5 % at the most, keeps all of them below 2 %.
constexpr double smallestP = 0.00251;
/// Residuals below this percentage of the position's spread change m, b and k by a few percent at the most,
/// whatever they are: position steps (quantisation) are never white where sensor noise is small.
constexpr double negligibleRemainder = 1;
/// Correlation that no noise model counts matters when it makes a standard error this much larger.
constexpr double largestInflation = 1.5;
/// Where a noise model was found, what it leaves must be small beside it: more than this is another model.
constexpr double largestInnovationInflation = 1.1;
/// An effect counts from half a 95 % interval (`normal95` standard errors) and from this share of m, b or k:
/// long records tell smaller ones that nobody would miss.
constexpr double negligibleShift = 0.005;
/// Below this simulation fit the model explains less than three quarters of the variance.
constexpr double smallestFitPercent = 50;

/// What the preparation could not mend.
ValidityCheck preparation(const Identification& data)
{
    ValidityCheck check;
    check.id = u"preparation"_s;
    check.limit = 0;
    Findings doubts;
    // These have checks of their own.
    const QStringList elsewhere{u"saturation"_s, u"clock_drift"_s, u"position_held"_s};
    for (const PreparationStep& step : data.preparation)
        if (!step.ok && !elsewhere.contains(step.id))
            doubts.push_back(step.message);
    check.value = static_cast<double>(doubts.size());
    check.ok = doubts.empty();
    check.message = check.ok ? Words::say("nothing in the recording was beyond mending")
                             : Finding::joined(doubts, u" "_s);
    return check;
}

/// A motion without a mass or a spring: it has no m, b and k, but what it has was found.
bool isFoundInPart(const Estimate& estimate)
{
    return estimate.isPartialMotion() && estimate.status == EstimateStatus::Converged;
}

/// The relative standard error of m or k, 0 where the motion has none.
double relativeError(const MotionEstimate& motion, MotionParameter parameter)
{
    const std::vector<MotionParameter> parameters = motion.terms.parameters();
    const auto at = std::ranges::find(parameters, parameter);
    if (at == parameters.end())
        return 0;
    const Eigen::Index index = at - parameters.begin();
    return std::sqrt(motion.covariance(index, index)) / motion.values[parameter];
}

/// Without a mass nothing but the levels of force tells friction from stiffness.
bool frictionHides(const Estimate& estimate, double sampleTime_s, const Recording& recording)
{
    if (recording.chain.friction)
        return false;
    const auto friction = restingFriction(estimate, sampleTime_s, {});
    return friction && !friction->isTold();
}

ValidityCheck excitation(const Estimate& estimate, double sampleTime_s, const Recording& recording)
{
    ValidityCheck check;
    check.id = u"excitation"_s;
    check.limit = 100 * largestRelativeError;
    if (estimate.status == EstimateStatus::NotIdentifiable ||
        estimate.status == EstimateStatus::TooFewSamples) {
        check.ok = false;
        check.decisive = true;
        check.message = estimate.message;
        return check;
    }
    const std::optional<Eigen::Vector3d> errors = estimate.standardErrors();
    const bool partial = isFoundInPart(estimate);
    if (!partial && (!estimate.parameters || !errors)) {
        check.message = Words::say("not judged without an estimate");
        check.noted = true;
        return check;
    }
    const double mass = partial ? relativeError(*estimate.motion, MotionParameter::Mass)
                                : (*errors)(0) / estimate.parameters->m;
    const double stiffness = partial ? relativeError(*estimate.motion, MotionParameter::Stiffness)
                                     : (*errors)(2) / estimate.parameters->k;
    check.value = 100 * std::max(mass, stiffness);
    check.ok = *check.value <= *check.limit;
    if (check.ok && partial && frictionHides(estimate, sampleTime_s, recording)) {
        check.ok = false;
        check.message =
            Words::say("with these levels of force friction would pass for stiffness: k is too high "
                       "by it over half the force's range. Squeeze with four levels, or "
                       "characterise the gripper, which tells its own friction");
        return check;
    }
    check.decisive = stiffness > largestRelativeError; // without a stiffness nothing was measured
    check.message =
        check.ok ? partial ? Words::say("the force moves the object enough to tell what the motion has")
                           : Words::say("the force moves the object enough to tell m and k")
                 : Words::say("the %1 is known to %2 % only. Squeeze longer or with a force that varies %3.")
                       .arg(mass > stiffness ? Words::say("mass") : Words::say("stiffness"))
                       .arg(*check.value, 'g', 2)
                       .arg(mass > stiffness ? Words::say("faster") : Words::say("more slowly"));
    return check;
}

/// `matters`: what the test would find is large enough to change m, b and k or their errors.
ValidityCheck residualTest(const QString& id, std::optional<double> p, bool matters, const Finding& good,
                           const Finding& bad)
{
    ValidityCheck check;
    check.id = id;
    check.value = p;
    check.limit = smallestP;
    const bool found = p && *p < smallestP;
    check.ok = !found || !matters;
    check.noted = !p || (found && check.ok);
    if (!p)
        check.message = Words::say("not judged: there is nothing to test");
    else
        check.message = !found ? good : matters ? bad : bad + Words::say("; too little to matter");
    return check;
}

bool remainderMatters(const Estimate& estimate)
{
    return 100 - estimate.fit.predictionPercent.value_or(0) >= negligibleRemainder;
}

Finding noiseWords(const AutoregressiveNoise& noise, double inflation)
{
    const Finding errors =
        Words::say("; counted in the errors, which are up to %1 times as large").arg(inflation, 'g', 2);
    if (noise.forceDeviation)
        return Words::say("the force is measured with noise of %1 (standard deviation)")
                   .arg(*noise.forceDeviation, 'g', 2) +
               errors;
    return Words::say("the residuals are not white: a noise model of order %1 describes them")
               .arg(noise.coefficients.size()) +
           errors;
}

ValidityCheck residualWhiteness(const Estimate& estimate)
{
    const ResidualSummary& residuals = estimate.residuals;
    // What a noise model counts is in the errors already; what it leaves is not.
    const bool modelled = estimate.noise.has_value();
    const std::optional<double> p = modelled ? residuals.innovationWhitenessP : residuals.whitenessP;
    const bool matters =
        modelled ? residuals.innovationInflation.value_or(largestInflation) >= largestInnovationInflation
                 : residuals.errorInflation.value_or(largestInflation) >= largestInflation;
    ValidityCheck check =
        residualTest(u"residual_whiteness"_s, p, remainderMatters(estimate) && matters,
                     modelled ? noiseWords(*estimate.noise, residuals.errorInflation.value_or(1))
                              : Words::say("the residuals look like white noise"),
                     Words::say("the residuals are not white%1: something besides sensor noise is in the "
                                "position, and the errors "
                                "shown are too small. Check for a loose grip, vibration and drift")
                         .arg(modelled ? Words::say(", and no noise model describes them") : QString()));
    check.noted = check.noted || (check.ok && modelled);
    return check;
}

ValidityCheck inputIndependence(const Estimate& estimate)
{
    const bool matters = estimate.residuals.inputMisfit.value_or(normal95) >= normal95;
    return residualTest(
        u"input_independence"_s, estimate.residuals.inputIndependenceP, remainderMatters(estimate) && matters,
        Words::say("the residuals do not depend on the force"),
        Words::say(
            "the residuals depend on the force: the object is not just a mass, a spring and a damper at "
            "this force, or the hold or the lag is wrong. Check these, and compare with duffing"));
}

ValidityCheck linearity(const Estimate& estimate)
{
    const ResidualSummary& residuals = estimate.residuals;
    const double shift = residuals.linearityShift.value_or(0);
    const bool matters = residuals.linearityShiftInErrors.value_or(0) >= normal95 && shift >= negligibleShift;
    return residualTest(
        u"linearity"_s, residuals.linearityP, matters, Words::say("the spring is straight at this force"),
        Words::say("the spring is not straight: with a curved one m, b or k moves by up to %1 %, %2 "
                   "standard errors. Use "
                   "duffing, or squeeze with a smaller peak")
            .arg(100 * shift, 'g', 2)
            .arg(residuals.linearityShiftInErrors.value_or(0), 'g', 2));
}

ValidityCheck feedback(const Estimate& estimate)
{
    // What the model misses of the past force shows in the future force too, where that is smooth.
    const double misfit = estimate.residuals.feedbackMisfit.value_or(0);
    const bool matters = misfit >= normal95 && misfit >= estimate.residuals.inputMisfit.value_or(0);
    return residualTest(
        u"feedback"_s, estimate.residuals.feedbackP, remainderMatters(estimate) && matters,
        Words::say("the force does not answer to the position"),
        Words::say("the force answers to disturbances of the position, as under feedback: m, b and k "
                   "are biased. Squeeze "
                   "with a repeated excitation and use periodic, or control the force less stiffly"));
}

/// " with gripper SERIAL" where the recording names one.
Finding withGripper(const Recording& recording)
{
    const QString serial = recording.provenance.value(u"serial"_s);
    return serial.isEmpty() ? QString() : Words::say(" with gripper %1").arg(serial);
}

/// A contradiction: what speaks against the declared hold, where, and what to do.
Finding contradictedHold(const Identification& data, const Recording& recording, const QString& name,
                         const QString& other)
{
    const HoldEvidence& telling = data.tellingHold();
    if (telling.squeezes < 2)
        return Words::say(
                   "the position fits the force hold %1 clearly better than %2, which was used: m and b are "
                   "off. "
                   "Name the right hold, or check the lag between the channels.")
            .arg(other, name);
    Finding words =
        Words::say("over %1 squeezes%2 the position fits the force hold %3 clearly better than %4, "
                   "which was used: m "
                   "and b of this squeeze are off, and those of the earlier ones too. Name the right hold, "
                   "or measure the "
                   "lag between the channels, and identify them again.")
            .arg(telling.squeezes)
            .arg(withGripper(recording), other, name);
    if (data.holdEvidence.verdict() == HoldVerdict::Agrees)
        words +=
            Words::say(" This squeeze alone agrees with %1: see whether the gripper was changed in between.")
                .arg(name);
    return words;
}

ValidityCheck hold(const Identification& data, const Recording& recording,
                   const IdentificationOptions& options)
{
    const HoldEvidence& telling = data.tellingHold();
    ValidityCheck check;
    check.id = u"hold"_s;
    check.value = telling.gain;
    check.limit = telling.limit();
    const HoldVerdict verdict = telling.verdict();
    check.ok = verdict != HoldVerdict::Contradicts;
    const QString name = toString(data.hold);
    const QString other = toString(data.hold == ForceHold::Zero ? ForceHold::First : ForceHold::Zero);
    const bool several = telling.squeezes > 1;
    if (!check.ok)
        check.message = contradictedHold(data, recording, name, other);
    else if (verdict == HoldVerdict::Agrees)
        check.message =
            several
                ? Words::say("over %1 squeezes%2 the position agrees with the force hold %3 and not with %4")
                      .arg(telling.squeezes)
                      .arg(withGripper(recording), name, other)
                : Words::say("the position agrees with the force hold %1 and not with %2").arg(name, other);
    else if (options.hold)
        check.message = Words::say("the force hold %1 was asked for").arg(name);
    else if (recording.hold)
        check.message = Words::say("the force hold %1 is the recording's own").arg(name);
    else
        check.message = Words::say("the recording names no force hold; %1 was assumed").arg(name);
    if (verdict == HoldVerdict::Ambiguous)
        check.message +=
            several
                ? Words::say("; %1 squeezes together cannot tell it from %2").arg(telling.squeezes).arg(other)
                : Words::say("; this record cannot tell it from %1").arg(other);
    return check;
}

/// What the check of the excitation says already is not said again.
Finding noAnswerWords(const Estimate& estimate)
{
    const bool saidAlready = estimate.status == EstimateStatus::NotIdentifiable ||
                             estimate.status == EstimateStatus::TooFewSamples;
    if (saidAlready || estimate.message.isEmpty())
        return Words::say("the estimator found no answer");
    return Words::say("the estimator found no answer: %1").arg(estimate.message);
}

ValidityCheck convergence(const Estimate& estimate)
{
    ValidityCheck check;
    check.id = u"convergence"_s;
    check.value = estimate.iterations;
    check.ok = estimate.status == EstimateStatus::Converged;
    check.decisive = true;
    check.message = check.ok ? Words::say("the estimator reached its answer") : noAnswerWords(estimate);
    return check;
}

ValidityCheck physicalRange(const Estimate& estimate, double sampleTime_s)
{
    ValidityCheck check;
    check.id = u"physical_range"_s;
    if (isFoundInPart(estimate)) {
        check.message = Words::say("what the motion has is above zero; the rest of m, b and k is not in it");
        return check;
    }
    if (!estimate.parameters) {
        check.ok = false;
        check.decisive = true;
        check.message = Words::say("no m, b and k above zero were found. Squeeze again.");
        return check;
    }
    // Above half the sample rate what swings is an alias, not a measurement. What creeps does not swing.
    const auto [m, b, k] = *estimate.parameters;
    check.value = std::sqrt(std::max(0.0, k / m - std::pow(b / m / 2, 2))) / (2 * std::numbers::pi);
    check.limit = 0.5 / sampleTime_s;
    check.ok = *check.value < *check.limit;
    check.message =
        check.ok
            ? Words::say("m, b and k are above zero and the object swings at less than half the sample rate")
            : Words::say("the object found swings at %1 Hz, above half the sample rate. Sample faster.")
                  .arg(*check.value, 'g', 4);
    return check;
}

ValidityCheck fitCheck(const Estimate& estimate)
{
    ValidityCheck check;
    check.id = u"fit"_s;
    check.value = estimate.fit.simulationPercent;
    check.limit = smallestFitPercent;
    if ((!estimate.parameters && !isFoundInPart(estimate)) || estimate.stiffnessBounds) {
        check.message = Words::say("not judged without an estimate");
        check.noted = true;
        return check;
    }
    check.ok = check.value && *check.value >= smallestFitPercent;
    check.message =
        check.ok
            ? Words::say("the model follows the position")
            : Words::say("the model does not follow the position. Look at the residuals: noise, a loose grip "
                         "and an object that is no mass, spring and damper all do this.");
    return check;
}

/// What speaks against the channels by their last check on a reference object; empty when nothing does.
Finding referenceDoubt(const Recording& recording)
{
    const std::optional<ReferenceCheckFact> fact = referenceCheckFact(recording.provenance);
    if (!fact || fact->status == CheckStatus::Passed)
        return {};
    if (fact->status == CheckStatus::Failed)
        return Words::say(
                   "the gripper failed its check on the reference object (%1). Find out why and check it "
                   "again, then squeeze again.")
            .arg(fact->words);
    return Words::say(
               "the check of the gripper on its reference object was due (%1). Check it, then squeeze again.")
        .arg(fact->words);
}

/// value: days that the calibration still held; limit: none left.
ValidityCheck calibration(const Recording& recording)
{
    ValidityCheck check;
    check.id = u"calibration"_s;
    const std::vector<CalibrationFact> facts = calibrationFacts(recording.provenance);
    const auto first = std::min_element(facts.begin(), facts.end(),
                                        [](const auto& a, const auto& b) { return a.daysLeft < b.daysLeft; });
    Findings doubts;
    if (first != facts.end()) {
        check.value = static_cast<double>(first->daysLeft);
        check.limit = 0;
        if (first->daysLeft < 0)
            doubts.push_back(
                Words::say(
                    "the calibration of the %1 was overdue by %2 days. Calibrate it, then squeeze again.")
                    .arg(first->channel == SensorChannel::Force ? Words::say("force")
                                                                : Words::say("position"))
                    .arg(-first->daysLeft));
    }
    if (const Finding doubt = referenceDoubt(recording); !doubt.isEmpty())
        doubts.push_back(doubt);
    check.ok = doubts.empty();
    check.noted = check.ok && first == facts.end();
    check.message = !check.ok ? Finding::joined(doubts, u" "_s)
                    : first != facts.end()
                        ? Words::say("the calibrations held on that day")
                        : Words::say("not judged: the channels carry the device's own calibration");
    return check;
}

} // namespace

/// The relaxed stiffness is what is left when one waits: for some times tau.
ValidityCheck relaxation(const Identification& data, const Estimate& estimate)
{
    constexpr double longestShare = 0.4; ///< of the record: from there on k and k1 are told apart by a guess
    constexpr double much = 3 * decisiveDelta;
    ValidityCheck check;
    check.id = u"relaxation"_s;
    check.limit = 100 * longestShare;
    const double length_s = data.sampleTime_s * static_cast<double>(data.force.size());
    const bool yields = estimate.motion && estimate.motion->terms.relaxation;
    if (yields)
        check.value = 100 * estimate.motion->values[MotionParameter::RelaxationTime] / length_s;
    // Where something else explains the squeeze, yielding was only a way towards it.
    const bool endless =
        estimate.estimator == Estimator::OutputError && data.comparison.unsettledYielding > much;
    check.ok = !endless && check.value.value_or(0) <= *check.limit;
    if (endless)
        check.message =
            Words::say("the position goes on creeping through the whole squeeze: the part yields, "
                       "or the sensor drifts. The stiffness that is left in the end is not known; "
                       "squeeze longer");
    else if (!check.ok)
        check.message = Words::say("the part goes on yielding for %1 % of the squeeze: the stiffness that is "
                                   "left in the end is a guess. Squeeze longer")
                            .arg(*check.value, 'g', 2);
    else
        check.message = yields ? Words::say("the squeeze is long enough to see the part yield")
                               : Words::say("the part does not go on yielding");
    return check;
}

std::vector<ValidityCheck> checkValidity(const Identification& identification, const Recording& recording,
                                         const IdentificationOptions& options)
{
    const Estimate none;
    const Estimate* const found = identification.find(identification.recommended);
    const Estimate& estimate = found != nullptr ? *found : none;
    // Output error says best whether the force was rich enough, also when another estimator found numbers.
    const Estimate* const outputError = identification.find(Estimator::OutputError);
    std::vector<ValidityCheck> checks{
        samplesLost(identification, recording),
        saturation(identification, recording),
        stuckChannel(identification, recording),
        deviceFault(recording),
        clockAgainstComputer(recording),
        statedSampleTime(identification, recording),
        excitation(outputError != nullptr && !isFoundInPart(estimate) ? *outputError : estimate,
                   identification.sampleTime_s, recording),
        residualWhiteness(estimate),
        inputIndependence(estimate),
        hold(identification, recording, options),
        convergence(estimate),
        physicalRange(estimate, identification.sampleTime_s),
        fitCheck(estimate),
        calibration(recording),
        linearity(estimate),
        feedback(estimate),
        relaxation(identification, estimate),
        preparation(identification)};
    if (std::optional<ValidityCheck> held = heldPositionCheck(identification))
        checks.push_back(*std::move(held));
    return checks;
}

} // namespace gripscope
