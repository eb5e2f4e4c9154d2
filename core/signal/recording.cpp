// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

/// A step longer than this many sample times means that samples are missing.
constexpr double gapThreshold = 1.5;

std::int64_t toCount(double samples)
{
    // Far beyond any recording, and still exact in a double.
    constexpr double largest = 9e15;
    return samples >= largest ? static_cast<std::int64_t>(largest) : std::llround(samples);
}

std::vector<Gap> gapsInSequence(const std::vector<std::uint64_t>& sequence)
{
    std::vector<Gap> gaps;
    for (std::size_t i = 1; i < sequence.size(); ++i) {
        if (sequence[i] == sequence[i - 1] + 1)
            continue;
        // A number that does not increase says nothing about how much is missing, but the thread is broken
        // there.
        const bool forward = sequence[i] > sequence[i - 1];
        const std::uint64_t lost = forward ? sequence[i] - sequence[i - 1] - 1 : 0;
        constexpr auto largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
        gaps.push_back({i, static_cast<std::int64_t>(std::min(lost, largest))});
    }
    return gaps;
}

std::vector<Gap> gapsInTime(const std::vector<double>& time_s, double sampleTime_s)
{
    std::vector<Gap> gaps;
    if (!(sampleTime_s > 0))
        return gaps;
    for (std::size_t i = 1; i < time_s.size(); ++i) {
        const double steps = (time_s[i] - time_s[i - 1]) / sampleTime_s;
        if (steps > gapThreshold)
            gaps.push_back({i, std::max<std::int64_t>(toCount(steps) - 1, 1)});
    }
    return gaps;
}

template <typename T>
std::vector<T> part(const std::vector<T>& all, Window window)
{
    if (all.size() < window.first + window.count)
        return {};
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(window.first);
    return {begin, begin + static_cast<std::ptrdiff_t>(window.count)};
}

} // namespace

QString toString(ForceHold hold)
{
    return hold == ForceHold::Zero ? QStringLiteral("zoh") : QStringLiteral("foh");
}

std::optional<ForceHold> forceHoldFromString(const QString& text)
{
    if (text == QLatin1String("zoh"))
        return ForceHold::Zero;
    if (text == QLatin1String("foh"))
        return ForceHold::First;
    return std::nullopt;
}

std::vector<Gap> findGaps(const Recording& recording)
{
    return recording.sequence.empty() ? gapsInTime(recording.time_s, recording.sampleTime_s)
                                      : gapsInSequence(recording.sequence);
}

std::vector<Window> unbrokenWindows(const Recording& recording)
{
    std::vector<Window> windows;
    if (recording.size() == 0)
        return windows;
    std::size_t first = 0;
    for (const Gap& gap : findGaps(recording)) {
        windows.push_back({first, gap.before - first});
        first = gap.before;
    }
    windows.push_back({first, recording.size() - first});
    return windows;
}

std::optional<Window> longestUnbrokenWindow(const Recording& recording)
{
    const std::vector<Window> windows = unbrokenWindows(recording);
    if (windows.empty())
        return std::nullopt;
    return *std::max_element(windows.begin(), windows.end(),
                             [](const Window& a, const Window& b) { return a.count < b.count; });
}

Recording slice(const Recording& recording, Window window)
{
    window.first = std::min(window.first, recording.size());
    window.count = std::min(window.count, recording.size() - window.first);
    Recording out;
    out.sampleTime_s = recording.sampleTime_s;
    out.forceUnit = recording.forceUnit;
    out.positionUnit = recording.positionUnit;
    out.hold = recording.hold;
    out.forceLag_s = recording.forceLag_s;
    out.chain = recording.chain;
    out.provenance = recording.provenance;
    out.time_s = part(recording.time_s, window);
    out.force = part(recording.force, window);
    out.position = part(recording.position, window);
    out.sequence = part(recording.sequence, window);
    out.status = part(recording.status, window);
    return out;
}

} // namespace gripscope
