// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/sparkplug_node.h"
#include "tests/devices/sparkplug_reader.h"
#include "tests/support/test_registry.h"

#include <QSet>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

const QDateTime someTime = QDateTime::fromMSecsSinceEpoch(1'700'000'000'000, Qt::UTC);

LineReport reportOf(const QString& gripper, quint64 sequence)
{
    LineReport report;
    report.sequence = sequence;
    report.gripper = gripper;
    report.typeFound = QStringLiteral("cola can");
    report.result.state = ResultState::Completed;
    report.result.evaluation = ResultEvaluation::Ok;
    report.result.reason = ResultReason::AsExpected;
    report.result.quantities[0] = LineQuantity{0.5, {}};
    report.result.utc = someTime.addSecs(-5);
    return report;
}

SparkplugNode someNode()
{
    return {QStringLiteral("plant"), QStringLiteral("station 1"), 7};
}

QStringList topicsOf(const std::vector<MqttMessage>& messages)
{
    QStringList topics;
    for (const MqttMessage& message : messages)
        topics << message.topic.section(u'/', 2);
    return topics;
}

} // namespace

class SparkplugNodeTest : public QObject {
    Q_OBJECT
private slots:
    void theWillIsTheDeathOfItsBirth()
    {
        SparkplugNode node = someNode();
        const MqttMessage will = node.death();
        QCOMPARE(will.topic, QStringLiteral("spBv1.0/plant/NDEATH/station 1"));
        QCOMPARE(will.qos, 1);
        QVERIFY(!will.retain);
        QVERIFY(!seqOf(will.payload));
        QCOMPARE(metricNamed(will.payload, "bdSeq")->numbers[11], 7u);
        const std::vector<MqttMessage> births = node.births(someTime);
        QCOMPARE(metricNamed(births.front().payload, "bdSeq")->numbers[11], 7u);
        QCOMPARE(metricNamed(births.front().payload, "bdSeq")->numbers[4], 8u); // UInt64
    }
    void aNodeIsBornFirstAndWithSeqZero()
    {
        SparkplugNode node = someNode();
        QVERIFY(node.setGripper(QStringLiteral("G1"), someTime).empty());
        const std::vector<MqttMessage> births = node.births(someTime);
        QCOMPARE(topicsOf(births), (QStringList{u"NBIRTH/station 1"_s, u"DBIRTH/station 1/G1"_s}));
        for (std::size_t i = 0; i < births.size(); ++i) {
            QCOMPARE(*seqOf(births[i].payload), i);
            QCOMPARE(wireFields(births[i].payload).numbers[1], 1'700'000'000'000u);
            QCOMPARE(births[i].qos, 0);
            QVERIFY(!births[i].retain);
        }
        const auto rebirth = metricNamed(births.front().payload, "Node Control/Rebirth");
        QCOMPARE(rebirth->numbers[4], 11u); // Boolean
        QCOMPARE(rebirth->numbers[14], 0u); // false
        QCOMPARE(node.commandTopic(), QStringLiteral("spBv1.0/plant/NCMD/station 1"));
    }
    void aBirthNamesTypesAndAliasesAllThatDataHas()
    {
        SparkplugNode node = someNode();
        static_cast<void>(node.setGripper(QStringLiteral("G1"), someTime));
        const std::vector<MqttMessage> births = node.births(someTime);
        QMap<quint64, WireFields> born;
        for (const QByteArray& bytes : wireFields(births[1].payload).metrics) {
            const WireFields metric = wireFields(bytes);
            QVERIFY(!metric.texts.value(1).isEmpty());
            QVERIFY(metric.numbers.contains(4) && metric.numbers.contains(3));
            QVERIFY(metric.numbers.contains(7)); // null: there was no result yet
            QVERIFY(!born.contains(metric.numbers[2]));
            born[metric.numbers[2]] = metric;
        }
        const std::vector<MqttMessage> data = node.data(reportOf(QStringLiteral("G1"), 41), false, someTime);
        QCOMPARE(topicsOf(data), QStringList{u"DDATA/station 1/G1"_s});
        QCOMPARE(*seqOf(data[0].payload), 2u);
        QCOMPARE(wireFields(data[0].payload).metrics.size(), std::size_t(born.size()));
        for (const QByteArray& bytes : wireFields(data[0].payload).metrics) {
            const WireFields metric = wireFields(bytes);
            QVERIFY(!metric.texts.contains(1)); // the alias stands for the name
            QVERIFY(born.contains(metric.numbers[2]));
            QCOMPARE(metric.numbers[3], 1'699'999'995'000u); // when it was judged
            QVERIFY(!metric.numbers.contains(5));
            if (born[metric.numbers[2]].texts[1] == "Sequence")
                QCOMPARE(metric.numbers[11], 41u);
            if (born[metric.numbers[2]].texts[1] == "Mass")
                QCOMPARE(metric.numbers[13], 0x3fe0000000000000u); // 0.5
        }
    }
    void aRebirthTellsTheLastValues()
    {
        SparkplugNode node = someNode();
        static_cast<void>(node.setGripper(QStringLiteral("G1"), someTime));
        static_cast<void>(node.births(someTime));
        static_cast<void>(node.data(reportOf(QStringLiteral("G1"), 41), false, someTime));
        const std::vector<MqttMessage> again = node.births(someTime);
        QCOMPARE(*seqOf(again[0].payload), 0u);
        QCOMPARE(metricNamed(again[0].payload, "bdSeq")->numbers[11], 7u); // of the same session
        QCOMPARE(metricNamed(again[1].payload, "Sequence")->numbers[11], 41u);
        QCOMPARE(metricNamed(again[1].payload, "Type")->texts[15], QByteArray("cola can"));
    }
    void seqGoesOnOverNodeAndDevicesTo255()
    {
        SparkplugNode node = someNode();
        static_cast<void>(node.setGripper(QStringLiteral("G1"), someTime));
        quint64 next = node.births(someTime).size();
        for (int i = 0; i < 600; ++i) {
            std::vector<MqttMessage> messages =
                node.data(reportOf(QStringLiteral("G1"), quint64(i)), false, someTime);
            if (i % 7 == 0)
                for (const char* gripper : {"", "G1"})
                    for (const MqttMessage& one : node.setGripper(QString::fromLatin1(gripper), someTime))
                        messages.push_back(one);
            for (const MqttMessage& one : messages)
                QCOMPARE(*seqOf(one.payload), next++ % 256);
        }
    }
    void aGripperThatGoesDies()
    {
        SparkplugNode node = someNode();
        static_cast<void>(node.setGripper(QStringLiteral("G1"), someTime));
        static_cast<void>(node.births(someTime));
        const auto changed = node.setGripper(QStringLiteral("G2"), someTime);
        QCOMPARE(topicsOf(changed), (QStringList{u"DDEATH/station 1/G1"_s, u"DBIRTH/station 1/G2"_s}));
        QVERIFY(wireFields(changed[0].payload).numbers.contains(1));
        QCOMPARE(topicsOf(node.births(someTime)),
                 (QStringList{u"NBIRTH/station 1"_s, u"DBIRTH/station 1/G2"_s}));
        QVERIFY(node.setGripper(QStringLiteral("G2"), someTime).empty());
    }
    void aResultOfAGripperThatIsGoneIsBornAndBuried()
    {
        SparkplugNode node = someNode();
        static_cast<void>(node.setGripper(QStringLiteral("G2"), someTime));
        const auto births = node.births(someTime);
        const auto data = node.data(reportOf(QStringLiteral("G1"), 1), true, someTime);
        QCOMPARE(topicsOf(data), (QStringList{u"DBIRTH/station 1/G1"_s, u"DDATA/station 1/G1"_s}));
        for (const QByteArray& metric : wireFields(data[1].payload).metrics)
            QCOMPARE(wireFields(metric).numbers[5], 1u); // is_historical
        QSet<quint64> aliases;                           // unlike over all devices
        for (const QByteArray& payload : {births[1].payload, data[0].payload})
            for (const QByteArray& metric : wireFields(payload).metrics) {
                const quint64 alias = wireFields(metric).numbers[2];
                QVERIFY(!aliases.contains(alias));
                aliases << alias;
            }
        QCOMPARE(topicsOf(node.settle(someTime)), QStringList{u"DDEATH/station 1/G1"_s});
        QVERIFY(node.settle(someTime).empty());
    }
    void namesOfDevicesFitIntoATopic()
    {
        QCOMPARE(SparkplugNode::deviceName(QStringLiteral("a/b+c#d")), QStringLiteral("a_b_c_d"));
        QCOMPARE(SparkplugNode::deviceName(QString()), QStringLiteral("gripper"));
    }
};
GRIPSCOPE_TEST(SparkplugNodeTest)
#include "sparkplug_node_test.moc"
