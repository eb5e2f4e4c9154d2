// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/csv.h"
#include "core/library/history/history_fields.h"
#include "core/library/sql/statement.h"
#include "core/quality/conformity/conformity_json.h"

#include <QJsonDocument>

#include <algorithm>

// How an inspected part stood to the limits of its type, among the fields and columns of a history.

namespace gripscope {

/// The worst specific risk of its quantities.
inline std::optional<double> conformityRisk(const HistoryEntry& entry)
{
    std::optional<double> worst;
    if (entry.conformityValues)
        for (const std::optional<QuantityConformity>& quantity : entry.conformityValues->quantities)
            if (quantity && quantity->risk)
                worst = std::max(worst.value_or(0), *quantity->risk);
    return worst;
}

inline void takeConformity(Statement& row, HistoryEntry& entry)
{
    entry.conformity = conformityDecisionFromString(row.takeText());
    entry.conformityValues = conformityFromJson(QJsonDocument::fromJson(row.takeText().toUtf8()).object());
}

inline HistoryField conformityField()
{
    return {"conformity",
            "conformity,conformity_risk",
            u"COALESCE(i.conformity, ''), COALESCE(i.conformity_values, '')"_qs,
            takeConformity,
            [](const HistoryEntry& entry) {
                return QStringList{entry.conformity ? toString(*entry.conformity) : QString(),
                                   exactText(conformityRisk(entry))};
            },
            [](const HistoryEntry& entry) {
                return entry.conformityValues ? QJsonValue(conformityJson(*entry.conformityValues))
                                              : QJsonValue();
            }};
}

inline QString conformityOrderSql()
{
    return u"CASE i.conformity WHEN 'conforms' THEN 0 WHEN 'does_not_conform' THEN 1 WHEN "
           "'too_near_the_limit' THEN 2 WHEN 'not_decidable' THEN 3 END"_qs;
}

} // namespace gripscope
