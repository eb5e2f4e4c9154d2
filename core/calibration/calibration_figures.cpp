// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_figures.h"

#include "core/base/json_value.h"
#include "core/math/distributions.h"

#include <QJsonArray>

#include <algorithm>
#include <cmath>
#include <map>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Readings of one load.
struct Group {
    std::vector<double> readings;

    [[nodiscard]] double mean() const
    {
        double sum = 0;
        for (const double reading : readings)
            sum += reading - readings.front();
        return readings.front() + sum / static_cast<double>(readings.size());
    }
    [[nodiscard]] double squares() const
    {
        const double middle = mean();
        double sum = 0;
        for (const double reading : readings)
            sum += (reading - middle) * (reading - middle);
        return sum;
    }
};
using Groups = std::map<double, Group>; ///< by load

struct Scatter {
    double squares = 0;
    int degreesOfFreedom = 0;

    void add(const Groups& groups)
    {
        for (const auto& [load, group] : groups) {
            squares += group.squares();
            degreesOfFreedom += static_cast<int>(group.readings.size()) - 1;
        }
    }
};

struct Directions {
    Groups up, down;
};
Directions directionsOf(const std::vector<CalibrationPoint>& points)
{
    const std::vector<bool> ascending = ascendingPoints(points);
    Directions directions;
    for (std::size_t i = 0; i < points.size(); ++i)
        (ascending[i] ? directions.up : directions.down)[points[i].load].readings.push_back(
            points[i].reading);
    return directions;
}

double linearity(const CalibrationCurve& curve)
{
    const double least = curve.leastLoad(), largest = curve.largestLoad();
    const double first = curve.readingAt(least), last = curve.readingAt(largest);
    constexpr int places = 1000;
    double distance = 0;
    for (int i = 1; i < places; ++i) {
        const double share = static_cast<double>(i) / places;
        const double straight = first + share * (last - first);
        const double load = least + share * (largest - least);
        distance = std::max(distance, std::abs(curve.readingAt(load) - straight));
    }
    return distance;
}

std::optional<double> reversibility(const Directions& directions)
{
    std::optional<double> largest;
    for (const auto& [load, up] : directions.up) {
        const auto down = directions.down.find(load);
        if (down != directions.down.end())
            largest = std::max(largest.value_or(0), std::abs(up.mean() - down->second.mean()));
    }
    return largest;
}

std::optional<double> zeroReturn(const CalibrationCurve& curve, const std::vector<CalibrationPoint>& points)
{
    const CalibrationPoint& first = points.front();
    const CalibrationPoint& last = points.back();
    if (first.load != last.load || first.load > curve.leastLoad())
        return std::nullopt;
    return last.reading - first.reading;
}

std::optional<double> lackOfFit(const CalibrationCurve& curve, const std::vector<CalibrationPoint>& points)
{
    Groups all;
    for (const CalibrationPoint& point : points)
        all[point.load].readings.push_back(point.reading);
    Scatter pure;
    pure.add(all);
    const int missing = curve.degreesOfFreedom() - pure.degreesOfFreedom;
    if (pure.degreesOfFreedom < 1 || missing < 1 || !(pure.squares > 0))
        return std::nullopt;
    const double whole = std::pow(curve.residualDeviation(), 2) * curve.degreesOfFreedom();
    const double ratio =
        (std::max(whole - pure.squares, 0.0) / missing) / (pure.squares / pure.degreesOfFreedom);
    if (!std::isfinite(ratio))
        return std::nullopt;
    return fisherAbove(ratio, missing, pure.degreesOfFreedom);
}

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

struct Sum {
    double of = 0;
    int count = 0;
    [[nodiscard]] std::optional<double> mean() const
    {
        return count > 0 ? std::optional(of / count) : std::nullopt;
    }
};

} // namespace

std::vector<bool> ascendingPoints(const std::vector<CalibrationPoint>& points)
{
    const auto turn = std::adjacent_find(points.begin(), points.end(),
                                         [](const auto& a, const auto& b) { return a.load != b.load; });
    bool rising = turn == points.end() || (turn + 1)->load > turn->load;
    std::vector<bool> ascending;
    ascending.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0 && points[i].load != points[i - 1].load)
            rising = points[i].load > points[i - 1].load;
        ascending.push_back(rising);
    }
    return ascending;
}

std::vector<UpAndDown> upAndDown(const std::vector<CalibrationPoint>& points)
{
    const std::vector<bool> ascending = ascendingPoints(points);
    std::map<double, std::pair<Sum, Sum>> loads;
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto& [up, down] = loads[points[i].load];
        Sum& sum = ascending[i] ? up : down;
        sum.of += points[i].reading;
        ++sum.count;
    }
    std::vector<UpAndDown> rows;
    rows.reserve(loads.size());
    for (const auto& [load, sums] : loads)
        rows.push_back({load, sums.first.mean(), sums.second.mean()});
    return rows;
}

CalibrationFigures calibrationFigures(const CalibrationCurve& curve,
                                      const std::vector<CalibrationPoint>& points)
{
    CalibrationFigures figures;
    const double fullScale =
        std::abs(curve.readingAt(curve.largestLoad()) - curve.readingAt(curve.leastLoad()));
    const auto percent = [fullScale](double value) { return 100 * value / fullScale; };
    figures.linearityPercent = percent(linearity(curve));
    const Directions directions = directionsOf(points);
    Scatter repeated;
    repeated.add(directions.up);
    repeated.add(directions.down);
    figures.repeatabilityDegreesOfFreedom = repeated.degreesOfFreedom;
    if (repeated.degreesOfFreedom > 0) {
        figures.repeatability = std::sqrt(repeated.squares / repeated.degreesOfFreedom);
        figures.repeatabilityPercent = percent(*figures.repeatability);
    }
    if (const std::optional<double> difference = reversibility(directions))
        figures.reversibilityPercent = percent(*difference);
    if (const std::optional<double> difference = zeroReturn(curve, points))
        figures.zeroReturnPercent = percent(*difference);
    figures.lackOfFitProbability = lackOfFit(curve, points);
    return figures;
}

QJsonObject loadFromReadingJson(const CalibrationCurve& curve, const std::vector<double>& readings)
{
    const double first = curve.readingAt(curve.leastLoad()), last = curve.readingAt(curve.largestLoad());
    const double factor = studentQuantile(0.975, curve.degreesOfFreedom());
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
