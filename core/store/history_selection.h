// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/history.h"
#include "core/store/statement.h"

namespace gripscope {

// SQL over squeezes `g`, their inspections `i` and the batches `o` of these, first estimates `e`, and where
// the squeezes belong (`p`, `s`).

/// What a squeeze is of: the type named by its inspection, or the one it is enrolled in now.
[[nodiscard]] QString historyTypeSql();
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
