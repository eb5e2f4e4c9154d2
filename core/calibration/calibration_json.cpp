// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_json.h"

#include "core/identification/json_number.h"

#include <QJsonArray>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonArray array(const Eigen::VectorXd& values)
{
    QJsonArray out;
    for (const double value : values)
        out.append(value);
    return out;
}

QJsonObject figuresJson(const CalibrationFigures& figures)
{
    return {{u"linearity_percent"_s, jsonNumber(figures.linearityPercent)},
            {u"repeatability_percent"_s, jsonNumber(figures.repeatabilityPercent)},
            {u"repeatability"_s, jsonNumber(figures.repeatability)},
            {u"repeatability_degrees_of_freedom"_s, figures.repeatabilityDegreesOfFreedom},
            {u"reversibility_percent"_s, jsonNumber(figures.reversibilityPercent)},
            {u"zero_return_percent"_s, jsonNumber(figures.zeroReturnPercent)},
            {u"lack_of_fit_p"_s, jsonNumber(figures.lackOfFitProbability)}};
}

} // namespace

QJsonObject loadFromReadingJson(const CalibrationCurve& curve, const std::vector<double>& readings)
{
    const double first = curve.readingAt(curve.leastLoad()), last = curve.readingAt(curve.largestLoad());
    const boost::math::students_t student(curve.degreesOfFreedom());
    const double factor = boost::math::quantile(student, 0.975);
    QJsonArray table;
    for (const double reading : readings) {
        const std::optional<LoadEstimate> found = curve.loadAt(reading);
        const auto times = [&](double scale) {
            return found ? std::optional(scale * found->standardUncertainty) : std::nullopt;
        };
        table.append(QJsonObject{{u"reading"_s, jsonNumber(reading)},
                                 {u"load"_s, jsonNumber(found ? std::optional(found->load) : std::nullopt)},
                                 {u"standard_uncertainty"_s, jsonNumber(times(1))},
                                 {u"expanded_uncertainty"_s, jsonNumber(times(factor))}});
    }
    return {{u"method"_s, u"root of the curve within the range"_s},
            {u"reading_range"_s, QJsonArray{std::min(first, last), std::max(first, last)}},
            {u"coverage_factor"_s, factor},
            {u"values"_s, table}};
}

QJsonObject calibrationJson(const CalibrationCurve& curve, const std::vector<CalibrationPoint>& points,
                            const std::vector<double>& readings)
{
    const QJsonObject direct{{u"coefficients"_s, array(curve.coefficients())},
                             {u"standard_deviations"_s, array(curve.standardDeviations())},
                             {u"residual_deviation"_s, curve.residualDeviation()},
                             {u"degrees_of_freedom"_s, curve.degreesOfFreedom()},
                             {u"load_range"_s, QJsonArray{curve.leastLoad(), curve.largestLoad()}}};
    return {{u"points"_s, static_cast<qint64>(points.size())},
            {u"degree"_s, curve.degree()},
            {u"reading_from_load"_s, direct},
            {u"load_from_reading"_s, loadFromReadingJson(curve, readings)},
            {u"figures"_s, figuresJson(calibrationFigures(curve, points))}};
}

} // namespace gripscope
