// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sensor_calibration.h"

#include "core/base/words.h"
#include "core/calibration/sensor_correction.h"
#include "core/math/distributions.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double confidence = 0.95;

double coverageFactor(double degreesOfFreedom)
{
    constexpr double asGoodAsInfinite = 1e6;
    return studentQuantile((1 + confidence) / 2, std::clamp(degreesOfFreedom, 1.0, asGoodAsInfinite));
}

/// The curve's slope there, from a difference that is exact for straight lines and good enough for others.
double slopeAt(const CalibrationCurve& curve, double load)
{
    const double range = curve.largestLoad() - curve.leastLoad();
    const double step = 1e-4 * range;
    const double from = std::clamp(load - step, curve.leastLoad(), curve.largestLoad());
    const double to = std::clamp(load + step, curve.leastLoad(), curve.largestLoad());
    return (curve.readingAt(to) - curve.readingAt(from)) / (to - from);
}

/// An expanded uncertainty, and by what factor it is more than the standard one.
struct Coverage {
    double expanded = 0, factor = 0;
};

Coverage coverageAt(const CalibrationEvaluation& evaluation, const CalibrationReference& reference,
                    double load)
{
    const CalibrationCurve& curve = evaluation.curve;
    const double slope = std::abs(slopeAt(curve, load));
    const double scatter = std::hypot(curve.residualDeviation(), curve.curveUncertaintyAt(load)) / slope;
    const double fullScale =
        std::abs(curve.readingAt(curve.largestLoad()) - curve.readingAt(curve.leastLoad()));
    const double zero =
        std::abs(evaluation.figures.zeroReturnPercent.value_or(0)) / 100 * fullScale / slope / std::sqrt(3.0);
    const double known =
        std::hypot(reference.standardUncertainty, reference.relativeUncertainty * load, zero);
    const double standard = std::hypot(scatter, known);
    if (!(standard > 0))
        return {};
    const double degrees = scatter > 0 ? curve.degreesOfFreedom() * std::pow(standard / scatter, 4) : 1e9;
    const double factor = coverageFactor(degrees);
    return {factor * standard, factor};
}

/// The largest in the range.
Coverage largestCoverage(const CalibrationEvaluation& evaluation, const CalibrationReference& reference)
{
    const CalibrationCurve& curve = evaluation.curve;
    constexpr int places = 100;
    Coverage largest;
    for (int i = 0; i <= places; ++i) {
        const double load =
            curve.leastLoad() + (curve.largestLoad() - curve.leastLoad()) * i / static_cast<double>(places);
        if (const Coverage there = coverageAt(evaluation, reference, load); there.expanded > largest.expanded)
            largest = there;
    }
    return largest;
}

/// Where the curve rises less than a twentieth of its mean a load can hardly be told; nothing where it does
/// not.
std::optional<double> levelPlace(const CalibrationCurve& curve)
{
    const double range = curve.largestLoad() - curve.leastLoad();
    const double mean = (curve.readingAt(curve.largestLoad()) - curve.readingAt(curve.leastLoad())) / range;
    constexpr int places = 100;
    for (int i = 0; i <= places; ++i) {
        const double load = curve.leastLoad() + range * i / places;
        if (slopeAt(curve, load) / mean < 0.05)
            return load;
    }
    return std::nullopt;
}

/// Of the mean slope, from the uncertainty of the two ends.
double relativeSlopeUncertainty(const CalibrationCurve& curve)
{
    const double span = std::abs(curve.readingAt(curve.largestLoad()) - curve.readingAt(curve.leastLoad()));
    return std::hypot(curve.curveUncertaintyAt(curve.leastLoad()),
                      curve.curveUncertaintyAt(curve.largestLoad())) /
           span;
}

/// Without a correction the reading is what the gripper says.
LoadErrors errorsOf(const std::vector<CalibrationPoint>& points, const SensorCorrection* correction)
{
    LoadErrors errors;
    errors.each.reserve(points.size());
    for (const CalibrationPoint& point : points) {
        const double said = correction ? correction->loadOf(point.reading) : point.reading;
        errors.each.push_back(said - point.load);
        errors.largest = std::max(errors.largest, std::abs(errors.each.back()));
    }
    return errors;
}

} // namespace

QString toString(SensorChannel channel)
{
    return channel == SensorChannel::Force ? u"force"_s : u"position"_s;
}

std::optional<SensorChannel> sensorChannelFromString(const QString& text)
{
    for (const SensorChannel channel : {SensorChannel::Force, SensorChannel::Position})
        if (toString(channel) == text)
            return channel;
    return std::nullopt;
}

double expandedUncertaintyAt(const CalibrationEvaluation& evaluation, const CalibrationReference& reference,
                             double load)
{
    return coverageAt(evaluation, reference, load).expanded;
}

Expected<CalibrationEvaluation> evaluateCalibration(const SensorCalibration& calibration)
{
    const CalibrationReference& reference = calibration.reference;
    for (const double uncertainty : {reference.standardUncertainty, reference.relativeUncertainty})
        if (!std::isfinite(uncertainty) || uncertainty < 0)
            return failure(ErrorCode::BadInput,
                           {Words::say("the reference"),
                            Words::say("found an uncertainty of %1").arg(uncertainty),
                            Words::say("expected zero or more, as its certificate states it")});
    ASSIGN_OR_RETURN(CalibrationCurve curve, CalibrationCurve::fit(calibration.points, calibration.degree));
    if (const std::optional<double> level = levelPlace(curve))
        return failure(
            ErrorCode::BadInput,
            {Words::say("calibration points"),
             Words::say("the curve is nearly level at a load of %1").arg(*level),
             Words::say("loads cannot be told there: choose a lower degree or look at the points")});
    CalibrationEvaluation evaluation;
    evaluation.curve = std::move(curve);
    evaluation.figures = calibrationFigures(evaluation.curve, calibration.points);
    evaluation.residuals.reserve(calibration.points.size());
    for (const CalibrationPoint& point : calibration.points)
        evaluation.residuals.push_back(point.reading - evaluation.curve.readingAt(point.load));
    const Coverage largest = largestCoverage(evaluation, reference);
    evaluation.expandedUncertainty = largest.expanded;
    evaluation.coverageFactor = largest.factor;
    evaluation.scaleUncertainty =
        std::hypot(relativeSlopeUncertainty(evaluation.curve), reference.relativeUncertainty);
    return evaluation;
}

std::optional<LoadErrors> errorsAsFound(const SensorCalibration& calibration)
{
    if (!calibration.foundCorrection)
        return std::nullopt;
    if (calibration.foundCorrection->isEmpty())
        return errorsOf(calibration.points, nullptr);
    const std::optional<SensorCorrection> before = SensorCorrection::fromText(*calibration.foundCorrection);
    return before ? std::optional(errorsOf(calibration.points, &*before)) : std::nullopt;
}

LoadErrors errorsAsLeft(const SensorCalibration& calibration, const CalibrationEvaluation& evaluation)
{
    const SensorCorrection correction(evaluation.curve);
    return errorsOf(calibration.checkPoints.empty() ? calibration.points : calibration.checkPoints,
                    &correction);
}

CalibrationConformity judgeConformity(double largestError, double expandedUncertainty, double tolerance,
                                      DecisionRule rule)
{
    const double guard = rule == DecisionRule::Guarded ? expandedUncertainty : 0;
    if (largestError + guard <= tolerance)
        return CalibrationConformity::Conforms;
    return largestError - guard > tolerance ? CalibrationConformity::DoesNotConform
                                            : CalibrationConformity::Undecided;
}

CalibrationStatus calibrationStatus(const std::optional<QDate>& due, const QDate& today)
{
    if (!due || !due->isValid())
        return CalibrationStatus::Missing;
    if (*due < today)
        return CalibrationStatus::Overdue;
    return today.daysTo(*due) <= dueSoonDays ? CalibrationStatus::DueSoon : CalibrationStatus::Valid;
}

} // namespace gripscope
