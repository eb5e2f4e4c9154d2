// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/stored_chain.h"

#include "core/signal/recording/recording_csv.h"

namespace gripscope {

using namespace Qt::StringLiterals;

void putInForce(ConnectSession& connection, const MeasuringChainRecord& known)
{
    connection.setMeasuringChain(known.forceLag_s, known.chain);
}

ChainUse completeChain(Recording& recording, const MeasuringChainRecord& known)
{
    if (!(recording.chain == MeasuringChain()))
        return ChainUse::Own;
    const bool lagIsStated = recording.forceLag_s != 0 || recording.provenance.contains(forceLagSourceKey());
    recording.chain = known.chain;
    if (lagIsStated)
        recording.chain.forceLagUncertainty_s = 0; // that of another lag
    else
        recording.forceLag_s = known.forceLag_s;
    recording.provenance[u"measuring_chain_source"_s] =
        u"library, measured %1"_s.arg(known.measured.toUTC().toString(Qt::ISODate));
    return lagIsStated ? ChainUse::StoredRest : ChainUse::Stored;
}

} // namespace gripscope
