// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/stored_chain.h"

#include "core/signal/recording/recording.h"

namespace gripscope {

using namespace Qt::StringLiterals;

Expected<KnownGripper> knownGripper(const Library& library, const QString& serial)
{
    if (serial.isEmpty())
        return KnownGripper{};
    ASSIGN_OR_RETURN(const std::optional<MeasuringChainRecord> chain, library.measuringChain(serial));
    ASSIGN_OR_RETURN(const CalibrationsInForce calibrations, library.calibrationsInForce(serial));
    return KnownGripper{chain, calibrations};
}

void putInForce(ConnectSession& connection, const KnownGripper& known)
{
    if (known.chain)
        connection.setMeasuringChain(known.chain->forceLag_s, known.chain->chain);
    connection.setCalibrations(known.calibrations);
}

ChainUse completeChain(Recording& recording, const MeasuringChainRecord& known)
{
    if (!(recording.chain == MeasuringChain()))
        return ChainUse::Own;
    const bool statesLag = lagIsStated(recording);
    recording.chain = known.chain;
    if (statesLag)
        recording.chain.forceLagUncertainty_s = 0; // that of another lag
    else
        recording.forceLag_s = known.forceLag_s;
    recording.provenance[u"measuring_chain_source"_s] =
        u"library, measured %1"_s.arg(known.measured.toUTC().toString(Qt::ISODate));
    return statesLag ? ChainUse::StoredRest : ChainUse::Stored;
}

} // namespace gripscope
