// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/stored_rates.h"

#include <QSettings>

using namespace Qt::StringLiterals;

namespace gripscope {

StoredRates readRates(const QSettings& settings)
{
    StoredRates stored;
    VerdictOptions rates;
    rates.falseReject = settings.value(u"rates/falseReject"_s, rates.falseReject).toDouble();
    rates.wrongType = settings.value(u"rates/wrongType"_s, rates.wrongType).toDouble();
    rates.strangerAccept = settings.value(u"rates/strangerAccept"_s, rates.strangerAccept).toDouble();
    const double confidence = settings.value(u"rates/confidence"_s, 0.0).toDouble();
    if (confidence > 0)
        rates.confidence = confidence;
    rates.robust = settings.value(u"rates/robust"_s, rates.robust).toBool();
    if (!rates.validate())
        stored.rates = rates;
    stored.earlyEnd = settings.value(u"rates/earlyEnd"_s, stored.earlyEnd).toBool();
    return stored;
}

void writeRates(QSettings& settings, const StoredRates& stored)
{
    const VerdictOptions& rates = stored.rates;
    settings.setValue(u"rates/falseReject"_s, rates.falseReject);
    settings.setValue(u"rates/wrongType"_s, rates.wrongType);
    settings.setValue(u"rates/strangerAccept"_s, rates.strangerAccept);
    settings.setValue(u"rates/confidence"_s, rates.confidence.value_or(0));
    settings.setValue(u"rates/robust"_s, rates.robust);
    settings.setValue(u"rates/earlyEnd"_s, stored.earlyEnd);
}

} // namespace gripscope
