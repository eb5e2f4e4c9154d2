// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live_history.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {
/// Bins a level keeps: twice the pixels of the widest plot, so that the level chosen always has a bin a
/// column.
constexpr std::size_t binsPerLevel = 8192;
constexpr std::size_t mostGaps = 512;
} // namespace

void LiveHistory::Bin::merge(const Bin& later)
{
    end_s = later.end_s;
    for (int c = 0; c < 2; ++c) {
        low[c] = std::min(low[c], later.low[c]);
        high[c] = std::max(high[c], later.high[c]);
    }
}

void LiveHistory::Level::append(const Bin& bin)
{
    if (count < ring.size()) {
        ring[(first + count++) % ring.size()] = bin;
        return;
    }
    ring[first] = bin;
    first = (first + 1) % ring.size();
}

LiveHistory::LiveHistory(double seconds, double sampleTime_s)
    : m_sampleTime_s(sampleTime_s), m_seconds(seconds)
{
    reset(sampleTime_s);
}

void LiveHistory::reset(double sampleTime_s)
{
    m_sampleTime_s = sampleTime_s > 0 ? sampleTime_s : 0.0005;
    m_newest_s = 0;
    m_gaps.clear();
    m_levels.clear();
    double covered = m_sampleTime_s * binsPerLevel;
    m_levels.emplace_back();
    for (; covered < m_seconds; covered *= 2)
        m_levels.emplace_back();
    for (Level& level : m_levels)
        level.ring.resize(binsPerLevel);
}

void LiveHistory::append(const std::vector<Sample>& samples)
{
    for (const Sample& sample : samples) {
        // A device that was opened anew counts from its own zero again.
        if (!empty() && sample.time_s <= m_newest_s)
            reset(m_sampleTime_s);
        noteGap(sample);
        Bin bin;
        bin.begin_s = bin.end_s = m_newest_s = sample.time_s;
        bin.low[0] = bin.high[0] = static_cast<float>(sample.force);
        bin.low[1] = bin.high[1] = static_cast<float>(sample.position);
        push(bin);
    }
}

void LiveHistory::noteGap(const Sample& sample)
{
    const bool whole = empty() || (sample.sequence == m_newestSequence + 1 && !sample.clockStepped);
    m_newestSequence = sample.sequence;
    if (whole)
        return;
    if (m_gaps.size() == mostGaps)
        m_gaps.pop_front();
    m_gaps.push_back({m_newest_s, sample.time_s});
}

std::vector<LiveHistory::Gap> LiveHistory::gaps(double until_s, double seconds) const
{
    std::vector<Gap> found;
    for (const Gap& gap : m_gaps)
        if (gap.end >= until_s - seconds && gap.begin <= until_s)
            found.push_back({gap.begin - until_s, gap.end - until_s});
    return found;
}

void LiveHistory::push(Bin bin)
{
    m_levels.front().append(bin);
    for (std::size_t i = 1; i < m_levels.size(); ++i) {
        Level& level = m_levels[i];
        if (!level.open) {
            level.open = bin;
            return;
        }
        if (bin.begin_s - level.open->end_s > m_sampleTime_s * std::exp2(i)) {
            std::swap(bin, *level.open); // a bin that spans a gap would hide it
        } else {
            level.open->merge(bin);
            bin = *level.open;
            level.open.reset();
        }
        level.append(bin);
    }
}

double LiveHistory::newestTime_s() const
{
    return m_newest_s;
}

bool LiveHistory::empty() const
{
    return m_levels.front().count == 0;
}

std::size_t LiveHistory::levelFor(double seconds) const
{
    double covered = m_sampleTime_s * binsPerLevel;
    std::size_t level = 0;
    for (; covered < seconds && level + 1 < m_levels.size(); covered *= 2)
        ++level;
    return level;
}

/// Gathers bins, in order of time, into columns, and columns into stretches.
class LiveHistory::Columns {
public:
    Columns(Channel channel, double until_s, double width_s, double sampleTime_s)
        : m_channel(channel == Channel::Force ? 0 : 1), m_until_s(until_s), m_width_s(width_s),
          m_gap_s(std::max(1.5 * sampleTime_s, width_s))
    {
    }

    void add(const Bin& bin)
    {
        const double column = std::floor(bin.begin_s / m_width_s);
        const bool gap = m_open && bin.begin_s - m_open->end_s > m_gap_s;
        if (m_open && !gap && column == m_column) {
            m_open->merge(bin);
            return;
        }
        finishColumn();
        if (gap)
            finishStretch();
        m_open = bin;
        m_column = column;
    }

    [[nodiscard]] std::vector<Stretch> finish()
    {
        finishColumn();
        finishStretch();
        return std::move(m_stretches);
    }

private:
    void finishColumn()
    {
        if (!m_open)
            return;
        const double low = m_open->low[m_channel];
        const double high = m_open->high[m_channel];
        const double x = (m_open->begin_s + m_open->end_s) / 2 - m_until_s;
        // The nearer end first: the line does not cross the column twice.
        const bool fromAbove =
            !m_stretch.empty() && std::abs(m_stretch.back().y - high) < std::abs(m_stretch.back().y - low);
        m_stretch.push_back({x, fromAbove ? high : low});
        if (low != high)
            m_stretch.push_back({x, fromAbove ? low : high});
        m_open.reset();
    }

    void finishStretch()
    {
        if (!m_stretch.empty())
            m_stretches.push_back(std::move(m_stretch));
        m_stretch.clear();
    }

    int m_channel;
    double m_until_s, m_width_s, m_gap_s;
    std::optional<Bin> m_open;
    double m_column = 0;
    Stretch m_stretch;
    std::vector<Stretch> m_stretches;
};

std::vector<LiveHistory::Stretch> LiveHistory::columns(Channel channel, double until_s, double seconds,
                                                       std::size_t columns) const
{
    if (!(seconds > 0) || columns == 0 || empty())
        return {};
    const double width_s = seconds / static_cast<double>(columns);
    const double from_s = until_s - seconds - width_s;
    const std::size_t chosen = levelFor(seconds + (m_newest_s - until_s));
    const Level& level = m_levels[chosen];
    std::size_t low = 0;
    for (std::size_t high = level.count; low < high;) {
        const std::size_t middle = (low + high) / 2;
        if (level.at(middle).end_s < from_s)
            low = middle + 1;
        else
            high = middle;
    }
    Columns gathered(channel, until_s, width_s, m_sampleTime_s);
    for (std::size_t i = low; i < level.count && level.at(i).begin_s <= until_s; ++i)
        gathered.add(level.at(i));
    // What has not filled a bin of this level yet stands in the open bins, the older in the coarser.
    for (std::size_t i = chosen; i > 0; --i) {
        const std::optional<Bin>& open = m_levels[i].open;
        if (open && open->end_s >= from_s && open->begin_s <= until_s)
            gathered.add(*open);
    }
    return gathered.finish();
}

} // namespace gripscope
