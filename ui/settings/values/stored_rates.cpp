// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/values/stored_rates.h"

#include "ui/settings/values/settings.h"

namespace gripscope {

StoredRates readRates(const Settings& settings)
{
    StoredRates stored;
    VerdictOptions rates;
    rates.falseReject = settings.get(setting::falseReject);
    rates.wrongType = settings.get(setting::wrongType);
    rates.strangerAccept = settings.get(setting::strangerAccept);
    const double confidence = settings.get(setting::confidence);
    if (confidence > 0)
        rates.confidence = confidence;
    rates.robust = settings.get(setting::robust);
    if (!rates.validate())
        stored.rates = rates;
    stored.earlyEnd = settings.get(setting::earlyEnd);
    return stored;
}

void writeRates(Settings& settings, const StoredRates& stored)
{
    const VerdictOptions& rates = stored.rates;
    settings.set(setting::falseReject, rates.falseReject);
    settings.set(setting::wrongType, rates.wrongType);
    settings.set(setting::strangerAccept, rates.strangerAccept);
    settings.set(setting::confidence, rates.confidence.value_or(0));
    settings.set(setting::robust, rates.robust);
    settings.set(setting::earlyEnd, stored.earlyEnd);
}

} // namespace gripscope
