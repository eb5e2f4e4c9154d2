// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/session/connection/connect_session.h"

#include <QString>

namespace gripscope {

// A link's counters in the words of the Live page, the status line and the inspector.

/// "connected", "silent", "lost", ...
[[nodiscard]] QString linkWords(ConnectSession::State state, const LinkCounters& counters);
/// "none"; "12 (0.1 %), 3 s ago".
[[nodiscard]] QString lossWords(const LinkCounters& counters, LinkCounters::TimePoint now);
/// What else went wrong: "sound"; "2 twice, 1 damaged, 1 silence (0.3 s), 1 clock jump".
[[nodiscard]] QString streamWords(const LinkCounters& counters);
/// "9 ms, most within 17 ms".
[[nodiscard]] QString latencyWords(double median_ms, double most_ms);
/// "idle", "loading", "running", ...
[[nodiscard]] QString squeezeWords(SqueezeState state);
/// A limit of the gate beside the device's own, both in SI: "30 of 100 N"; "100 N" where they are the same.
[[nodiscard]] QString limitWords(double inForce, double ofDevice, const ShownUnit& shown);

} // namespace gripscope
