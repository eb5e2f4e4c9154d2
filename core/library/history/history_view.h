// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/history_list.h"
#include "core/library/sql/statement.h"

namespace gripscope {
class HistorySelection;
}

/// Reads squeezes with all that belongs to them, across the tables; writes nothing.
namespace gripscope::history_view {

[[nodiscard]] Expected<HistoryKeys> keys(Database& database, const HistoryQuery& query);
/// In the order of the keys; those that are not there are left out.
[[nodiscard]] Expected<std::vector<HistoryEntry>> entries(Database& database,
                                                          const std::vector<QString>& graspIds);
[[nodiscard]] Expected<HistoryCounts> counts(Database& database, const HistoryQuery& query);
/// Of a selection that needs Inspections.
[[nodiscard]] Expected<HistoryCounts> countsOf(Database& database, const HistorySelection& selection);
/// What squeezes are counted by, six columns; `voided`: SQL, 1 for an inspection that does not count.
[[nodiscard]] QString alikeColumns(const QString& voided);
/// The counts of `count` squeezes that are alike in these columns, taken from the row.
[[nodiscard]] HistoryCounts takeAlike(Statement& row, qint64 count);
/// Whether counts() takes no longer for more inspections.
[[nodiscard]] bool talliesKnow(const HistoryQuery& query);
/// How many are read of a list that is counted.
inline constexpr qint64 mostPoints = 20'000;
[[nodiscard]] Expected<HistoryPoints> points(Database& database, const HistoryList& list);
[[nodiscard]] Expected<HistoryInForce> inForce(Database& database, HistoryQuery query);
[[nodiscard]] Expected<HistoryChoices> choices(Database& database);

} // namespace gripscope::history_view

/// Lists of what a query finds, however many there are; see HistoryList.
namespace gripscope::history_list {

[[nodiscard]] Expected<HistoryList> find(Database& database, const HistoryQuery& query);
/// One stretch further: more of its rows, counts and marks are known then.
[[nodiscard]] Expected<void> goOn(Database& database, HistoryList& list);
/// To the end.
[[nodiscard]] Expected<void> goThrough(Database& database, HistoryList& list);
/// Rows `first` to `first + count - 1`, as many of them as there are.
[[nodiscard]] Expected<std::vector<QString>> keys(Database& database, const HistoryList& list, qint64 first,
                                                  qint64 count);
/// Which row a squeeze is; nothing where it is none of them.
[[nodiscard]] Expected<std::optional<qint64>> rowOf(Database& database, const HistoryList& list,
                                                    const QString& key);

} // namespace gripscope::history_list

namespace gripscope {

// SQL over squeezes `g`, their inspections `i` and the batches `o` of these, first estimates `e`, and where
// the squeezes belong (`p`, `s`).

/// What a squeeze is of: the type named by its inspection, or the one it is enrolled in now.
[[nodiscard]] QString historyTypeSql();
/// The number of an InspectionOutcome; NULL for a squeeze that was not inspected.
[[nodiscard]] QString historyOutcomeSql();
/// What the measurement of an inspection is worth, as toString(ValidityVerdict); empty: not recorded, or
/// none.
[[nodiscard]] QString historyValiditySql();
/// Name and serial number of the gripper; empty where it is not known.
[[nodiscard]] QString historyDeviceSql();
/// The program that identified the squeeze, else the one that judged it; empty where it is not known.
[[nodiscard]] QString historyProgramSql();
/// Of the library when it was stored; NULL where it is not known.
[[nodiscard]] QString historyVersionSql();
/// 1 for an inspection that does not count, else 0.
[[nodiscard]] QString historyIsVoidedSql();
/// Why an inspection does not count; empty where it does.
[[nodiscard]] QString historyVoidedSql();
/// m, b or k in SI where the units are known, else as stored.
[[nodiscard]] QString historySiSql(const QString& column);

/// The end of a SELECT that finds the squeezes of a query, with no join that it does not need.
class HistorySelection {
public:
    enum Need { None = 0, Inspections = 1, Types = 2, Estimates = 4, Batches = 8 | Inspections };

    /// How the text of a query is searched for: in every row on the way, which is right where it is in many
    /// of them; or beforehand, along indexes (searchFor()).
    enum class TextBy { Rows, Keys };
    /// Of a search beforehand: of more keys not all are known.
    static constexpr qint64 mostNamed = HistoryList::mostCollected;

    /// `needs`: what the columns before it take, as a sum of Need.
    explicit HistorySelection(const HistoryQuery& query, int needs = None, TextBy textBy = TextBy::Rows);
    /// "FROM ... ": the squeezes with what is needed beside them, a sum of Need.
    [[nodiscard]] static QString from(int needs);
    void onlyVoided();                                        ///< of those inspections that do not count
    void withoutVoided();                                     ///< leaves these out
    void onlyBehind(const HistoryMark& mark, bool backwards); ///< and not the mark itself; an empty one: all
    void onlyUpTo(const HistoryMark& mark, bool backwards);   ///< and the mark itself
    void onlyOf(const HistoryList& list);                     ///< what was stored when it was made
    void onlyOneIn(qint64 every); ///< every so many-th inspection by its number, and what was enrolled
    /// Before SELECT; empty unless a text is searched for beforehand.
    [[nodiscard]] QString with() const { return m_named; }
    /// A column: how many keys were named beforehand, with mostNamed + 1 for more.
    [[nodiscard]] QString named() const
    {
        return m_named.isEmpty() ? QStringLiteral("0") : QStringLiteral("(SELECT COUNT(*) FROM named)");
    }
    [[nodiscard]] QString fromWhere() const; ///< "FROM ... WHERE ... "
    [[nodiscard]] QString orderBy() const;
    [[nodiscard]] static QString orderByTime(bool backwards);
    /// What is ordered by; NULL by time.
    [[nodiscard]] QString ordered() const;
    void bind(Statement& statement) const;

private:
    /// A side of a period. The closest of each side alone is asked for: PostgreSQL begins at one of several
    /// as it comes, and goes through all rows from there to the closest.
    struct Bound {
        HistoryMark at; ///< without a key: before all of that time
        bool inclusive = false;
        QString sql;
    };
    void addBound(std::optional<Bound>& known, const Bound& bound);
    void add(const QString& condition, const QStringList& values);
    void addText(const QString& text);
    void addSearch(const QString& text);
    void addOutcome(InspectionOutcome outcome);

    HistoryQuery m_query;
    int m_needs;
    bool m_voided = false;
    QStringList m_conditions, m_values;
    std::optional<Bound> m_lower, m_upper;
    QString m_named;
    QStringList m_namedValues;
};

} // namespace gripscope
