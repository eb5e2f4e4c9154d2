// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/subgroups.h"

#include "core/base/words.h"
#include "core/math/sample_moments.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

Expected<SubgroupLayout> SubgroupLayout::consecutive(std::size_t rows, std::size_t size)
{
    if (size < 1)
        return failure(ErrorCode::Usage, {Words::say("A subgroup has at least one row.")});
    SubgroupLayout layout;
    layout.m_begins.reserve(rows / size + 2);
    for (std::size_t row = 0; row < rows; row += std::min(size, rows - row))
        layout.m_begins.push_back(row + std::min(size, rows - row));
    return layout;
}

SubgroupLayout SubgroupLayout::labelled(std::span<const int> labels, std::size_t count)
{
    SubgroupLayout layout;
    layout.m_begins.assign(count + 1, 0);
    for (const int label : labels)
        ++layout.m_begins[std::size_t(label) + 1];
    for (std::size_t i = 0; i < count; ++i)
        layout.m_begins[i + 1] += layout.m_begins[i];
    if (std::is_sorted(labels.begin(), labels.end()))
        return layout;
    std::vector<std::size_t> next(layout.m_begins.begin(), layout.m_begins.end() - 1);
    layout.m_order.resize(labels.size());
    for (std::size_t row = 0; row < labels.size(); ++row)
        layout.m_order[next[std::size_t(labels[row])]++] = row;
    return layout;
}

std::size_t SubgroupLayout::largest() const
{
    std::size_t found = 0;
    for (std::size_t i = 0; i < subgroups(); ++i)
        found = std::max(found, size(i));
    return found;
}

std::size_t SubgroupLayout::smallest() const
{
    std::size_t found = rows();
    for (std::size_t i = 0; i < subgroups(); ++i)
        found = std::min(found, size(i));
    return found;
}

SubgroupLayout SubgroupLayout::first(std::size_t subgroups) const
{
    SubgroupLayout part;
    part.m_begins.assign(m_begins.begin(), m_begins.begin() + std::ptrdiff_t(subgroups) + 1);
    if (!m_order.empty())
        part.m_order.assign(m_order.begin(), m_order.begin() + std::ptrdiff_t(part.rows()));
    return part;
}

Expected<Subgroups> Subgroups::of(const SubgroupLayout& layout, std::span<const double> values)
{
    if (values.empty() || values.size() != layout.rows())
        return failure(
            ErrorCode::BadInput,
            {Words::say("The values"), Words::say("there are %1").arg(values.size()),
             Words::say("one for each of the %1 rows of the subgroups was expected, and at least one")
                 .arg(layout.rows())});
    Subgroups groups{layout, {values.begin(), values.end()}};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = values[layout.order().empty() ? i : layout.order()[i]];
        if (!std::isfinite(value))
            return failure(ErrorCode::BadInput,
                           {Words::say("Value %1").arg(i + 1), Words::say("it is missing or not finite"),
                            Words::say("leave out its row, or measure it again")});
        groups.values[i] = value;
    }
    return groups;
}

Subgroups Subgroups::first(std::size_t subgroups) const
{
    Subgroups part{layout.first(subgroups), {}};
    part.values.assign(values.begin(), values.begin() + std::ptrdiff_t(part.layout.rows()));
    return part;
}

SubgroupSummary summaryOf(std::span<const double> values)
{
    const SampleMoments moments = sampleMoments(values);
    if (values.empty())
        return {};
    const auto [low, high] = std::ranges::minmax(values);
    return {moments.count, moments.mean, high - low, moments.standardDeviation};
}

} // namespace gripscope
