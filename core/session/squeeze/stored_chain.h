// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/library/library.h"
#include "core/session/connection/connect_session.h"

namespace gripscope {

/// What the library knows of a gripper's channels, brought to where it is used.

struct KnownGripper {
    std::optional<MeasuringChainRecord>
        chain;                        ///< lag, force noise, frame, the empty gripper's own m, b and k
    CalibrationsInForce calibrations; ///< sensors against references
};
/// Nothing of a gripper without a serial number.
[[nodiscard]] Expected<KnownGripper> knownGripper(const Library& library, const QString& serial);

/// All of it into force for what comes from the connected gripper from now on: the one way in, whoever
/// connected, so that nobody forgets a part of it. ConnectSession::calibration() tells what was of no use.
void putInForce(ConnectSession& connection, const KnownGripper& known);

enum class ChainUse {
    Own,       ///< the recording has a chain of its own, which stays
    Stored,    ///< it has the library's chain now
    StoredRest ///< it states its lag, which stays, with the library's chain except the lag's uncertainty
};

/// Gives a recording of that gripper the library's chain where it has none, and says so in its provenance
/// (`measuring_chain_source`). A lag that is not zero is stated, and so is a zero that the file names
/// (`force_lag_source`, see recording.h).
[[nodiscard]] ChainUse completeChain(Recording& recording, const MeasuringChainRecord& known);

} // namespace gripscope
