// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <span>
#include <vector>

namespace gripscope {

/// Which rows of a table are measured together.
class SubgroupLayout {
public:
    /// Rows one after another, `size` at a time; the last subgroup may be smaller. Usage: a size below 1.
    [[nodiscard]] static Expected<SubgroupLayout> consecutive(std::size_t rows, std::size_t size);
    /// Rows with the same label, wherever they stand, in the order of each label's first row. `labels` are
    /// places from 0 in a list of `count` (StudyLabels).
    [[nodiscard]] static SubgroupLayout labelled(std::span<const int> labels, std::size_t count);

    [[nodiscard]] std::size_t subgroups() const { return m_begins.size() - 1; }
    [[nodiscard]] std::size_t size(std::size_t subgroup) const
    {
        return m_begins[subgroup + 1] - m_begins[subgroup];
    }
    [[nodiscard]] std::size_t rows() const { return m_begins.back(); }
    [[nodiscard]] std::size_t largest() const;
    [[nodiscard]] std::size_t smallest() const;
    /// Where the subgroup's rows begin in order().
    [[nodiscard]] std::size_t begin(std::size_t subgroup) const { return m_begins[subgroup]; }
    /// The first so many of them.
    [[nodiscard]] SubgroupLayout first(std::size_t subgroups) const;
    /// The rows of the table, subgroup by subgroup; empty where that is how they stand.
    [[nodiscard]] const std::vector<std::size_t>& order() const { return m_order; }

private:
    std::vector<std::size_t> m_begins{0}; ///< and where the last one ends
    std::vector<std::size_t> m_order;
};

/// Values by subgroups.
struct Subgroups {
    SubgroupLayout layout;
    std::vector<double> values; ///< subgroup by subgroup

    /// BadInput: another number of values than the layout has rows, none, or one that is not finite.
    [[nodiscard]] static Expected<Subgroups> of(const SubgroupLayout& layout, std::span<const double> values);

    [[nodiscard]] std::size_t count() const { return layout.subgroups(); }
    [[nodiscard]] std::span<const double> operator[](std::size_t subgroup) const
    {
        return {values.data() + layout.begin(subgroup), layout.size(subgroup)};
    }
    [[nodiscard]] Subgroups first(std::size_t subgroups) const;
};

/// Mean, range and standard deviation (n - 1) of a few values, as sampleMoments() has them. Range and
/// deviation are 0 for one value.
struct SubgroupSummary {
    std::size_t size = 0;
    double mean = 0, range = 0, deviation = 0;
};
[[nodiscard]] SubgroupSummary summaryOf(std::span<const double> values);

} // namespace gripscope
