// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/feed/live_history.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {
/// Bins a level keeps: several a pixel of the widest plot, also when a part of the time kept is looked at
/// more closely.
constexpr std::size_t binsPerLevel = 16384;
/// Samples kept one by one; a gripper that is faster than 8 kHz is kept for less than a minute.
constexpr double mostSamples = 480000;
constexpr std::size_t mostGaps = 512;
/// Bins that make up a column at least, so that a column does not begin or end elsewhere than on the screen.
constexpr double binsPerColumn = 4;
} // namespace

void LiveHistory::Bin::merge(const Bin& later)
{
    end_s = later.end_s;
    for (std::size_t c = 0; c < channels; ++c) {
        low[c] = std::min(low[c], later.low[c]);
        high[c] = std::max(high[c], later.high[c]);
        count[c] += later.count[c];
        if (later.count[c] > 0)
            mean[c] +=
                (later.mean[c] - mean[c]) * static_cast<float>(later.count[c]) / static_cast<float>(count[c]);
    }
}

template <typename Item>
void LiveHistory::Ring<Item>::append(const Item& item)
{
    if (count < items.size()) {
        items[(first + count++) % items.size()] = item;
        return;
    }
    items[first] = item;
    first = (first + 1) % items.size();
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
    ++m_beginnings;
    m_gaps.clear();
    m_samples = {};
    m_samples.items.resize(
        static_cast<std::size_t>(std::ceil(std::min(mostSamples, fullRateSeconds / m_sampleTime_s))) + 1);
    m_levels.clear();
    for (double covered = m_sampleTime_s * binsPerLevel; covered < m_seconds;) {
        covered *= 2;
        m_levels.emplace_back().bins.items.resize(binsPerLevel);
    }
}

LiveHistory::Bin LiveHistory::binOf(const Kept& kept)
{
    Bin bin;
    bin.begin_s = bin.end_s = kept.sample.time_s;
    const auto put = [&bin](std::size_t channel, float value) {
        bin.low[channel] = bin.high[channel] = bin.mean[channel] = value;
        bin.count[channel] = 1;
    };
    put(0, static_cast<float>(kept.sample.force));
    put(1, static_cast<float>(kept.sample.position));
    if (kept.commandedForce)
        put(2, *kept.commandedForce);
    return bin;
}

void LiveHistory::append(const std::vector<Sample>& samples,
                         std::span<const std::optional<double>> commandedForce)
{
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Sample& sample = samples[i];
        // A device that was opened anew counts from its own zero again.
        if (!empty() && sample.time_s <= m_newest_s)
            reset(m_sampleTime_s);
        noteGap(sample);
        m_newest_s = sample.time_s;
        Kept kept{sample, std::nullopt};
        if (i < commandedForce.size() && commandedForce[i])
            kept.commandedForce = static_cast<float>(*commandedForce[i]);
        m_samples.append(kept);
        push(binOf(kept));
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
    for (std::size_t i = 0; i < m_levels.size(); ++i) {
        Level& level = m_levels[i];
        if (!level.open) {
            level.open = bin;
            return;
        }
        if (bin.begin_s - level.open->end_s > m_sampleTime_s * std::exp2(i + 1)) {
            std::swap(bin, *level.open); // a bin that spans a gap would hide it
        } else {
            level.open->merge(bin);
            bin = *level.open;
            level.open.reset();
        }
        level.bins.append(bin);
    }
}

double LiveHistory::newestTime_s() const
{
    return m_newest_s;
}

double LiveHistory::oldestFullRateTime_s() const
{
    return empty() ? m_newest_s : m_samples.at(0).sample.time_s;
}

double LiveHistory::oldestTime_s() const
{
    double oldest_s = oldestFullRateTime_s();
    for (const Level& level : m_levels)
        if (level.bins.count > 0)
            oldest_s = std::min(oldest_s, level.bins.at(0).begin_s);
    return std::max(oldest_s, m_newest_s - m_seconds);
}

bool LiveHistory::empty() const
{
    return m_samples.count == 0;
}

std::size_t LiveHistory::binCount(std::size_t level) const
{
    return level == 0 ? m_samples.count : m_levels[level - 1].bins.count;
}

LiveHistory::Bin LiveHistory::bin(std::size_t level, std::size_t i) const
{
    return level == 0 ? binOf(m_samples.at(i)) : m_levels[level - 1].bins.at(i);
}

std::size_t LiveHistory::firstBinFrom(std::size_t level, double from_s) const
{
    std::size_t low = 0;
    for (std::size_t high = binCount(level); low < high;) {
        const std::size_t middle = (low + high) / 2;
        if (bin(level, middle).end_s < from_s)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

bool LiveHistory::reaches(std::size_t level, double time_s) const
{
    const bool forgot = level == 0 ? m_samples.forgot() : m_levels[level - 1].bins.forgot();
    return !forgot || bin(level, 0).begin_s <= time_s;
}

std::size_t LiveHistory::levelFor(double from_s, double column_s) const
{
    std::size_t level = 0;
    for (double bin_s = 2 * m_sampleTime_s; level < m_levels.size(); bin_s *= 2, ++level)
        if (bin_s * binsPerColumn > column_s)
            break;
    while (level < m_levels.size() && !reaches(level, from_s))
        ++level;
    return level;
}

/// Gathers bins, in order of time, into columns, and columns into stretches.
class LiveHistory::Columns {
public:
    Columns(Channel channel, double until_s, double width_s, double sampleTime_s)
        : m_channel(static_cast<std::size_t>(channel)), m_until_s(until_s), m_width_s(width_s),
          m_gap_s(std::max(1.5 * sampleTime_s, width_s))
    {
    }

    void add(const Bin& bin)
    {
        if (bin.low[m_channel] > bin.high[m_channel]) { // nothing is known there, so no line goes across
            finishColumn();
            finishStretch();
            return;
        }
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
        const double mean = m_open->mean[m_channel];
        m_stretch.push_back({{x, fromAbove ? high : low}, mean});
        if (low != high)
            m_stretch.push_back({{x, fromAbove ? low : high}, mean});
        m_open.reset();
    }

    void finishStretch()
    {
        if (!m_stretch.empty())
            m_stretches.push_back(std::move(m_stretch));
        m_stretch.clear();
    }

    std::size_t m_channel;
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
    const std::size_t chosen = levelFor(from_s, width_s);
    Columns gathered(channel, until_s, width_s, m_sampleTime_s);
    for (std::size_t i = firstBinFrom(chosen, from_s); i < binCount(chosen); ++i) {
        const Bin one = bin(chosen, i);
        if (one.begin_s > until_s)
            break;
        gathered.add(one);
    }
    // What has not filled a bin of this level yet stands in the open bins, the older in the coarser.
    for (std::size_t i = chosen; i > 0; --i) {
        const std::optional<Bin>& open = m_levels[i - 1].open;
        if (open && open->end_s >= from_s && open->begin_s <= until_s)
            gathered.add(*open);
    }
    return gathered.finish();
}

std::optional<LiveHistory::Reading> LiveHistory::reading(Channel channel, double time_s) const
{
    const auto c = static_cast<std::size_t>(channel);
    std::size_t level = 0;
    while (level <= m_levels.size() && !reaches(level, time_s))
        ++level;
    if (level > m_levels.size())
        return std::nullopt;
    const std::size_t after = firstBinFrom(level, time_s);
    for (const std::size_t i : {after, after - 1}) { // those on either side of that time
        if (i >= binCount(level))
            continue;
        const Bin one = bin(level, i);
        const double nearest_s = 0.501 * m_sampleTime_s; // half way to the next, and a little for rounding
        const bool here = one.begin_s - nearest_s <= time_s && time_s <= one.end_s + nearest_s;
        if (here && one.low[c] <= one.high[c])
            return Reading{one.low[c], one.high[c]};
    }
    return std::nullopt;
}

std::vector<Sample> LiveHistory::samples(double from_s, double until_s) const
{
    std::vector<Sample> found;
    for (std::size_t i = firstBinFrom(0, from_s); i < m_samples.count; ++i) {
        const Sample& sample = m_samples.at(i).sample;
        if (sample.time_s > until_s)
            break;
        found.push_back(sample);
    }
    return found;
}

std::optional<Sample> LiveHistory::sampleAt(double time_s) const
{
    if (empty() || !reaches(0, time_s))
        return std::nullopt;
    const std::size_t after = std::min(firstBinFrom(0, time_s), m_samples.count - 1);
    const Sample& later = m_samples.at(after).sample;
    const Sample& earlier = m_samples.at(after > 0 ? after - 1 : 0).sample;
    return time_s - earlier.time_s < later.time_s - time_s ? earlier : later;
}

} // namespace gripscope
