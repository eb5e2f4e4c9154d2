// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/report_json.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include <valijson/adapters/qtjson_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// The first block of JSON on the manual's page about the plant.
QJsonObject schemaOfTheManual(const QString& page)
{
    QFile file(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/resources/manual/") + page);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray text = file.readAll();
    const qsizetype begin = text.indexOf("\n    {\n"), end = text.indexOf("\n    }\n", begin);
    return QJsonDocument::fromJson(text.mid(begin, end + 6 - begin)).object();
}

bool holds(const QJsonObject& schemaDocument, const QJsonValue& value)
{
    const QJsonValue document = schemaDocument;
    valijson::Schema schema;
    valijson::SchemaParser().populateSchema(valijson::adapters::QtJsonAdapter(document), schema);
    return valijson::Validator().validate(schema, valijson::adapters::QtJsonAdapter(value), nullptr);
}

QJsonObject messageOf(const LineReport& report, bool historical)
{
    return QJsonDocument::fromJson(reportJson(report, historical)).object();
}

/// Each word that a message may hold, and each value that may be missing.
std::vector<LineReport> allKinds()
{
    LineReport whole;
    whole.sequence = 7;
    whole.gripper = u"G1"_s;
    whole.part = u"P1"_s;
    whole.expectedType = whole.typeFound = u"Dose \"5\""_s;
    whole.result.utc = QDateTime::fromMSecsSinceEpoch(1'700'000'000'123, Qt::UTC);
    for (auto& quantity : whole.result.quantities)
        quantity = LineQuantity{0.5, 0.01};
    whole.clock = ClockStanding{-0.25, 1e-3};
    std::vector<LineReport> all;
    for (const ResultState state : {ResultState::Completed, ResultState::Aborted, ResultState::Failed})
        for (const ResultEvaluation evaluation :
             {ResultEvaluation::Ok, ResultEvaluation::NotOk, ResultEvaluation::NotDecidable})
            for (int reason = int(ResultReason::AsExpected); reason <= int(ResultReason::NotMeasured);
                 ++reason) {
                LineReport one = whole;
                one.result.state = state;
                one.result.evaluation = evaluation;
                one.result.reason = ResultReason(reason);
                all.push_back(one);
                one.part = one.expectedType = one.typeFound = QString();
                one.result.quantities = {};
                one.clock.reset();
                one.result.partial = one.result.simulated = true;
                all.push_back(one);
            }
    return all;
}

} // namespace

class ReportSchemaTest : public QObject {
    Q_OBJECT
private slots:
    void everyMessageIsAsTheManualHasIt()
    {
        const QJsonObject schema = schemaOfTheManual(u"plant.md"_s);
        QVERIFY(schema.contains(u"properties"));
        QCOMPARE(schemaOfTheManual(u"de/plant.md"_s), schema);
        for (const LineReport& report : allKinds())
            for (const bool historical : {false, true}) {
                const QJsonObject message = messageOf(report, historical);
                QVERIFY2(holds(schema, message), reportJson(report, historical).constData());
                for (auto value = message.begin(); value != message.end(); ++value)
                    QVERIFY2(schema[u"properties"][value.key()].isObject(), qPrintable(value.key()));
            }
    }
    void whatWaitsInAFileIsReadAsItWas()
    {
        for (const LineReport& report : allKinds())
            QVERIFY(reportFromJson(reportJson(report, true)) == report);
        // Of a program that did not know the clock.
        QJsonObject older = messageOf(allKinds().front(), false);
        older.remove(u"clock"_s);
        const auto read = reportFromJson(QJsonDocument(older).toJson());
        QVERIFY(read.has_value() && !read->clock);
    }
    void whatIsNotAsTheManualHasItIsTold()
    {
        const QJsonObject schema = schemaOfTheManual(u"plant.md"_s);
        const QJsonObject message = messageOf(allKinds().front(), false);
        for (const QString& key : message.keys()) {
            QJsonObject without = message, wrong = message;
            without.remove(key);
            wrong[key] = QJsonArray{1};
            QVERIFY2(!holds(schema, without) && !holds(schema, wrong), qPrintable(key));
        }
    }
};

GRIPSCOPE_TEST(ReportSchemaTest)
#include "report_schema_test.moc"
