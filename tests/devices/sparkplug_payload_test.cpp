// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/sparkplug_payload.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;

namespace {

QDateTime at(qint64 milliseconds)
{
    return QDateTime::fromMSecsSinceEpoch(milliseconds, Qt::UTC);
}

SparkplugMetric metric(SparkplugType type, SparkplugMetric::Value value)
{
    SparkplugMetric made;
    made.name = QStringLiteral("A");
    made.type = type;
    made.value = std::move(value);
    return made;
}

} // namespace

/// Golden bytes worked out by hand: a field is (number << 3 | wire type), 0 a varint, 1 eight bytes, 2
/// counted.
class SparkplugPayloadTest : public QObject {
    Q_OBJECT
private slots:
    void everyTypeHasItsField_data()
    {
        QTest::addColumn<quint32>("type");
        QTest::addColumn<int>("value");
        QTest::addColumn<QByteArray>("bytes");
        // 0a 01 41: name "A"; 18 05: timestamp 5; 20 tt: datatype; then the value
        QTest::newRow("UInt16 in int_value (10)") << 6u << 3
                                                  << QByteArray("0a0141"
                                                                "1805"
                                                                "2006"
                                                                "5003");
        QTest::newRow("UInt32 in int_value (10)") << 7u << 300
                                                  << QByteArray("0a0141"
                                                                "1805"
                                                                "2007"
                                                                "50ac02");
        QTest::newRow("UInt64 in long_value (11)") << 8u << 300
                                                   << QByteArray("0a0141"
                                                                 "1805"
                                                                 "2008"
                                                                 "58ac02");
        QTest::newRow("DateTime in long_value (11)") << 13u << 1
                                                     << QByteArray("0a0141"
                                                                   "1805"
                                                                   "200d"
                                                                   "5801");
        QTest::newRow("Double in double_value (13)") << 10u << 1
                                                     << QByteArray("0a0141"
                                                                   "1805"
                                                                   "200a"
                                                                   "69000000000000f03f");
        QTest::newRow("Boolean in boolean_value (14)") << 11u << 1
                                                       << QByteArray("0a0141"
                                                                     "1805"
                                                                     "200b"
                                                                     "7001");
        QTest::newRow("String in string_value (15)") << 12u << 7
                                                     << QByteArray("0a0141"
                                                                   "1805"
                                                                   "200c"
                                                                   "7a0137");
        QTest::newRow("null (7)") << 12u << -1
                                  << QByteArray("0a0141"
                                                "1805"
                                                "200c"
                                                "3801");
    }
    void everyTypeHasItsField()
    {
        QFETCH(quint32, type);
        QFETCH(int, value);
        QFETCH(QByteArray, bytes);
        const auto known = static_cast<SparkplugType>(type);
        SparkplugMetric::Value held = quint64(value);
        if (value < 0)
            held = std::monostate();
        else if (known == SparkplugType::Double)
            held = double(value);
        else if (known == SparkplugType::Boolean)
            held = value != 0;
        else if (known == SparkplugType::String)
            held = QString::number(value);
        SparkplugPayload payload;
        payload.measured = at(5);
        payload.metrics = {metric(known, held)};
        const QByteArray inner = QByteArray::fromHex(bytes);
        // 12 nn: a metric of nn bytes
        QCOMPARE(encoded(payload).toHex(), "12" + QByteArray(1, char(inner.size())).toHex() + bytes);
    }
    void timeSeqAliasAndHistoricalStandWhereTheSpecificationHasThem()
    {
        SparkplugPayload payload;
        payload.sent = at(1);
        payload.measured = at(5);
        payload.seq = 255;
        SparkplugMetric one = metric(SparkplugType::UInt64, quint64(9));
        one.name.clear();
        one.alias = 4;
        one.typed = false;
        one.historical = true;
        payload.metrics = {one};
        // 08 01: timestamp 1; metric: 10 04 alias, 18 05 timestamp, 28 01 is_historical, 58 09; 18 ff 01: seq
        // 255
        QCOMPARE(encoded(payload).toHex(), QByteArray("0801"
                                                      "1208"
                                                      "1004"
                                                      "1805"
                                                      "2801"
                                                      "5809"
                                                      "18ff01"));
    }
    void aWillHasNeitherTimeNorSeq()
    {
        SparkplugPayload payload;
        payload.metrics = {metric(SparkplugType::UInt64, quint64(0))};
        QCOMPARE(encoded(payload).toHex(), QByteArray("1207"
                                                      "0a0141"
                                                      "2008"
                                                      "5800"));
    }
    void seqZeroIsWritten()
    {
        SparkplugPayload payload;
        payload.seq = 0;
        QCOMPARE(encoded(payload).toHex(), QByteArray("1800"));
    }
    void aRebirthIsRead_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("command");
        const QByteArray name = "0a14" + QByteArray("Node Control/Rebirth").toHex();
        const auto metricOf = [](const QByteArray& inner) {
            return "12" + QByteArray(1, char(inner.size() / 2)).toHex() + inner;
        };
        QTest::newRow("true") << "0801" + metricOf(name + "200b7001") << int(NodeCommand::Rebirth);
        QTest::newRow("false") << metricOf(name + "200b7000") << int(NodeCommand::None);
        QTest::newRow("another") << metricOf("0a01417001") << int(NodeCommand::None);
        // Fields 9 (properties) and 17 (a data set) are skipped.
        QTest::newRow("with what is skipped")
            << metricOf(name + "4a020801" + "8a010412020801" + "7001") << int(NodeCommand::Rebirth);
        QTest::newRow("behind another")
            << metricOf("0a01417001") + metricOf(name + "7001") << int(NodeCommand::Rebirth);
        QTest::newRow("nothing") << QByteArray() << int(NodeCommand::None);
        QTest::newRow("torn") << metricOf(name + "7001").chopped(2) << int(NodeCommand::Unreadable);
        QTest::newRow("no protobuf") << QByteArray("ffffffffffffffffffffff") << int(NodeCommand::Unreadable);
    }
    void aRebirthIsRead()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(int, command);
        QCOMPARE(int(decodedCommand(QByteArray::fromHex(bytes))), command);
    }
    void aCommandIsBounded()
    {
        QCOMPARE(int(decodedCommand(QByteArray(longestCommand + 1, '\0'))), int(NodeCommand::Unreadable));
    }
    void aHostSaysHowItIs()
    {
        QVERIFY(decodedHostState(R"({"online":true,"timestamp":1700000000000})") ==
                (HostState{true, 1'700'000'000'000}));
        QVERIFY(decodedHostState(R"({"online":false,"timestamp":1,"more":[1]})") == (HostState{false, 1}));
        for (const char* other : {"", "ONLINE", "[]", R"({"online":"true","timestamp":1})",
                                  R"({"online":true})", R"({"online":true,"timestamp":-5})"})
            QVERIFY2(!decodedHostState(other), other);
        QCOMPARE(hostStateTopic(QStringLiteral("scada")), QStringLiteral("spBv1.0/STATE/scada"));
    }
    void anOlderWillOfAHostThatIsBackChangesNothing()
    {
        PrimaryHost host;
        QVERIFY(!host.online());
        host.hear({true, 100});
        QVERIFY(host.online());
        host.hear({true, 200});
        host.hear({false, 100}); // the will of the connection before
        QVERIFY(host.online());
        host.hear({false, 200});
        QVERIFY(!host.online());
    }
};
GRIPSCOPE_TEST(SparkplugPayloadTest)
#include "sparkplug_payload_test.moc"
