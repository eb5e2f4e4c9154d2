// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/measuring_chain.h"

#include <QMap>
#include <QString>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gripscope {

/// How the force behaves between two samples.
enum class ForceHold {
    Zero,  ///< constant until the next sample: a commanded, held force ("zoh")
    First, ///< a straight line to the next sample: a sampled, continuous force ("foh")
};

[[nodiscard]] QString toString(ForceHold hold);
[[nodiscard]] std::optional<ForceHold> forceHoldFromString(const QString& text);

/// Samples missing in front of the sample with index `before` (never at index 0).
struct Gap {
    std::size_t before = 0;
    std::int64_t lostSamples = 0;
    friend bool operator==(const Gap&, const Gap&) = default;
};

/// A stretch of samples [first, first + count).
struct Window {
    std::size_t first = 0;
    std::size_t count = 0;
    friend bool operator==(const Window&, const Window&) = default;
};

/// Force and position of one squeeze on the device's own clock, with all that is needed to read them later.
///
/// `time_s`, `force`, `position` have the same length; `sequence` and `status` are empty or have that length
/// too. Times are those of the device and increase; a lost sample is a jump in time and sequence, never a
/// made-up row. Channel units are the texts in `forceUnit` and `positionUnit`; "1" means that the source
/// names none.
struct Recording {
    double sampleTime_s = 0;
    QString forceUnit = QStringLiteral("1");
    QString positionUnit = QStringLiteral("1");
    std::optional<ForceHold> hold; ///< empty: the source does not say
    double forceLag_s = 0;         ///< how much later the position channel samples than the force channel
    MeasuringChain chain;          ///< what is known of the device's systematic effects
    std::vector<double> time_s;
    std::vector<double> force;
    std::vector<double> position;
    std::vector<std::uint64_t> sequence;
    std::vector<std::uint16_t> status; ///< device status bits (SampleStatus) per sample
    QMap<QString, QString> provenance; ///< free "key: value" facts: device, serial, operator, excitation...

    [[nodiscard]] std::size_t size() const { return force.size(); }

    friend bool operator==(const Recording&, const Recording&) = default;
};

/// Provenance of a recording whose source names a `force_lag_s` of zero: known to be none, where one that
/// does not name it knows nothing.
[[nodiscard]] inline QString forceLagSourceKey()
{
    return QStringLiteral("force_lag_source");
}
/// Somebody said what the lag between the channels is: it is not zero, or a zero that was named.
[[nodiscard]] bool lagIsStated(const Recording& recording);
/// Half of the range about `forceLag_s` in which a lag lies that was neither stated nor measured: a tenth of
/// the sample time; zero for any other. A device that reads both channels for every sample is done with both
/// in so much. A lag of several tenths looks like the wrong force hold, which its check finds.
[[nodiscard]] double unmeasuredLagBound_s(const Recording& recording);

/// Status bits a device attaches to its samples; the values are those of the Gripscope protocol.
enum SampleStatus : std::uint16_t {
    StatusArmed = 1 << 0,
    StatusMoving = 1 << 1, ///< the excitation is running
    StatusForceLimit = 1 << 2,
    StatusTravelLimit = 1 << 3,
    StatusForceSaturated = 1 << 4,
    StatusPositionSaturated = 1 << 5,
    StatusFault = 1 << 6,
    StatusWatchdog = 1 << 7,
};

/// Gaps found from the sequence numbers, or from the time stamps where there are none. A step of time longer
/// than 1.5 sample times is a gap of round(step / sampleTime_s) - 1 samples. O(N).
[[nodiscard]] std::vector<Gap> findGaps(const Recording& recording);

/// The length of a squeeze, wherever one is told: from its recording's first sample to the end of its last,
/// gaps included. It begins and ends a little outside the force (see SqueezeJob).
[[nodiscard]] double lengthSeconds(const Recording& recording);

/// A recording that holds only the samples of `window`, provenance and units kept.
[[nodiscard]] Recording slice(const Recording& recording, Window window);

/// A moment that a person marked while it was measured.
struct RecordingMarker {
    double time_s = 0; ///< as in Recording::time_s
    QString words;     ///< may be empty
};

/// Notes those markers in the recording's provenance that lie between its first sample and its last, in order
/// of time: `marker_001: 12.5035 s: words`. What was noted before goes.
void noteMarkers(Recording& recording, std::vector<RecordingMarker> markers);

} // namespace gripscope
