// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/measuring_chain.h"

#include <QDateTime>
#include <QString>

namespace gripscope {

/// What was measured of a gripper's channels.
struct NewMeasuringChain {
    QString gripperSerial; ///< whose it is
    double forceLag_s = 0; ///< how much later the position channel samples than the force channel
    MeasuringChain chain;
    QString operatorName;
    QString basis;       ///< how it was measured, in words
    QString reason = {}; ///< why it is to hold from now on; of the audit trail
};

struct MeasuringChainRecord : NewMeasuringChain {
    QDateTime measured;
};

} // namespace gripscope
