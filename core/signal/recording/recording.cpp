// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A step longer than this many sample times means that samples are missing.
constexpr double gapThreshold = 1.5;
/// Of the sample time; see unmeasuredLagBound_s().
constexpr double unmeasuredLagShare = 0.1;

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
std::vector<T> copyOf(const std::vector<T>& all, Window window)
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

bool lagIsStated(const Recording& recording)
{
    return recording.forceLag_s != 0 || recording.provenance.contains(forceLagSourceKey());
}

double unmeasuredLagBound_s(const Recording& recording)
{
    const bool known = lagIsStated(recording) || recording.chain.forceLagUncertainty_s > 0;
    return known ? 0 : unmeasuredLagShare * recording.sampleTime_s;
}

std::vector<Gap> findGaps(const Recording& recording)
{
    return recording.sequence.empty() ? gapsInTime(recording.time_s, recording.sampleTime_s)
                                      : gapsInSequence(recording.sequence);
}

double lengthSeconds(const Recording& recording)
{
    return recording.time_s.empty()
               ? static_cast<double>(recording.size()) * recording.sampleTime_s
               : recording.time_s.back() - recording.time_s.front() + recording.sampleTime_s;
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
    out.time_s = copyOf(recording.time_s, window);
    out.force = copyOf(recording.force, window);
    out.position = copyOf(recording.position, window);
    out.sequence = copyOf(recording.sequence, window);
    out.status = copyOf(recording.status, window);
    return out;
}

void noteMarkers(Recording& recording, std::vector<RecordingMarker> markers)
{
    const QString prefix = u"marker_"_qs;
    recording.provenance.removeIf([&](const auto& fact) { return fact.key().startsWith(prefix); });
    if (recording.time_s.empty())
        return;
    std::sort(markers.begin(), markers.end(),
              [](const RecordingMarker& a, const RecordingMarker& b) { return a.time_s < b.time_s; });
    int number = 0;
    for (const RecordingMarker& marker : markers) {
        if (marker.time_s < recording.time_s.front() || marker.time_s > recording.time_s.back())
            continue;
        const QString words = marker.words.simplified();
        const QString time = u"%1 s"_qs.arg(marker.time_s, 0, 'g', 12);
        recording.provenance[prefix + u"%1"_qs.arg(++number, 3, 10, QChar(u'0'))] =
            words.isEmpty() ? time : u"%1: %2"_qs.arg(time, words);
    }
}

} // namespace gripscope
