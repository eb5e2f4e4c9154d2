// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/session/connection/connect_session.h"

namespace gripscope {

/// What the library knows of a gripper's channels, brought to where it is used.

/// Into force for the squeezes to come from the connected gripper.
void putInForce(ConnectSession& connection, const MeasuringChainRecord& known);

enum class ChainUse {
    Own,       ///< the recording has a chain of its own, which stays
    Stored,    ///< it has the library's chain now
    StoredRest ///< it states its lag, which stays, with the library's chain except the lag's uncertainty
};

/// Gives a recording of that gripper the library's chain where it has none, and says so in its provenance
/// (`measuring_chain_source`). A lag that is not zero is stated, and so is a zero that the file names
/// (`force_lag_source`, see recording_csv.h).
[[nodiscard]] ChainUse completeChain(Recording& recording, const MeasuringChainRecord& known);

} // namespace gripscope
