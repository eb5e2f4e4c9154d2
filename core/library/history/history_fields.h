// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/history.h"

#include <QJsonValue>
#include <QVariant>

#include <vector>

namespace gripscope {

class Statement;

// What a history knows of a squeeze, each fact once: read, exported, shown and ordered by these two tables. A
// new fact is a member of HistoryEntry and a line of historyFields(); a new column of the page an enumerator
// of HistoryColumn and a line of historyColumns().

/// What is read of a squeeze and told in exports.
struct HistoryField {
    const char* json; ///< its member in JSON; empty: of none
    const char* csv;  ///< the heads of its cells with commas between; empty: none
    QString sql;      ///< what take() takes, over the tables of HistorySelection
    void (*take)(Statement& row, HistoryEntry& entry); ///< null where nothing is read
    QStringList (*cells)(const HistoryEntry& entry);   ///< null where there are none
    QJsonValue (*value)(const HistoryEntry& entry);    ///< null where there is none
};
/// In the order of the cells.
[[nodiscard]] const std::vector<HistoryField>& historyFields();

/// How the raw values of a column are worded.
enum class ColumnFormat {
    Text,
    Count,
    Time,
    Kind,
    Outcome,
    Validity, ///< of an inspection; -1 where it was not recorded
    Probability,
    Quantity,
    Percent,
    Seconds,
    Estimator,
    Conformity ///< how an inspection stood to its type's limits
};

/// A column of the page, which the library can order by.
struct HistoryColumnFacts {
    HistoryColumn column;
    ColumnFormat format;
    const char* title;                            ///< in full; English that Words::say() takes
    QVariant (*value)(const HistoryEntry& entry); ///< raw; m, b and k in SI where the units are known
    QString order;                                ///< SQL; empty: by time
    int needs = 0;                                ///< HistorySelection::Need of that
};
/// In the order of the enumerators.
[[nodiscard]] const std::vector<HistoryColumnFacts>& historyColumns();
[[nodiscard]] const HistoryColumnFacts& factsOf(HistoryColumn column);

} // namespace gripscope
