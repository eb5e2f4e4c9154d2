// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace gripscope {

/// How this computer's clock stands, as chrony knows it.
struct ClockStanding {
    double offset_s = 0; ///< what it shows minus true time; positive: fast
    /// How wrong the offset may be: root dispersion and half the root delay (RFC 5905, 11.1).
    double dispersion_s = 0;
    friend bool operator==(const ClockStanding&, const ClockStanding&) = default;
};

/// What "chronyc -n tracking" prints. Nothing where it is something else, or says that the clock is not
/// synchronised.
[[nodiscard]] std::optional<ClockStanding> clockStandingFrom(const QString& printed);

} // namespace gripscope
