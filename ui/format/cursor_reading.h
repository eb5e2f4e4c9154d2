// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/feed/live_history.h"
#include "ui/format/number_format.h"

#include <optional>

namespace gripscope {

/// A value read from a chart with half the width of its 95 % interval.
struct ReadValue {
    double value = 0;
    double halfWidth = 0; ///< zero: not known
    bool range =
        false; ///< anywhere from value - halfWidth to value + halfWidth: no longer kept by the sample
};

/// What a cursor reads, in the units of the channels. A sample that is kept is one reading of the channel:
/// its interval is 1.96 standard deviations of the channel's noise, from the 0.1 s around it, and of the
/// rounding to the sensor's steps (step / sqrt(12), GUM F.2.2.1). Later only the range of some samples is
/// known.
struct CursorReading {
    std::optional<ReadValue> force, position;
};
[[nodiscard]] CursorReading readCursor(const LiveHistory& history, double time_s);

/// The second less the first; the half widths add in quadrature.
[[nodiscard]] std::optional<ReadValue> difference(const std::optional<ReadValue>& first,
                                                  const std::optional<ReadValue>& second);

/// Change of force over change of position between two cursors, dF / dx, with a half width to first order:
/// sqrt(hF^2 + k^2 hx^2) / |dx|. Nothing where either is not known, and where the position changed by less
/// than its half width: any slope would do.
[[nodiscard]] std::optional<ReadValue> slopeBetween(const CursorReading& first, const CursorReading& second);

/// The slope for the screen: in N/m where the channels' units allow it.
[[nodiscard]] FormattedNumber slopeText(const ReadValue& slope, const QString& forceUnit,
                                        const QString& positionUnit);

} // namespace gripscope
