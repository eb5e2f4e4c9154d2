// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/live_chart.h"

#include "core/base/words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

ChartPoint pointBetween(double value, double lower, double upper)
{
    ChartPoint point{value, lower, upper, 0, 0, 0};
    point.rules = value < lower || value > upper ? 1 : 0;
    return point;
}

} // namespace

QString toString(ChartKind kind)
{
    switch (kind) {
    case ChartKind::Individuals:
        return u"i-mr"_s;
    case ChartKind::MeanRange:
        return u"xbar-r"_s;
    case ChartKind::MeanDeviation:
        return u"xbar-s"_s;
    case ChartKind::Ewma:
        return u"ewma"_s;
    case ChartKind::Cusum:
        return u"cusum"_s;
    }
    return {};
}

std::optional<Error> ChartSetting::validate() const
{
    const auto wrong = [](const Finding& sentence) { return Error{ErrorCode::Usage, {sentence}}; };
    if (!std::isfinite(centre))
        return wrong(Words::say("The centre of a chart must be a finite number."));
    if (!(sigma > 0) || !std::isfinite(sigma))
        return wrong(Words::say("The sigma of a chart must be above 0."));
    if (!(size >= 1) || !std::isfinite(size))
        return wrong(Words::say("A subgroup has at least one value."));
    if (kind == ChartKind::Ewma && !(weight > 0 && weight <= 1))
        return wrong(Words::say("The weight lambda of an EWMA chart must be above 0 and at most 1."));
    if (kind == ChartKind::Ewma && !(width > 0 && std::isfinite(width)))
        return wrong(Words::say("The width of an EWMA chart's limits must be above 0."));
    if (kind == ChartKind::Cusum && !(reference >= 0 && std::isfinite(reference)))
        return wrong(Words::say("The reference value k of a CUSUM chart must not be below 0."));
    if (kind == ChartKind::Cusum && !(decision > 0 && std::isfinite(decision)))
        return wrong(Words::say("The decision interval h of a CUSUM chart must be above 0."));
    return {};
}

Expected<LiveChart> LiveChart::of(const ChartSetting& setting)
{
    RETURN_IF_ERROR(setting.validate());
    return LiveChart(setting);
}

Expected<ChartStep> LiveChart::add(std::span<const double> subgroup)
{
    if (subgroup.empty() || (subgroup.size() > 1 && m_setting.kind == ChartKind::Individuals))
        return failure(ErrorCode::BadInput,
                       {Words::say("A subgroup"), Words::say("it has %1 values").arg(subgroup.size()),
                        m_setting.kind == ChartKind::Individuals
                            ? Words::say("a chart of individuals takes one at a time; take xbar-r or xbar-s")
                            : Words::say("at least one was expected")});
    if (!std::all_of(subgroup.begin(), subgroup.end(), [](double value) { return std::isfinite(value); }))
        return failure(ErrorCode::BadInput,
                       {Words::say("A value for the chart"), Words::say("it is missing or not finite"),
                        Words::say("leave it out, or measure it again")});
    const SubgroupSummary summary =
        subgroup.size() == 1 ? SubgroupSummary{1, subgroup.front(), 0, 0} : summaryOf(subgroup);
    ChartStep step{location(summary), spread(summary)};
    m_last = summary.mean;
    return step;
}

ChartPoint LiveChart::location(const SubgroupSummary& summary)
{
    const double deviation = m_setting.sigma / std::sqrt(double(summary.size));
    switch (m_setting.kind) {
    case ChartKind::Individuals:
    case ChartKind::MeanRange:
    case ChartKind::MeanDeviation:
        return shewhart(summary.mean, deviation);
    case ChartKind::Ewma:
        return movingAverage(summary.mean, deviation);
    case ChartKind::Cusum:
        return sums(summary.mean, deviation);
    }
    return {};
}

ChartPoint LiveChart::shewhart(double mean, double deviation)
{
    ChartPoint point{mean, m_setting.centre - 3 * deviation, m_setting.centre + 3 * deviation, 0, 0, 0};
    point.rules = m_watch.add((mean - m_setting.centre) / deviation);
    return point;
}

ChartPoint LiveChart::movingAverage(double mean, double deviation)
{
    const double weight = m_setting.weight;
    m_average = weight * mean + (1 - weight) * m_average;
    m_averageVariance =
        weight * weight * deviation * deviation + (1 - weight) * (1 - weight) * m_averageVariance;
    const double half = m_setting.width * std::sqrt(m_averageVariance);
    return pointBetween(m_average, m_setting.centre - half, m_setting.centre + half);
}

ChartPoint LiveChart::sums(double mean, double deviation)
{
    const double z = (mean - m_setting.centre) / deviation;
    m_upperSum = std::max(0.0, m_upperSum + z - m_setting.reference);
    m_lowerSum = std::max(0.0, m_lowerSum - z - m_setting.reference);
    const double unit = m_setting.sigma / std::sqrt(m_setting.size);
    const double limit = m_setting.decision * unit;
    return {mean,
            -limit,
            limit,
            m_upperSum * unit,
            m_lowerSum * unit,
            RuleSet(std::max(m_upperSum, m_lowerSum) > m_setting.decision ? 1 : 0)};
}

std::optional<ChartPoint> LiveChart::spread(const SubgroupSummary& summary)
{
    const double sigma = m_setting.sigma;
    if (m_setting.kind == ChartKind::Individuals) {
        if (!m_last)
            return {};
        const ChartConstants& of = constants(2);
        return pointBetween(std::abs(summary.mean - *m_last), of.D1() * sigma, of.D2() * sigma);
    }
    if (summary.size < 2)
        return {};
    if (m_setting.kind == ChartKind::MeanRange) {
        const ChartConstants& of = constants(summary.size);
        return pointBetween(summary.range, of.D1() * sigma, of.D2() * sigma);
    }
    if (m_setting.kind == ChartKind::MeanDeviation) {
        const ChartConstants& of = constants(summary.size);
        return pointBetween(summary.deviation, of.B5() * sigma, of.B6() * sigma);
    }
    return {};
}

const ChartConstants& LiveChart::constants(std::size_t size)
{
    const auto place = m_constants.try_emplace(size);
    if (place.second)
        place.first->second = chartConstants(int(size));
    return place.first->second;
}

} // namespace gripscope
