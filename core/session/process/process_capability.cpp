// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/sorted_values.h"
#include "core/session/process/process_chart.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double doubtfulNormality = 0.05;    // as studyCapability() says it
constexpr std::size_t percentilesTell = 1000; // see studyPercentileCapability()

/// 1, 2 or 5 times a power of ten, not below `least`.
double roundWidth(double least)
{
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least)
            return factor * power;
    return 10 * power;
}

void findAnotherWay(ProcessCapability& found, const Subgroups& groups, std::span<const double> sorted,
                    const CapabilityOptions& options, SharedRanks& ranks)
{
    const std::optional<NormalityTest>& test = found.normal->normality;
    if (!test || test->p >= doubtfulNormality)
        return;
    if (groups.values.size() < percentilesTell)
        if (auto power = studyBoxCoxCapability(groups, options);
            power && power->capability.normality && power->capability.normality->p >= doubtfulNormality) {
            found.boxCox = *std::move(power);
            return;
        }
    PercentileOptions percentiles;
    percentiles.limits = options.limits;
    percentiles.confidence = options.confidence;
    const auto drawn = ranks.of(sorted.size(), percentiles);
    if (auto way = studyPercentileCapability(sorted, *drawn, percentiles))
        found.percentiles = *std::move(way);
}

} // namespace

ValueHistogram histogramOf(std::span<const double> values)
{
    ValueHistogram histogram;
    if (values.empty())
        return histogram;
    const auto [low, high] = std::ranges::minmax(values);
    const double span = high - low;
    if (!(span > 0) || !std::isfinite(span)) {
        histogram.width = std::max(1e-12, 1e-3 * std::abs(low));
        histogram.first = low - histogram.width / 2;
        histogram.counts = {qint64(values.size())};
        return histogram;
    }
    const double bars = std::clamp(std::sqrt(double(values.size())), 5.0, 60.0);
    histogram.width = roundWidth(span / bars);
    histogram.first = histogram.width * std::floor(low / histogram.width);
    histogram.counts.assign(std::size_t((high - histogram.first) / histogram.width) + 1, 0);
    for (const double value : values) {
        const auto bar = std::size_t(std::max(0.0, (value - histogram.first) / histogram.width));
        ++histogram.counts[std::min(bar, histogram.counts.size() - 1)];
    }
    return histogram;
}

const CapabilityIndex* ProcessCapability::verdictIndex() const
{
    if (percentiles)
        return &percentiles->nearest;
    if (boxCox)
        return &boxCox->capability.overall.nearest;
    return normal ? &normal->overall.nearest : nullptr;
}

std::shared_ptr<const ResampledRanks> SharedRanks::of(std::size_t count, const PercentileOptions& options)
{
    const std::lock_guard lock(m_mutex);
    std::shared_ptr<const ResampledRanks>& known = m_known[count];
    if (!known)
        known =
            std::make_shared<const ResampledRanks>(resampledRanks(count, options.resamples, options.seed));
    return known;
}

Expected<ProcessCapability> processCapability(const ProcessValues& values, const ProcessRows& rows,
                                              std::size_t quantity, const ProcessOptions& options)
{
    SharedRanks ranks;
    return processCapability(values, rows, quantity, options, ranks);
}

Expected<ProcessCapability> processCapability(const ProcessValues& values, const ProcessRows& rows,
                                              std::size_t quantity, const ProcessOptions& options,
                                              SharedRanks& ranks)
{
    ProcessCapability found;
    found.quantity = quantity;
    found.limits = options.limits[quantity];
    std::vector<double> column;
    column.reserve(rows.size());
    for (const std::uint32_t row : rows)
        if (const double value = values.quantities[quantity][row]; std::isfinite(value))
            column.push_back(value);
    found.histogram = histogramOf(column);
    if (!found.limits)
        return found;
    ASSIGN_OR_RETURN(const SubgroupLayout layout,
                     SubgroupLayout::consecutive(column.size(), std::size_t(std::max(1, options.size()))));
    ASSIGN_OR_RETURN(const Subgroups groups, Subgroups::of(layout, column));
    CapabilityOptions asked;
    asked.limits = *found.limits;
    const std::vector<double> sorted = sortedValues(column);
    ASSIGN_OR_RETURN(found.normal, studyCapability(groups, sorted, asked));
    findAnotherWay(found, groups, sorted, asked, ranks);
    return found;
}

} // namespace gripscope
