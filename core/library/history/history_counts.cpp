// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/history/history_view.h"
#include "core/library/tables/inspection_tables.h"
#include "core/library/tables/tally_table.h"

#include <functional>

namespace gripscope::history_view {

using namespace Qt::StringLiterals;

namespace {

QString countingHistory()
{
    return Words::tr("read the history");
}

/// `count` inspections that came out so; below 0 they are taken away again.
void addOutcome(HistoryCounts& counts, InspectionOutcome outcome, const QString& expected, qint64 count)
{
    if (expected.isEmpty()) {
        counts.knownType += outcome == InspectionOutcome::AsExpected ? count : 0;
        counts.unasked +=
            outcome == InspectionOutcome::Inconclusive || outcome == InspectionOutcome::NotValid ? 0 : count;
    }
    switch (outcome) {
    case InspectionOutcome::AsExpected:
        counts.asExpected += count;
        break;
    case InspectionOutcome::OtherType:
        counts.otherType += count;
        break;
    case InspectionOutcome::Unknown:
        counts.unknown += count;
        break;
    case InspectionOutcome::Inconclusive:
        counts.inconclusive += count;
        break;
    case InspectionOutcome::NotValid:
        counts.notValid += count;
        break;
    case InspectionOutcome::DoesNotConform:
        counts.doesNotConform += count;
        break;
    }
}

void addSuspect(HistoryCounts& counts, const std::optional<PartJudged>& judged, qint64 count)
{
    if (judged && judged->kind != VerdictKind::Invalid)
        counts.suspect += count;
}

/// What a query lets through of the inspections that are alike in these.
bool lets(const HistoryQuery& query, const std::optional<InspectionOutcome>& outcome, const QString& expected,
          const QString& type)
{
    return query.kind != SqueezeKind::Enrollment && (!query.outcome || outcome == query.outcome) &&
           (query.expected.isEmpty() || expected == query.expected) &&
           (query.type.isEmpty() || type == query.type);
}

/// Calls `take` with what was judged, expected type, type and number of inspections.
Expected<void> forAlike(
    Database& database, const QString& select,
    const std::function<void(const std::optional<PartJudged>&, const QString&, const QString&, qint64)>& take)
{
    Statement statement(database, countingHistory(), select);
    return statement.forEach([&](Statement& row) {
        const auto judged = partJudgedFromString(row.takeText());
        const QString expected = row.takeText();
        const QString type = row.takeText();
        take(judged, expected, type, row.takeInteger());
    });
}

/// The inspections of a query that the tallies know, those that were voided with them.
Expected<void> countTallied(Database& database, const HistoryQuery& query, HistoryCounts& counts)
{
    const auto outcomeOf = [](const std::optional<PartJudged>& judged, const QString& expected,
                              const QString& type) {
        return judged ? std::optional(inspectionOutcome(*judged, type, expected)) : std::nullopt;
    };
    const auto kinds = u"verdict, expected_type, type_name"_s;
    RETURN_IF_ERROR(forAlike(
        database, u"SELECT %1, SUM(n) FROM %2 AS counted GROUP BY %1"_s.arg(kinds, tally_table::countedSql()),
        [&](const std::optional<PartJudged>& judged, const QString& expected, const QString& type, qint64 n) {
            const auto outcome = outcomeOf(judged, expected, type);
            if (!lets(query, outcome, expected, type))
                return;
            counts.inspections += n;
            if (outcome)
                addOutcome(counts, *outcome, expected, n);
        }));
    const QString suspects =
        u"SELECT %1 AS judged, expected_type, type_name, COUNT(*) FROM inspections i WHERE "
        "i.validity = '%2' AND %3 = 'suspect' GROUP BY 1, 2, 3"_s;
    for (const QString& validity : {u"suspect"_s, u""_s}) // of before: the document tells
        RETURN_IF_ERROR(
            forAlike(database,
                     suspects.arg(inspection_table::judgedSql(u"i."_s), validity,
                                  validity.isEmpty() ? inspection_table::validitySql() : u"i.validity"_s),
                     [&](const std::optional<PartJudged>& judged, const QString& expected,
                         const QString& type, qint64 n) {
                         if (lets(query, outcomeOf(judged, expected, type), expected, type))
                             addSuspect(counts, judged, n);
                     }));
    return {};
}

/// `voided`: SQL, 1 for an inspection that does not count.
Expected<HistoryCounts> countAll(Database& database, const HistorySelection& selection, const QString& voided)
{
    HistoryCounts counts;
    Statement statement(database, countingHistory(),
                        u"SELECT COUNT(*), %1 "_s.arg(alikeColumns(voided)) + selection.fromWhere() +
                            u"GROUP BY 2, 3, 4, 5, 6, 7"_s);
    selection.bind(statement);
    RETURN_IF_ERROR(statement.forEach([&](Statement& row) {
        const qint64 count = row.takeInteger();
        counts += takeAlike(row, count);
    }));
    return counts;
}

} // namespace

QString alikeColumns(const QString& voided)
{
    return u"CASE WHEN g.type_id IS NULL THEN 0 ELSE 1 END AS kind, %3 AS verdict, "
           "i.expected_type AS expected, i.type_name AS type, %1 = 'suspect' AS suspect, %2 AS voided"_s.arg(
               historyValiditySql(), voided, inspection_table::judgedSql(u"i."_s));
}

HistoryCounts takeAlike(Statement& row, qint64 count)
{
    HistoryCounts counts;
    (row.takeInteger() != 0 ? counts.enrolled : counts.inspections) = count;
    const auto judged = partJudgedFromString(row.takeText());
    const QString expected = row.takeText();
    const QString type = row.takeText();
    const bool suspect = row.takeInteger() != 0;
    if (row.takeInteger() != 0) {
        counts.voided = count;
        return counts;
    }
    if (judged)
        addOutcome(counts, inspectionOutcome(*judged, type, expected), expected, count);
    if (suspect)
        addSuspect(counts, judged, count);
    return counts;
}

Expected<HistoryCounts> countsOf(Database& database, const HistorySelection& selection)
{
    return countAll(database, selection, historyIsVoidedSql());
}

bool talliesKnow(const HistoryQuery& query)
{
    HistoryQuery others = query;
    others.kind.reset();
    others.outcome.reset();
    others.type.clear();
    others.expected.clear();
    return others.everything();
}

Expected<HistoryCounts> counts(Database& database, const HistoryQuery& query)
{
    HistoryQuery unordered = query;
    unordered.order = HistoryColumn::Time;
    HistorySelection selection(unordered, HistorySelection::Inspections);
    if (!talliesKnow(query))
        return countsOf(database, selection);
    HistoryCounts counts;
    RETURN_IF_ERROR(countTallied(database, query, counts));
    selection.onlyVoided(); // few: taken away from all
    ASSIGN_OR_RETURN(const HistoryCounts voided, countAll(database, selection, u"0"_s));
    for (qint64 HistoryCounts::*outcome :
         {&HistoryCounts::asExpected, &HistoryCounts::otherType, &HistoryCounts::unknown,
          &HistoryCounts::inconclusive, &HistoryCounts::notValid, &HistoryCounts::knownType,
          &HistoryCounts::unasked, &HistoryCounts::suspect, &HistoryCounts::doesNotConform})
        counts.*outcome -= voided.*outcome;
    counts.voided = voided.inspections;
    if (query.kind != SqueezeKind::Inspection && !query.outcome && query.expected.isEmpty()) {
        unordered.kind = SqueezeKind::Enrollment;
        ASSIGN_OR_RETURN(const HistoryCounts enrolled,
                         countsOf(database, HistorySelection(unordered, HistorySelection::Inspections)));
        counts.enrolled = enrolled.enrolled;
    }
    return counts;
}

} // namespace gripscope::history_view
