// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/change_rates.h"

#include "core/people/audit_entry.h"
#include "ui/people/authorize.h"
#include "ui/workbench.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonObject toJson(const StoredRates& stored)
{
    const VerdictOptions& rates = stored.rates;
    return {{u"false_reject"_s, rates.falseReject},
            {u"wrong_type"_s, rates.wrongType},
            {u"stranger_accept"_s, rates.strangerAccept},
            {u"confidence"_s, rates.confidence ? QJsonValue(*rates.confidence) : QJsonValue()},
            {u"robust"_s, rates.robust},
            {u"early_end"_s, stored.earlyEnd}};
}

} // namespace

void changeRates(Workbench& bench, QWidget* parent, const StoredRates& rates)
{
    const QJsonObject before = toJson(bench.rates());
    const QJsonObject after = toJson(rates);
    if (before == after)
        return;
    QJsonObject details; // only what differs, so that it can be read
    for (auto it = after.begin(); it != after.end(); ++it)
        if (before.value(it.key()) != it.value())
            details.insert(it.key(), QJsonObject{{u"from"_s, before.value(it.key())}, {u"to"_s, it.value()}});
    authorizeRecorded(bench, parent, Permission::ChangeRates, QString::fromUtf16(audit_action::ratesChanged),
                      {}, details, [&bench, rates] { bench.setRates(rates); });
}

} // namespace gripscope
