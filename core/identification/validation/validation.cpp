// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/validation/validation.h"

#include "core/base/words.h"
#include "core/identification/estimators/run_estimator.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/noise/noise_model.h"
#include "core/identification/noise/residual_tests.h"
#include "core/identification/validation/validation_contrast.h"
#include "core/math/fit.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Ljung-Box below this: certainly not white.
constexpr double certainlyColoured = 0.001;
/// The tests need some samples besides the unknowns.
constexpr std::size_t fewestRecordSamples = 30;
/// A step in the logarithms that a linearisation is still good for (a factor of two).
constexpr double longestChange = 0.7;

std::span<const double> rowSpan(const Eigen::RowVectorXd& row)
{
    return {row.data(), static_cast<std::size_t>(row.size())};
}

/// Covariance of the logarithms of the parameters that are above zero, and of the others.
std::optional<Eigen::MatrixXd> covarianceOfLogarithms(const MotionEstimate& motion)
{
    if (motion.covariance.size() == 0)
        return std::nullopt;
    const std::vector<MotionParameter> parameters = motion.terms.parameters();
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(motion.covariance.rows());
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (isPositive(parameters[i]))
            scale(static_cast<Eigen::Index>(i)) = 1 / motion.values[parameters[i]];
    const Eigen::MatrixXd covariance = scale.asDiagonal() * motion.covariance * scale.asDiagonal();
    return covariance.allFinite() ? std::optional(covariance) : std::nullopt;
}

/// Which noise the rest has: white, or an autoregression.
AutoregressiveNoise noiseOf(const ValidationContrast& contrast)
{
    Eigen::MatrixXd basis(contrast.nuisanceBasis().rows() + contrast.rank(), contrast.rest().size());
    basis << contrast.nuisanceBasis(), contrast.parameterBasis();
    const std::optional<double> p = ljungBoxP(rowSpan(contrast.rest()), 0, basis);
    if (!p || *p >= certainlyColoured)
        return {};
    return fitAutoregressiveNoise(rowSpan(contrast.rest()), basis);
}

/// The simulation fit when the sum of squares is what it is to be expected to be.
std::optional<double> expectedPercent(const GivenModel& model, const ValidationContrast& contrast,
                                      const AutoregressiveNoise& noise)
{
    const double fromNoise = noise.coefficients.empty()
                                 ? contrast.variance() * static_cast<double>(contrast.rank())
                                 : spreadUnderNoise(contrast.parameterBasis(), noise).trace();
    const double squares = contrast.rest().squaredNorm() + contrast.fromEstimate().trace() + fromNoise;
    const auto first = static_cast<Eigen::Index>(model.record.firstRow());
    const Eigen::Map<const Eigen::RowVectorXd> all(model.record.position.data(),
                                                   static_cast<Eigen::Index>(model.record.position.size()));
    const Eigen::RowVectorXd position = all.segment(first, model.residual.size());
    const double spread = (position.array() - position.mean()).matrix().squaredNorm();
    const double percent = 100 * (1 - std::sqrt(squares / spread));
    return std::isfinite(percent) ? std::optional(percent) : std::nullopt;
}

std::optional<double> inputP(const GivenModel& model, const ValidationContrast& contrast,
                             const AutoregressiveNoise& noise)
{
    const std::ptrdiff_t first = model.record.firstRow() + model.record.lag.samples;
    const Eigen::MatrixXd past = pastInputs(model.record.force, first, model.residual.size());
    const OrthonormalRows extra = orthonormalize(whitened(past, noise), contrast.nuisanceBasis());
    const auto test = testExplained(contrast.standardized(), contrast.nuisanceBasis(), extra.basis);
    return test ? std::optional(test->p) : std::nullopt;
}

void setChange(const ValidationContrast& contrast, Validation& out)
{
    const std::optional<ValidationContrast::Change> found = contrast.change();
    if (!found || found->step.head(3).cwiseAbs().maxCoeff() > longestChange)
        return;
    out.change = found->step.head(3).array().exp() - 1;
    out.changeErrors = found->errors.head(3);
}

Finding changeWords(const Validation& validation)
{
    if (!validation.change)
        return {};
    static constexpr std::array<const char*, 3> names{"m", "b", "k"};
    Findings parts;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double percent = 100 * (*validation.change)(static_cast<Eigen::Index>(i));
        parts.push_back(Words::say("%1 by %2%3 %")
                            .arg(QString::fromLatin1(names[i]), percent < 0 ? u"\u2212"_s : u"+"_s,
                                 Finding::number(std::abs(percent), 'g', 2)));
    }
    return Words::say(": to explain it best, %1 would have to change").arg(Finding::joined(parts, u", "_s));
}

void conclude(Validation& out)
{
    const bool parametersHold = out.misfitP && *out.misfitP >= validationLimit;
    const bool complete = !out.inputIndependenceP || *out.inputIndependenceP >= validationLimit;
    out.asExpected = parametersHold && complete;
    if (*out.asExpected) {
        out.message = Words::say("the misfit is no larger than noise and the errors of m, b and k explain");
        if (out.whitenessP && *out.whitenessP < certainlyColoured)
            out.message +=
                Words::say(", though it is not white: slow noise, or a term that is missing here and there "
                           "alike");
    } else if (!parametersHold) {
        out.message = Words::say("the model misses by more than noise and the errors of m, b and k explain") +
                      changeWords(out);
    } else {
        out.message =
            Words::say("m, b and k hold here too, but the residuals still follow the force: the object does "
                       "something that the model does not");
    }
}

void judge(const Estimate& estimate, const GivenModel& model, const Eigen::MatrixXd& covariance,
           Validation& out)
{
    const ValidationContrast raw(model, {}, covariance);
    if (!raw.usable()) {
        out.message =
            Words::say("this record does not tell m, b and k, so that the misfit could not be judged");
        return;
    }
    const AutoregressiveNoise noise = noiseOf(raw);
    const ValidationContrast white(model, noise, covariance);
    if (!white.usable()) {
        out.message = Words::say("the noise of this record could not be told from the misfit");
        return;
    }
    const Eigen::RowVectorXd standardized = raw.standardized();
    out.whitenessP = ljungBoxP(rowSpan(standardized), 0, raw.nuisanceBasis());
    out.inputIndependenceP = inputP(model, white, noise);
    const ExplainedTest test = white.test(estimate.residuals.degreesOfFreedom);
    out.misfitP = test.p;
    out.misfit = std::sqrt(test.f);
    out.expectedPercent = expectedPercent(model, raw, noise);
    if (!noise.coefficients.empty()) {
        const std::vector<double> steps = whitened(std::span<const double>(out.residual), noise);
        std::vector<double> predicted(out.position);
        for (std::size_t i = 0; i < predicted.size(); ++i)
            predicted[i] -= steps[i];
        out.fit.predictionPercent = fitPercent(out.position, predicted);
    }
    setChange(white, out);
    conclude(out);
}

void keepRecord(const PreparedRecord& record, const GivenModel& model, Validation& out)
{
    out.nuisance = model.nuisance;
    out.force = record.force;
    out.position = record.position;
    out.simulated = model.simulated;
    out.residual.resize(out.position.size());
    for (std::size_t i = 0; i < out.residual.size(); ++i)
        out.residual[i] = out.position[i] - out.simulated[i];
    const auto first = static_cast<std::size_t>(model.record.firstRow());
    const auto rows = static_cast<std::size_t>(model.record.rows());
    out.fit.simulationPercent = fitPercent(std::span<const double>(out.position).subspan(first, rows),
                                           std::span<const double>(out.simulated).subspan(first, rows));
    out.fit.predictionPercent = out.fit.simulationPercent;
}

constexpr double firstShare = 0.6;
constexpr std::size_t shortestRecord = 100, longestRecord = 100'000;

/// How many of `to` are in one of `from`; nothing where that is not known.
std::optional<double> quotient(const QString& from, const QString& to,
                               std::optional<double> (*base)(const QString&))
{
    if (from == to)
        return 1;
    const std::optional<double> one = base(from);
    const std::optional<double> other = base(to);
    return one && other ? std::optional(*one / *other) : std::nullopt;
}

void scale(std::vector<double>& values, double factor)
{
    if (factor == 1)
        return;
    for (double& value : values)
        value *= factor;
}

bool usable(const PreparedRecord& record)
{
    return record.force.size() == record.position.size() && std::isfinite(record.sampleTime_s) &&
           record.sampleTime_s > 0 && std::isfinite(record.forceLag_s) && allFinite(record.force) &&
           allFinite(record.position);
}

} // namespace

QString toString(ValidationSource source)
{
    return source == ValidationSource::SecondWindow ? u"second_window"_s : u"other_recording"_s;
}

Validation validate(const Estimate& estimate, const PreparedRecord& record, ForceHold hold)
{
    Validation out;
    out.estimator = estimate.estimator;
    out.validatedOn = longestKnownStretch(record.force.size(), record.lost);
    if (!estimate.parameters) {
        out.message = estimate.isPartialMotion()
                          ? Words::say("not judged: what was found has no m, b and k to predict with")
                          : Words::say("there is no estimate to hold against this record");
        return out;
    }
    out.parameters = *estimate.parameters;
    const MotionEstimate motion = *motionOf(estimate);
    if (motion.terms.cubic)
        out.k3 = motion.values[MotionParameter::Cubic];
    if (out.validatedOn.count < fewestRecordSamples || record.position.size() != record.force.size()) {
        out.message = Words::say("too few samples without a loss to hold a model against");
        return out;
    }
    const PreparedRecord part = windowOf(record, out.validatedOn);
    const std::optional<GivenModel> model = applyGivenModel(motion.terms, motion.values, part, hold);
    if (!model) {
        out.message = Words::say("with these parameters the motion leaves all bounds here");
        return out;
    }
    keepRecord(part, *model, out);
    if (record.time_s.size() == record.force.size()) {
        const auto first = record.time_s.begin() + static_cast<std::ptrdiff_t>(out.validatedOn.first);
        out.time_s.assign(first, first + static_cast<std::ptrdiff_t>(out.validatedOn.count));
    }
    const std::optional<Eigen::MatrixXd> covariance = covarianceOfLogarithms(motion);
    const double size =
        Eigen::Map<const Eigen::VectorXd>(model->record.position.data(),
                                          static_cast<Eigen::Index>(model->record.position.size()))
            .norm();
    if (!(model->residual.norm() > roundingShare * size)) {
        out.asExpected = true;
        out.message = Words::say("the model explains this record to the last digit");
    } else if (estimate.estimator == Estimator::Periodic) {
        out.message =
            Words::say("not judged: the estimate is for a force that answers to the position, which a "
                       "simulation from the measured force cannot judge");
    } else if (!covariance) {
        out.message = Words::say("not judged: the estimate has no errors to compare the misfit with");
    } else {
        judge(estimate, *model, *covariance, out);
    }
    return out;
}

Validation validateOnSecondWindow(Estimator estimator, const PreparedRecord& record,
                                  const EstimatorTask& task)
{
    Validation none;
    none.estimator = estimator;
    const std::size_t count = std::min(record.force.size(), longestRecord);
    if (count < shortestRecord) {
        none.message =
            Words::say("fewer than %1 samples are too few to estimate on one part and check on the other; "
                       "validate with another squeeze")
                .arg(shortestRecord);
        return none;
    }
    const auto first = static_cast<std::size_t>(firstShare * static_cast<double>(count));
    EstimatorTask onFirstPart = task;
    onFirstPart.residuals = ResidualDepth::Noise;
    const Estimate estimate = runEstimator(estimator, windowOf(record, {0, first}), onFirstPart);
    if (estimate.status != EstimateStatus::Converged) {
        none.message =
            Words::say("the first 60 % of the record alone do not give m, b and k; validate with another "
                       "squeeze");
        return none;
    }
    PreparedRecord rest = windowOf(record, {first, count - first});
    if (record.time_s.size() >= count)
        rest.time_s.assign(record.time_s.begin() + static_cast<std::ptrdiff_t>(first),
                           record.time_s.begin() + static_cast<std::ptrdiff_t>(count));
    Validation validation = validate(estimate, rest, task.hold);
    validation.estimatedOn = {estimate.part.first, estimate.part.count};
    validation.validatedOn.first += first;
    return validation;
}

Validation validateOnRecording(const Estimate& estimate, const Recording& recording, const Recording& other,
                               const QString& name, std::optional<ForceHold> hold)
{
    Validation none;
    none.estimator = estimate.estimator;
    none.source = ValidationSource::OtherRecording;
    none.name = name;
    const std::optional<double> force = quotient(other.forceUnit, recording.forceUnit, newtonsPer);
    const std::optional<double> position = quotient(other.positionUnit, recording.positionUnit, metresPer);
    if (!force || !position) {
        none.message =
            Words::say("the other recording is in %1 and %2, which cannot be compared with %3 and %4")
                .arg(other.forceUnit, other.positionUnit, recording.forceUnit, recording.positionUnit);
        return none;
    }
    PreparationOptions preparation;
    preparation.hold = hold;
    PreparedRecord record = prepare(other, preparation);
    if (!usable(record)) {
        none.message =
            Words::say("the other recording cannot be used: its channels differ in length or hold values "
                       "that are no numbers");
        return none;
    }
    scale(record.force, *force);
    scale(record.position, *position);
    Validation validation = validate(estimate, record, hold.value_or(other.hold.value_or(ForceHold::First)));
    validation.source = none.source;
    validation.name = name;
    validation.estimatedOn = estimate.part;
    return validation;
}

} // namespace gripscope
