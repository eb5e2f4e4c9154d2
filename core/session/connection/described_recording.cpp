// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/described_recording.h"

#include "core/base/words.h"
#include "core/signal/recording/stream_account.h"

#include <QDateTime>

namespace gripscope {

using namespace Qt::StringLiterals;

Recording describedRecording(const ConnectSession& connection, const QString& operatorName,
                             QMap<QString, QString> provenance)
{
    const GripperIdentity identity = connection.identity();
    provenance[u"device"_qs] = identity.name;
    provenance[u"serial"_qs] = identity.serial;
    provenance[u"address"_qs] = identity.address.isEmpty() ? connection.address() : identity.address;
    provenance[u"firmware"_qs] = identity.firmware;
    if (!identity.lossVisible)
        provenance[unseenLossesKey()] =
            Words::tr("cannot be seen: the gripper sends neither a number nor a clock");
    if (!operatorName.isEmpty())
        provenance[u"operator"_qs] = operatorName;
    provenance[u"recorded_utc"_qs] = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs);

    Recording recording;
    recording.sampleTime_s = identity.sampleTime_s;
    recording.forceUnit = identity.forceUnit;
    recording.positionUnit = identity.positionUnit;
    recording.hold = identity.hold;
    recording.forceLag_s = connection.forceLag_s();
    recording.chain = connection.measuringChain();
    recording.provenance = std::move(provenance);
    connection.calibration().describe(recording, QDateTime::currentDateTime());
    if (!identity.keptSession.isEmpty())
        recording.provenance[u"capture"_qs] = identity.keptSession;
    return recording;
}

} // namespace gripscope
