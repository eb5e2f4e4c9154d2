// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/validity_checks.h"

#include "core/calibration/calibration_facts.h"
#include "core/signal/stream_account.h"
#include "core/words.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Share of saturated samples above which the measurement is invalid; any saturated sample makes it suspect.
constexpr double largestSaturatedShare = 0.01;
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
/// An effect counts from the half width of a 95 % interval, in standard errors ...
constexpr double halfWidth = 1.96;
/// ... and from this share of m, b or k: long records tell smaller ones that nobody would miss.
constexpr double negligibleShift = 0.005;
/// Below this simulation fit the model explains less than three quarters of the variance.
constexpr double smallestFitPercent = 50;

/// Steps of the device's clock: found in the samples' times, or known from the stream where they do not show.
std::uint64_t clockSteps(const Identification& data, const StreamAccount& stream)
{
    double breaks = 0;
    for (const PreparationStep& step : data.preparation)
        if (step.id == u"clock_break"_s)
            breaks = std::max(breaks, step.value);
    return std::max(stream.clockSteps, static_cast<std::uint64_t>(breaks));
}

QString lossWords(const Identification& data, bool tooMuch)
{
    const WindowChoice& choice = data.choice;
    const QString missing =
        Words::tr("%1 samples are missing in %2 places").arg(choice.lostSamples).arg(choice.gaps);
    if (tooMuch)
        return missing +
               Words::tr(", too much of the squeeze. Check the cable and the load of the computer, then "
                         "squeeze again.");
    if (const Estimate* const best = data.best(); best && best->part.count < data.position.size())
        return missing +
               Words::tr(". The estimate (%1) is of the longest stretch without any, %2 of %3 samples; oe "
                         "uses all. Check the cable and the load of the computer.")
                   .arg(toString(best->estimator))
                   .arg(best->part.count)
                   .arg(data.position.size());
    return missing +
           Words::tr(". Their forces count as unknown, which the errors include. Check the cable and the "
                     "load of the computer.");
}

QString clockWords(std::uint64_t steps)
{
    return Words::tr(
               "the gripper's clock jumped %1 times during the squeeze, so how long things took is in doubt. "
               "Squeeze again; where it happens again, check the gripper's power supply and firmware.")
        .arg(steps);
}

QString stallWords(const StreamAccount& stream)
{
    return Words::
        tr("the gripper fell silent %1 times during the squeeze, for up to %2 s. Check its cable and hub, "
           "then squeeze again.")
            .arg(stream.stalls)
            .arg(stream.longestStall_s, 0, 'g', 2);
}

/// Whether the stream came whole, and its clock ran on. Reports that came twice or damaged, and silences, say
/// nothing of it where no sample is missing.
ValidityCheck samplesLost(const Identification& data, const Recording& recording)
{
    ValidityCheck check;
    check.id = u"samples_lost"_s;
    const WindowChoice& choice = data.choice;
    const StreamAccount stream = streamAccount(recording).value_or(StreamAccount());
    const std::uint64_t steps = clockSteps(data, stream);
    const bool lost = choice.lostSamples != 0 || choice.gaps != 0;
    check.value = static_cast<double>(choice.lostSamples);
    check.limit = 0;
    const bool unseen = recording.provenance.contains(unseenLossesKey());
    check.ok = !lost && steps == 0 && !(unseen && stream.stalls > 0);
    // What was measured of the squeeze and used, against all of it.
    const double whole = static_cast<double>(choice.eligible) + static_cast<double>(choice.lostSamples);
    const double used = static_cast<double>(data.position.size()) - static_cast<double>(data.lost.size());
    check.decisive = whole > 0 && 1 - used / whole > PreparationOptions().largestLostShare;
    QStringList words;
    if (steps > 0)
        words << clockWords(steps);
    if (stream.stalls > 0)
        words << stallWords(stream);
    if (lost)
        words << lossWords(data, check.decisive);
    if (check.ok && unseen)
        words << Words::tr(
            "whether samples are missing cannot be seen: the gripper sends neither a number nor a clock");
    else if (check.ok) // a silence that took nothing with it delays the numbers, and changes none
        words.prepend(stream.stalls > 0 ? Words::tr("no sample is missing, though")
                                        : Words::tr("no sample is missing"));
    check.message = words.join(u' ');
    return check;
}

ValidityCheck saturation(const Identification& data, const Recording& recording)
{
    ValidityCheck check;
    check.id = u"saturation"_s;
    check.limit = 0;
    const Window window = data.choice.window;
    std::size_t saturated = 0;
    if (recording.status.size() == recording.size()) {
        for (std::size_t i = window.first; i < window.first + window.count; ++i)
            saturated +=
                (recording.status[i] & (StatusForceSaturated | StatusPositionSaturated)) != 0 ? 1 : 0;
    }
    const double share =
        window.count > 0 ? static_cast<double>(saturated) / static_cast<double>(window.count) : 0;
    check.value = 100 * share;
    check.ok = saturated == 0;
    check.decisive = share > largestSaturatedShare;
    check.message = check.ok
                        ? Words::tr("no sample is marked as saturated")
                        : Words::tr("%1 samples are at the end of a sensor's range. Squeeze with less force.")
                              .arg(saturated);
    return check;
}

/// What the preparation could not mend.
ValidityCheck preparation(const Identification& data)
{
    ValidityCheck check;
    check.id = u"preparation"_s;
    check.limit = 0;
    QStringList doubts;
    for (const PreparationStep& step : data.preparation)
        if (!step.ok)
            doubts << step.message;
    check.value = static_cast<double>(doubts.size());
    check.ok = doubts.isEmpty();
    check.message = check.ok ? Words::tr("nothing in the recording was beyond mending") : doubts.join(u' ');
    return check;
}

ValidityCheck excitation(const Estimate& estimate)
{
    ValidityCheck check;
    check.id = u"excitation"_s;
    check.limit = 100 * largestRelativeError;
    if (estimate.status == EstimateStatus::NotIdentifiable ||
        estimate.status == EstimateStatus::TooFewSamples) {
        check.ok = false;
        check.decisive = true;
        check.message = Words::tr(estimate.message.c_str());
        return check;
    }
    const std::optional<Eigen::Vector3d> errors = estimate.standardErrors();
    if (!estimate.parameters || !errors) {
        check.message = Words::tr("not judged without an estimate");
        return check;
    }
    const double mass = (*errors)(0) / estimate.parameters->m;
    const double stiffness = (*errors)(2) / estimate.parameters->k;
    check.value = 100 * std::max(mass, stiffness);
    check.ok = *check.value <= *check.limit;
    check.message =
        check.ok ? Words::tr("the force moves the object enough to tell m and k")
                 : Words::tr("the %1 is known to %2 % only. Squeeze longer or with a force that varies %3.")
                       .arg(mass > stiffness ? Words::tr("mass") : Words::tr("stiffness"))
                       .arg(*check.value, 0, 'g', 2)
                       .arg(mass > stiffness ? Words::tr("faster") : Words::tr("more slowly"));
    return check;
}

/// `matters`: what the test would find is large enough to change m, b and k or their errors.
ValidityCheck residualTest(const QString& id, std::optional<double> p, bool matters, const QString& good,
                           const QString& bad)
{
    ValidityCheck check;
    check.id = id;
    check.value = p;
    check.limit = smallestP;
    const bool found = p && *p < smallestP;
    check.ok = !found || !matters;
    if (!p)
        check.message = Words::tr("not judged: there is nothing to test");
    else
        check.message = !found ? good : matters ? bad : bad + Words::tr("; too little to matter");
    return check;
}

bool remainderMatters(const Estimate& estimate)
{
    return 100 - estimate.fit.predictionPercent.value_or(0) >= negligibleRemainder;
}

QString noiseWords(const AutoregressiveNoise& noise, double inflation)
{
    const QString errors =
        Words::tr("; counted in the errors, which are up to %1 times as large").arg(inflation, 0, 'g', 2);
    if (noise.forceDeviation)
        return Words::tr("the force is measured with noise of %1 (standard deviation)")
                   .arg(*noise.forceDeviation, 0, 'g', 2) +
               errors;
    return Words::tr("the residuals are not white: a noise model of order %1 describes them")
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
    return residualTest(u"residual_whiteness"_s, p, remainderMatters(estimate) && matters,
                        modelled ? noiseWords(*estimate.noise, residuals.errorInflation.value_or(1))
                                 : Words::tr("the residuals look like white noise"),
                        Words::tr("the residuals are not white%1: something besides sensor noise is in the "
                                  "position, and the errors "
                                  "shown are too small. Check for a loose grip, vibration and drift")
                            .arg(modelled ? Words::tr(", and no noise model describes them") : QString()));
}

ValidityCheck inputIndependence(const Estimate& estimate)
{
    const bool matters = estimate.residuals.inputMisfit.value_or(halfWidth) >= halfWidth;
    return residualTest(
        u"input_independence"_s, estimate.residuals.inputIndependenceP, remainderMatters(estimate) && matters,
        Words::tr("the residuals do not depend on the force"),
        Words::tr(
            "the residuals depend on the force: the object is not just a mass, a spring and a damper at "
            "this force, or the hold or the lag is wrong. Check these, and compare with duffing"));
}

ValidityCheck linearity(const Estimate& estimate)
{
    const ResidualSummary& residuals = estimate.residuals;
    const double shift = residuals.linearityShift.value_or(0);
    const bool matters =
        residuals.linearityShiftInErrors.value_or(0) >= halfWidth && shift >= negligibleShift;
    return residualTest(
        u"linearity"_s, residuals.linearityP, matters, Words::tr("the spring is straight at this force"),
        Words::tr("the spring is not straight: with a curved one m, b or k moves by up to %1 %, %2 "
                  "standard errors. Use "
                  "duffing, or squeeze with a smaller peak")
            .arg(100 * shift, 0, 'g', 2)
            .arg(residuals.linearityShiftInErrors.value_or(0), 0, 'g', 2));
}

ValidityCheck feedback(const Estimate& estimate)
{
    // What the model misses of the past force shows in the future force too, where that is smooth.
    const double misfit = estimate.residuals.feedbackMisfit.value_or(0);
    const bool matters = misfit >= halfWidth && misfit >= estimate.residuals.inputMisfit.value_or(0);
    return residualTest(
        u"feedback"_s, estimate.residuals.feedbackP, remainderMatters(estimate) && matters,
        Words::tr("the force does not answer to the position"),
        Words::tr("the force answers to disturbances of the position, as under feedback: m, b and k "
                  "are biased. Squeeze "
                  "with a repeated excitation and use periodic, or control the force less stiffly"));
}

/// " with gripper SERIAL" where the recording names one.
QString withGripper(const Recording& recording)
{
    const QString serial = recording.provenance.value(u"serial"_s);
    return serial.isEmpty() ? QString() : Words::tr(" with gripper %1").arg(serial);
}

/// A contradiction: what speaks against the declared hold, where, and what to do.
QString contradictedHold(const Identification& data, const Recording& recording, const QString& name,
                         const QString& other)
{
    const HoldEvidence& telling = data.tellingHold();
    if (telling.squeezes < 2)
        return Words::tr(
                   "the position fits the force hold %1 clearly better than %2, which was used: m and b are "
                   "off. "
                   "Name the right hold, or check the lag between the channels.")
            .arg(other, name);
    QString words =
        Words::tr("over %1 squeezes%2 the position fits the force hold %3 clearly better than %4, "
                  "which was used: m "
                  "and b of this squeeze are off, and those of the earlier ones too. Name the right hold, "
                  "or measure the "
                  "lag between the channels, and identify them again.")
            .arg(telling.squeezes)
            .arg(withGripper(recording), other, name);
    if (data.holdEvidence.verdict() == HoldVerdict::Agrees)
        words +=
            Words::tr(" This squeeze alone agrees with %1: see whether the gripper was changed in between.")
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
                ? Words::tr("over %1 squeezes%2 the position agrees with the force hold %3 and not with %4")
                      .arg(telling.squeezes)
                      .arg(withGripper(recording), name, other)
                : Words::tr("the position agrees with the force hold %1 and not with %2").arg(name, other);
    else if (options.hold)
        check.message = Words::tr("the force hold %1 was asked for").arg(name);
    else if (recording.hold)
        check.message = Words::tr("the force hold %1 is the recording's own").arg(name);
    else
        check.message = Words::tr("the recording names no force hold; %1 was assumed").arg(name);
    if (verdict == HoldVerdict::Ambiguous)
        check.message +=
            several
                ? Words::tr("; %1 squeezes together cannot tell it from %2").arg(telling.squeezes).arg(other)
                : Words::tr("; this record cannot tell it from %1").arg(other);
    return check;
}

ValidityCheck convergence(const Estimate& estimate)
{
    ValidityCheck check;
    check.id = u"convergence"_s;
    check.value = estimate.iterations;
    check.ok = estimate.status == EstimateStatus::Converged;
    check.decisive = true;
    check.message = check.ok
                        ? Words::tr("the estimator reached its answer")
                        : u"%1: %2"_s.arg(toString(estimate.status), Words::tr(estimate.message.c_str()));
    return check;
}

ValidityCheck physicalRange(const Estimate& estimate, double sampleTime_s)
{
    ValidityCheck check;
    check.id = u"physical_range"_s;
    if (!estimate.parameters) {
        check.ok = false;
        check.decisive = true;
        check.message = Words::tr("no m, b and k above zero were found. Squeeze again.");
        return check;
    }
    // Above half the sample rate a natural frequency is an alias, not a measurement.
    check.value = std::sqrt(estimate.parameters->k / estimate.parameters->m) / (2 * std::numbers::pi);
    check.limit = 0.5 / sampleTime_s;
    check.ok = *check.value < *check.limit;
    check.message =
        check.ok
            ? Words::tr("m, b and k are above zero and the natural frequency is below half the sample rate")
            : Words::tr("the natural frequency found, %1 Hz, is above half the sample rate. Sample faster.")
                  .arg(*check.value, 0, 'g', 4);
    return check;
}

ValidityCheck fitCheck(const Estimate& estimate)
{
    ValidityCheck check;
    check.id = u"fit"_s;
    check.value = estimate.fit.simulationPercent;
    check.limit = smallestFitPercent;
    if (!estimate.parameters) {
        check.message = Words::tr("not judged without an estimate");
        return check;
    }
    check.ok = check.value && *check.value >= smallestFitPercent;
    check.message =
        check.ok
            ? Words::tr("the model follows the position")
            : Words::tr("the model does not follow the position. Look at the residuals: noise, a loose grip "
                        "and an object that is no mass, spring and damper all do this.");
    return check;
}

/// What speaks against the channels by their last check on a reference object; empty when nothing does.
QString referenceDoubt(const Recording& recording)
{
    const std::optional<ReferenceCheckFact> fact = referenceCheckFact(recording.provenance);
    if (!fact || fact->status == CheckStatus::Passed)
        return {};
    if (fact->status == CheckStatus::Failed)
        return Words::tr(
                   "the gripper failed its check on the reference object (%1). Find out why and check it "
                   "again, then squeeze again.")
            .arg(fact->words);
    return Words::tr(
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
    QStringList doubts;
    if (first != facts.end()) {
        check.value = static_cast<double>(first->daysLeft);
        check.limit = 0;
        if (first->daysLeft < 0)
            doubts
                << Words::tr(
                       "the calibration of the %1 was overdue by %2 days. Calibrate it, then squeeze again.")
                       .arg(first->channel == SensorChannel::Force ? Words::tr("force")
                                                                   : Words::tr("position"))
                       .arg(-first->daysLeft);
    }
    if (const QString doubt = referenceDoubt(recording); !doubt.isEmpty())
        doubts << doubt;
    check.ok = doubts.isEmpty();
    check.message = !check.ok ? doubts.join(u' ')
                    : first != facts.end()
                        ? Words::tr("the calibrations held on that day")
                        : Words::tr("not judged: the channels carry the device's own calibration");
    return check;
}

} // namespace

std::vector<ValidityCheck> checkValidity(const Identification& identification, const Recording& recording,
                                         const IdentificationOptions& options)
{
    const Estimate none;
    const Estimate* const found = identification.find(identification.recommended);
    const Estimate& estimate = found != nullptr ? *found : none;
    // Output error says best whether the force was rich enough, also when another estimator found numbers.
    const Estimate* const outputError = identification.find(Estimator::OutputError);
    return {samplesLost(identification, recording),
            saturation(identification, recording),
            excitation(outputError != nullptr ? *outputError : estimate),
            residualWhiteness(estimate),
            inputIndependence(estimate),
            hold(identification, recording, options),
            convergence(estimate),
            physicalRange(estimate, identification.sampleTime_s),
            fitCheck(estimate),
            calibration(recording),
            linearity(estimate),
            feedback(estimate),
            preparation(identification)};
}

} // namespace gripscope
