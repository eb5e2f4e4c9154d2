// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/inspection_tables.h"

#include "core/base/words.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/estimate_tables.h"

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
    "g.position_unit, i.seconds, COALESCE(o.name, ''), "
    // Words in the document have their quotation marks escaped: only its own field is this.
    "CASE WHEN i.validity <> '' THEN i.validity = 'suspect' "
    "WHEN (SELECT d.document FROM documents d WHERE d.grasp_id = i.grasp_id) "
    "LIKE '%\"verdict\":\"suspect\"%' THEN 1 ELSE 0 END "
    "FROM inspections i JOIN grasps g ON g.id = i.grasp_id "
    "LEFT JOIN batches o ON o.id = i.batch_id "
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
    inspection.suspect = row.takeInteger() != 0;
    return inspection;
}

} // namespace

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
        "operator_name, posteriors, reasons, batch_id, validity) VALUES (?, ?, ?, "
        "(SELECT COALESCE(MAX(number), 0) + 1 FROM inspections), "
        "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId).bind(inspection.expectedType);
    row.bind(toString(verdict.kind)).bind(verdict.type).bind(verdict.nearest);
    row.bind(leadingPosterior(verdict)).bind(verdict.distance).bind(verdict.gate);
    row.bind(qint64(verdict.samplesUsed)).bind(inspection.rates.falseReject).bind(inspection.rates.wrongType);
    row.bind(inspection.seconds).bind(inspection.grasp.operatorName).bind(compact(toJson(verdict.posterior)));
    row.bind(compact(toJson(verdict.allReasons())));
    return row.bindOrNull(inspection.batchId).bind(toString(verdict.validity.verdict)).run();
}

Expected<std::optional<InspectionRecord>> find(Database& database, const QString& id)
{
    Statement query(database, readingInspections(), selectInspections + u"WHERE i.id = ?"_s);
    return firstRow(query.bind(id), takeInspection);
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

Expected<InspectionCounts> counts(Database& database, const QString& batchId)
{
    InspectionCounts counts;
    const QString batch = batchId.isEmpty() ? u""_s : u"WHERE batch_id = ? "_s;
    Statement query(database, readingInspections(),
                    u"SELECT verdict, expected_type, type_name, COUNT(*) FROM inspections "_s + batch +
                        u"GROUP BY verdict, expected_type, type_name"_s);
    if (!batchId.isEmpty())
        query.bind(batchId);
    auto done = query.forEach([&](Statement& row) {
        const auto verdict = verdictKindFromString(row.takeText()).value_or(VerdictKind::Invalid);
        const QString expected = row.takeText();
        const QString type = row.takeText();
        const qint64 n = row.takeInteger();
        counts.total += n;
        if (!expected.isEmpty() && verdict != VerdictKind::Invalid) {
            ExpectedCounts& known = counts.expected[expected];
            known.squeezes += n;
            known.otherType += verdict == VerdictKind::Type && type != expected ? n : 0;
            known.unknown += verdict == VerdictKind::Unknown ? n : 0;
        }
        switch (verdict) {
        case VerdictKind::Type:
            (expected.isEmpty() || expected == type ? counts.asExpected : counts.otherType) += n;
            break;
        case VerdictKind::Unknown:
            counts.unknown += n;
            break;
        case VerdictKind::Inconclusive:
            counts.inconclusive += n;
            break;
        case VerdictKind::Invalid:
            counts.invalid += n;
            break;
        }
    });
    if (!done)
        return tl::unexpected(done.error());
    return counts;
}

} // namespace gripscope::inspection_table

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
                    selectBatches +
                        u"WHERE b.station = ? AND e.id IS NULL ORDER BY b.begun_utc DESC, b.id DESC "
                        "LIMIT 1"_s);
    return firstRow(query.bind(station), takeBatch);
}

Expected<std::vector<BatchRecord>> newest(Database& database, int limit)
{
    Statement query(database, readingBatches(),
                    selectBatches + u"ORDER BY b.begun_utc DESC, b.id DESC LIMIT ?"_s);
    return allRows(query.bind(std::max(0, limit)), takeBatch);
}

} // namespace gripscope::batch_table
