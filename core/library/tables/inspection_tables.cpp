// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/inspection_tables.h"

#include "core/base/words.h"
#include "core/library/ledger/ledgered_tables.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/estimate_tables.h"
#include "core/library/tables/tally_table.h"
#include "core/quality/conformity/conformity_json.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace gripscope::inspection_table {

using namespace Qt::StringLiterals;

namespace {

QString readingInspections()
{
    return Words::tr("read the inspections");
}

const auto selectInspections =
    u"SELECT i.id, i.grasp_id, i.expected_type, i.number, i.inspected_utc, i.verdict, "
    u"i.type_name, i.nearest, i.reasons, "
    "i.operator_name, i.posterior, i.distance, i.gate, e.m, e.b, e.k, g.force_unit, "
    "g.position_unit, i.seconds, COALESCE(o.name, ''), "_s +
    validitySql() +
    u", i.part_number, COALESCE(x.reason, ''), i.conformity, i.adjustment_id, g.device_serial, i.station "
    "FROM inspections i JOIN grasps g ON g.id = i.grasp_id "
    "LEFT JOIN batches o ON o.id = i.batch_id "
    "LEFT JOIN inspection_voids x ON x.inspection_id = i.id "
    "LEFT JOIN estimates e ON e.grasp_id = i.grasp_id AND e.rank = 0 "_s;

template <typename Json>
QString compact(const Json& json)
{
    return QString::fromUtf8(QJsonDocument(json).toJson(QJsonDocument::Compact));
}

QJsonObject toJson(const QMap<QString, double>& posterior)
{
    QJsonObject object;
    for (auto it = posterior.cbegin(); it != posterior.cend(); ++it)
        object.insert(it.key(), it.value());
    return object;
}

QJsonArray toJson(const Findings& reasons)
{
    QJsonArray array;
    for (const Finding& reason : reasons)
        array.append(reason.toJson());
    return array;
}

/// That of the type named, else of the nearest one.
std::optional<double> leadingPosterior(const Verdict& verdict)
{
    const auto it = verdict.posterior.find(verdict.type.isEmpty() ? verdict.nearest : verdict.type);
    return it == verdict.posterior.end() ? std::nullopt : std::optional(*it);
}

InspectionRecord takeInspection(Statement& row)
{
    InspectionRecord inspection;
    inspection.id = row.takeText();
    inspection.graspId = row.takeText();
    inspection.expectedType = row.takeText();
    inspection.number = row.takeInteger();
    inspection.inspected = row.takeUtc();
    inspection.verdict = verdictKindFromString(row.takeText()).value_or(VerdictKind::Invalid);
    inspection.type = row.takeText();
    inspection.nearest = row.takeText();
    inspection.reason = joinReasons(row.takeText());
    inspection.operatorName = row.takeText();
    inspection.posterior = row.takeOptionalReal();
    inspection.distance = row.takeOptionalReal();
    inspection.gate = row.takeOptionalReal();
    inspection.parameters = estimate_table::takeParameters(row);
    inspection.forceUnit = row.takeText();
    inspection.positionUnit = row.takeText();
    inspection.seconds = row.takeReal();
    inspection.batch = row.takeText();
    inspection.suspect = row.takeText() == toString(ValidityVerdict::Suspect);
    inspection.partNumber = row.takeText();
    inspection.voided = row.takeText();
    inspection.conformity = conformityDecisionFromString(row.takeText());
    inspection.adjustmentId = row.takeText();
    inspection.gripperSerial = row.takeText();
    inspection.station = row.takeText();
    return inspection;
}

} // namespace

QString validitySql()
{
    // Words in the document have their quotation marks escaped: only its own field is this.
    const QString document = u"(SELECT d.document FROM documents d WHERE d.grasp_id = i.grasp_id)"_s;
    return u"CASE WHEN i.validity <> '' THEN i.validity WHEN i.verdict = 'invalid' THEN 'invalid' "
           "WHEN %1 LIKE '%\"verdict\":\"suspect\"%' THEN 'suspect' "
           "WHEN %1 LIKE '%\"verdict\":\"valid\"%' THEN 'valid' ELSE '' END"_s.replace("%1"_L1, document);
}

QString judgedSql(const QString& table)
{
    return u"(%1verdict || CASE WHEN %1conformity = '' THEN '' ELSE ' ' || %1conformity END)"_s.arg(table);
}

QString numberThereSql(const QString& id)
{
    return u"COALESCE((SELECT r.number FROM merged_rows r WHERE r.table_code = %1 AND r.row_key = %2 AND "
           "r.is_origin = 1), 0)"_s.arg(int(ledgeredTable(u"inspections"_s)->code))
               .arg(id);
}

Finding joinReasons(const QString& json)
{
    Findings sentences;
    for (const QJsonValue sentence : QJsonDocument::fromJson(json.toUtf8()).array())
        if (std::optional<Finding> finding = Finding::fromJson(sentence))
            sentences.push_back(*std::move(finding));
    return Finding::joined(std::move(sentences), u" "_s);
}

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                      const NewInspection& inspection)
{
    const Verdict& verdict = inspection.verdict;
    Statement row(
        database, Words::tr("store the inspection"),
        u"INSERT INTO inspections (id, station, inspected_utc, number, grasp_id, expected_type, verdict, "
        "type_name, nearest, posterior, distance, gate, samples_used, false_reject, wrong_type, seconds, "
        "operator_name, posteriors, reasons, batch_id, validity, checks_failed, stranger_accept, confidence, "
        "robust, library_version, program, part_number, conformity, conformity_values, adjustment_id) VALUES "
        "(?, ?, ?, "
        "(SELECT COALESCE(MAX(number), 0) + 1 FROM inspections), "
        "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId).bind(inspection.expectedType);
    row.bind(toString(verdict.kind)).bind(verdict.type).bind(verdict.nearest);
    row.bind(leadingPosterior(verdict)).bind(verdict.distance).bind(verdict.gate);
    row.bind(qint64(verdict.samplesUsed)).bind(inspection.rates.falseReject).bind(inspection.rates.wrongType);
    row.bind(inspection.seconds).bind(inspection.grasp.operatorName).bind(compact(toJson(verdict.posterior)));
    row.bind(compact(toJson(verdict.allReasons())));
    row.bindOrNull(inspection.batchId).bind(toString(verdict.validity.verdict));
    row.bind(verdict.validity.checksFailed.join(u' '));
    row.bind(inspection.rates.strangerAccept).bind(inspection.rates.confidence);
    row.bind(inspection.rates.robust ? 1 : 0).bindOptional(inspection.libraryVersion);
    row.bind(estimate_table::programOf(inspection.grasp)).bind(inspection.partNumber);
    const std::optional<Conformity>& conformity = verdict.conformity;
    row.bind(conformity ? toString(conformity->decision) : QString());
    row.bind(conformity ? compact(conformityJson(*conformity)) : QString());
    return row.bind(inspection.adjustmentId).run();
}

Expected<std::optional<InspectionRecord>> find(Database& database, const QString& id)
{
    Statement query(database, readingInspections(), selectInspections + u"WHERE i.id = ?"_s);
    return firstRow(query.bind(id), takeInspection);
}

Expected<std::optional<InspectionRecord>> withNumber(Database& database, qint64 number)
{
    Statement query(database, readingInspections(), selectInspections + u"WHERE i.number = ?"_s);
    return firstRow(query.bind(number), takeInspection);
}

Expected<std::vector<InspectionRecord>> page(Database& database, const HistoryFilter& filter)
{
    // The page is picked by number first and joined afterwards, so that a far page does not join all before
    // it.
    Statement query(database, readingInspections(),
                    selectInspections + u"WHERE i.number IN (SELECT p.number FROM inspections p "
                                        "ORDER BY p.number DESC LIMIT ? OFFSET ?) ORDER BY i.number DESC"_s);
    return allRows(query.bind(std::max(0, filter.limit)).bind(std::max(0, filter.offset)), takeInspection);
}

namespace {

/// `n` inspections that came out so; below 0 they are taken away again.
void add(InspectionCounts& counts, const PartJudged& judged, const QString& expected, const QString& type,
         qint64 n)
{
    using Outcome = InspectionOutcome;
    const Outcome outcome = inspectionOutcome(judged, type, expected);
    const auto ifIs = [outcome, n](Outcome one) { return outcome == one ? n : 0; };
    counts.total += n;
    counts.asExpected += ifIs(Outcome::AsExpected);
    counts.otherType += ifIs(Outcome::OtherType);
    counts.doesNotConform += ifIs(Outcome::DoesNotConform);
    counts.unknown += ifIs(Outcome::Unknown);
    counts.inconclusive += ifIs(Outcome::Inconclusive);
    counts.invalid += ifIs(Outcome::NotValid);
    if (expected.isEmpty()) {
        counts.knownType += ifIs(Outcome::AsExpected);
        counts.unasked += outcome == Outcome::Inconclusive || outcome == Outcome::NotValid ? 0 : n;
    } else if (outcome != Outcome::NotValid) {
        ExpectedCounts& known = counts.expected[expected];
        known.squeezes += n;
        known.otherType += ifIs(Outcome::OtherType);
        known.unknown += ifIs(Outcome::Unknown);
        known.inconclusive += ifIs(Outcome::Inconclusive);
        known.doesNotConform += ifIs(Outcome::DoesNotConform);
    }
}

} // namespace

Expected<InspectionCounts> counts(Database& database, const QString& batchId, qint64 after)
{
    InspectionCounts counts;
    QStringList conditions;
    if (!batchId.isEmpty())
        conditions << u"batch_id = ?"_s;
    if (after > 0) // of this station: what was merged since is not of its shift
        conditions << u"number > ?"_s << numberThereSql(u"inspections.id"_s) + u" = 0"_s;
    const auto count = [&](qint64 sign) {
        const QString where = u"WHERE "_s + conditions.join(u" AND "_s);
        // The verdict in a form that no index is in the order of: it would be gone through from end to end,
        // and the few behind a number looked for in all.
        const QString counted =
            conditions.isEmpty()
                ? tally_table::countedSql()
                : u"(SELECT %2 AS verdict, expected_type, type_name, 1 AS n FROM inspections %1)"_s.arg(
                      where, judgedSql());
        Statement query(database, readingInspections(),
                        u"SELECT verdict, expected_type, type_name, SUM(n) FROM %1 AS counted "
                        "GROUP BY verdict, expected_type, type_name"_s.arg(counted));
        if (!batchId.isEmpty())
            query.bind(batchId);
        if (after > 0)
            query.bind(after);
        return query.forEach([&](Statement& row) {
            const PartJudged judged = partJudgedFromString(row.takeText()).value_or(VerdictKind::Invalid);
            const QString expected = row.takeText();
            const QString type = row.takeText();
            const qint64 n = row.takeInteger();
            add(counts, judged, expected, type, sign * n);
            counts.voided += sign < 0 ? n : 0;
        });
    };
    RETURN_IF_ERROR(count(1));
    // Those that were voided are few: they are taken away from all, which an index alone counts.
    conditions << u"id IN (SELECT inspection_id FROM inspection_voids)"_s;
    RETURN_IF_ERROR(count(-1));
    return counts;
}

} // namespace gripscope::inspection_table

namespace gripscope::void_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const QString& inspectionId, const QString& reason,
                      const QString& operatorName)
{
    const RowStamp stamp = RowStamp::now();
    Statement row(database, Words::tr("void the inspection"),
                  u"INSERT INTO inspection_voids (id, station, voided_utc, inspection_id, operator_name, "
                  "reason) VALUES (?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(inspectionId);
    return row.bind(operatorName).bind(reason).run();
}

} // namespace gripscope::void_table

namespace gripscope::batch_table {

using namespace Qt::StringLiterals;

namespace {

QString readingBatches()
{
    return Words::tr("read the batches");
}

const auto selectBatches = u"SELECT b.id, b.begun_utc, b.name, b.target, b.expected_type, b.operator_name, "
                           u"COALESCE(e.ended_utc, '') "
                           "FROM batches b LEFT JOIN batch_ends e ON e.batch_id = b.id "_s;

/// By the number that SQLite gives each row as it comes, whatever the clock of the station said then.
const auto newestBatchFirst = u"ORDER BY b.rowid DESC "_s;

BatchRecord takeBatch(Statement& row)
{
    BatchRecord batch;
    batch.id = row.takeText();
    batch.begun = row.takeUtc();
    batch.name = row.takeText();
    batch.target = row.takeInteger();
    batch.expectedType = row.takeText();
    batch.operatorName = row.takeText();
    if (const QDateTime ended = row.takeUtc(); ended.isValid())
        batch.ended = ended;
    return batch;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const NewBatch& batch)
{
    Statement row(database, Words::tr("begin the batch"),
                  u"INSERT INTO batches (id, station, begun_utc, name, target, expected_type, operator_name) "
                  "VALUES (?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(batch.name).bind(batch.target);
    return row.bind(batch.expectedType).bind(batch.operatorName).run();
}

Expected<void> insertEnd(Database& database, const QString& batchId, const QString& operatorName)
{
    const RowStamp stamp = RowStamp::now();
    Statement row(database, Words::tr("end the batch"),
                  u"INSERT INTO batch_ends (id, station, ended_utc, batch_id, operator_name) "
                  "VALUES (?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(batchId);
    return row.bind(operatorName).run();
}

Expected<std::optional<BatchRecord>> find(Database& database, const QString& id)
{
    Statement query(database, readingBatches(), selectBatches + u"WHERE b.id = ?"_s);
    return firstRow(query.bind(id), takeBatch);
}

Expected<std::optional<BatchRecord>> underWay(Database& database, const QString& station)
{
    Statement query(database, readingBatches(),
                    selectBatches + u"WHERE b.station = ? AND e.id IS NULL "_s + newestBatchFirst +
                        u"LIMIT 1"_s);
    return firstRow(query.bind(station), takeBatch);
}

Expected<std::vector<BatchRecord>> newest(Database& database, int limit)
{
    Statement query(database, readingBatches(), selectBatches + newestBatchFirst + u"LIMIT ?"_s);
    return allRows(query.bind(std::max(0, limit)), takeBatch);
}

} // namespace gripscope::batch_table
