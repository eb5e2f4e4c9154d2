// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/history.h"
#include "core/library/sql/statement.h"

/// Reads squeezes with all that belongs to them, across the tables; writes nothing.
namespace gripscope::history_view {

[[nodiscard]] Expected<HistoryKeys> keys(Database& database, const HistoryQuery& query);
/// In the order of the keys; those that are not there are left out.
[[nodiscard]] Expected<std::vector<HistoryEntry>> entries(Database& database,
                                                          const std::vector<QString>& graspIds);
[[nodiscard]] Expected<HistoryCounts> counts(Database& database, const HistoryQuery& query);
[[nodiscard]] Expected<HistoryPoints> points(Database& database, HistoryQuery query);
[[nodiscard]] Expected<HistoryChoices> choices(Database& database);

} // namespace gripscope::history_view

namespace gripscope {

// SQL over squeezes `g`, their inspections `i` and the batches `o` of these, first estimates `e`, and where
// the squeezes belong (`p`, `s`).

/// What a squeeze is of: the type named by its inspection, or the one it is enrolled in now.
[[nodiscard]] QString historyTypeSql();
/// The number of an InspectionOutcome; NULL for a squeeze that was not inspected.
[[nodiscard]] QString historyOutcomeSql();
/// Name and serial number of the gripper; empty where it is not known.
[[nodiscard]] QString historyDeviceSql();
/// m, b or k in SI where the units are known, else as stored.
[[nodiscard]] QString historySiSql(const QString& column);

/// The end of a SELECT that finds the squeezes of a query, with no join that it does not need.
class HistorySelection {
public:
    enum Need { None = 0, Inspections = 1, Types = 2, Estimates = 4, Batches = 8 | Inspections };

    /// `needs`: what the columns before it take, as a sum of Need.
    explicit HistorySelection(const HistoryQuery& query, int needs = None);
    /// "FROM ... ": the squeezes with what is needed beside them, a sum of Need.
    [[nodiscard]] static QString from(int needs);
    [[nodiscard]] QString fromWhere() const; ///< "FROM ... WHERE ... "
    [[nodiscard]] QString orderBy() const;
    void bind(Statement& statement) const;

private:
    void add(const QString& condition, const QStringList& values);
    void addText(const QString& text);
    void addOutcome(InspectionOutcome outcome);

    HistoryQuery m_query;
    int m_needs;
    QStringList m_conditions, m_values;
};

} // namespace gripscope
