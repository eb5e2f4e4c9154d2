// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/math/normal_spread.h"
#include "core/session/quality/study_result.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Counted = std::vector<const StudyMeasurementRecord*>;
constexpr std::array<const char16_t*, 3> quantityColumns{u"m", u"b", u"k"};

/// Places among m, b, k of what every measurement has.
std::vector<std::size_t> determinedByAll(const Counted& counted)
{
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < quantityColumns.size(); ++i)
        if (std::ranges::all_of(counted, [i](const StudyMeasurementRecord* one) {
                return one->measured.values[i].has_value();
            }))
            places.push_back(i);
    return places;
}

Expected<GaugeMeasurements> gaugeMeasurements(const KeptStudy& study, const Counted& counted,
                                              const std::vector<std::size_t>& places)
{
    const StudyTable table = studyTable(study);
    GaugeMeasurements measurements;
    ASSIGN_OR_RETURN(measurements.factors.part, table.labels(u"part"_s));
    if (!study.plan.design.operators.isEmpty()) {
        ASSIGN_OR_RETURN(measurements.factors.operators, table.labels(u"operator"_s));
    }
    if (!study.plan.design.stations.isEmpty()) {
        ASSIGN_OR_RETURN(measurements.factors.station, table.labels(u"station"_s));
    }
    const auto rows = Eigen::Index(counted.size()), columns = Eigen::Index(places.size());
    measurements.values.resize(rows, columns);
    measurements.standardUncertainties.resize(rows, columns);
    bool areUncertaintiesKnown = true;
    for (Eigen::Index column = 0; column < columns; ++column) {
        const std::size_t place = places[std::size_t(column)];
        measurements.names << QString::fromUtf16(quantityColumns[place]);
        for (Eigen::Index row = 0; row < rows; ++row) {
            const StudyValue value = *counted[std::size_t(row)]->measured.values[place];
            measurements.values(row, column) = value.value;
            measurements.standardUncertainties(row, column) = value.standardUncertainty;
            areUncertaintiesKnown = areUncertaintiesKnown && value.standardUncertainty > 0;
        }
    }
    if (!areUncertaintiesKnown)
        measurements.standardUncertainties.resize(0, 0);
    return measurements;
}

GaugeOptions gaugeOptions(const StudyOptions& asked)
{
    GaugeOptions options;
    options.design = GaugeDesign::Crossed; // as every plan is
    options.studyVariation = asked.studyVariation;
    options.pooling = asked.pooling;
    return options;
}

/// A tolerance may be stated for some of the quantities only; studyGauge() takes one for each, or none.
void addTolerances(GaugeStudy& gauge, const StudyOptions& asked, const std::vector<std::size_t>& places)
{
    for (std::size_t i = 0; i < gauge.values.size(); ++i)
        if (const std::optional<double> tolerance = asked.tolerances[places[i]]; tolerance && *tolerance > 0)
            for (VarianceComponent& component : gauge.values[i].components)
                component.percentTolerance =
                    100 * asked.studyVariation * std::sqrt(component.taken) / *tolerance;
}

StudyCell cellOf(int part, int operators, const std::vector<double>& values)
{
    StudyCell cell{part, operators, int(values.size())};
    const auto [least, most] = std::ranges::minmax(values);
    cell.range = most - least;
    for (const double value : values)
        cell.mean += (value - least) / double(values.size()); // about the least: no digits are lost
    cell.mean += least;
    double squares = 0;
    for (const double value : values)
        squares += (value - cell.mean) * (value - cell.mean);
    cell.deviation = values.size() > 1 ? std::sqrt(squares / double(values.size() - 1)) : 0;
    return cell;
}

std::vector<StudyMean> meansBy(int StudyCell::*factor, const std::vector<StudyCell>& cells)
{
    std::map<int, StudyMean> means;
    for (const StudyCell& cell : cells) {
        StudyMean& mean = means[cell.*factor];
        mean.place = cell.*factor;
        mean.count += cell.count;
        mean.mean += (cell.mean - mean.mean) * cell.count / mean.count;
    }
    std::vector<StudyMean> found;
    found.reserve(means.size());
    for (const auto& [place, mean] : means)
        found.push_back(mean);
    return found;
}

void addRangeLimits(QuantitySummary& summary)
{
    for (const StudyCell& cell : summary.cells)
        summary.meanRange += cell.range / double(summary.cells.size());
    const int count = summary.cells.front().count;
    const bool alike =
        std::ranges::all_of(summary.cells, [count](const StudyCell& cell) { return cell.count == count; });
    if (!alike || count < 2)
        return;
    const RangeMoments range = rangeMoments(count);
    const double wide = 3 * range.d3 / range.d2;
    summary.rangeLower = std::max(0.0, 1 - wide) * summary.meanRange;
    summary.rangeUpper = (1 + wide) * summary.meanRange;
}

QuantitySummary summaryOf(const KeptStudy& study, const Counted& counted, std::size_t place)
{
    QuantitySummary summary;
    summary.name = QString::fromUtf16(quantityColumns[place]);
    summary.unit = counted.front()->measured.units[place];
    std::map<std::pair<int, int>, std::vector<double>> values;
    for (const StudyMeasurementRecord* const one : counted) {
        const PlanRow& row = study.plan.rows[std::size_t(one->measured.row)];
        values[{row.part, row.operators}].push_back(one->measured.values[place]->value);
    }
    int count = 0;
    for (const auto& [key, cell] : values) {
        summary.cells.push_back(cellOf(key.first, key.second, cell));
        count += summary.cells.back().count;
        summary.mean += (summary.cells.back().mean - summary.mean) * summary.cells.back().count / count;
    }
    summary.parts = meansBy(&StudyCell::part, summary.cells);
    summary.operators = meansBy(&StudyCell::operators, summary.cells);
    addRangeLimits(summary);
    return summary;
}

bool areUnitsAlike(const Counted& counted)
{
    return std::ranges::all_of(counted, [&](const StudyMeasurementRecord* one) {
        return one->measured.units == counted.front()->measured.units;
    });
}

} // namespace

Expected<GaugeResult> gaugeResult(const KeptStudy& study)
{
    const Counted counted = study.counted();
    const std::vector<std::size_t> places = determinedByAll(counted);
    const Finding what = Words::say("The study %1").arg(study.record.study.name);
    if (counted.empty() || places.empty())
        return failure(ErrorCode::BadInput, {what, Words::say("no quantity that all squeezes determined"),
                                             Words::say("measurements of m, b or k")});
    if (!areUnitsAlike(counted))
        return failure(ErrorCode::BadInput, {what, Words::say("measurements in several units"),
                                             Words::say("measurements in one unit")});
    GaugeResult result;
    ASSIGN_OR_RETURN(const GaugeMeasurements measurements, gaugeMeasurements(study, counted, places));
    ASSIGN_OR_RETURN(result.study, studyGauge(measurements, gaugeOptions(study.options)));
    addTolerances(result.study, study.options, places);
    for (const std::size_t place : places)
        result.quantities.push_back(summaryOf(study, counted, place));
    return result;
}

} // namespace gripscope
