// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/mqtt_session.h"
#include "tests/devices/sparkplug_reader.h"
#include "tests/support/test_registry.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

const QDateTime sessionTime = QDateTime::fromMSecsSinceEpoch(1'700'000'000'000, Qt::UTC);

/// A broker that answers when it is told to.
class PlayedWire : public MqttWire {
public:
    int publish(const MqttMessage& message) override
    {
        sent.push_back(message);
        return ++packets;
    }
    int subscribe(const QString& topic) override
    {
        subscribed << topic;
        return ++packets;
    }
    int askForReceipt() override { return ++packets; }
    QStringList takeKinds()
    {
        QStringList kinds;
        for (const MqttMessage& message : std::exchange(sent, {}))
            kinds << (message.topic.startsWith(u"spBv1.0"_s) ? message.topic.section(u'/', 2, 2) : u"JSON"_s);
        return kinds;
    }
    std::vector<MqttMessage> sent;
    QStringList subscribed;
    int packets = 0;
};

MqttOptions sessionOptions(const QString& jsonTopic, const QString& host)
{
    MqttOptions options;
    options.host = u"broker"_s;
    options.jsonTopic = jsonTopic;
    options.group = u"plant"_s;
    options.node = u"station"_s;
    options.primaryHost = host;
    return options;
}

std::vector<LineReport> reportsTo(quint64 from, quint64 to)
{
    std::vector<LineReport> reports;
    for (quint64 sequence = from; sequence <= to; ++sequence) {
        LineReport report;
        report.sequence = sequence;
        report.gripper = u"G1"_s;
        report.result.utc = sessionTime;
        reports.push_back(report);
    }
    return reports;
}

struct Played {
    explicit Played(const QString& jsonTopic = {}, const QString& host = {})
        : session(sessionOptions(jsonTopic, host), 3, wire)
    {
    }
    void step(quint64 newest = 0) { session.step(u"G1"_s, newest, sessionTime); }
    void connect()
    {
        session.connected();
        for (int packet = 1; packet <= wire.subscribed.size(); ++packet)
            session.subscribed(packet);
    }
    void say(bool online, qint64 timestamp)
    {
        session.heard(u"spBv1.0/STATE/scada"_s,
                      online ? QStringLiteral(R"({"online":true,"timestamp":%1})").arg(timestamp).toUtf8()
                             : QStringLiteral(R"({"online":false,"timestamp":%1})").arg(timestamp).toUtf8());
    }
    PlayedWire wire;
    MqttSession session;
};

const QString commands = u"spBv1.0/plant/NCMD/station"_s;
const QByteArray rebirthCommand = QByteArray::fromHex("1218"
                                                      "0a14" +
                                                      QByteArray("Node Control/Rebirth").toHex() + "7001");

} // namespace

class MqttSessionTest : public QObject {
    Q_OBJECT
private slots:
    void birthsWaitForTheSubscriptions()
    {
        Played played;
        played.step();
        played.session.connected();
        QCOMPARE(played.wire.subscribed, QStringList{commands});
        played.step();
        QVERIFY(played.wire.sent.empty() && !played.session.ready());
        played.session.subscribed(1);
        played.step();
        QCOMPARE(played.wire.takeKinds(), (QStringList{u"NBIRTH"_s, u"DBIRTH"_s}));
        QVERIFY(played.session.ready());
    }
    void birthsWaitForThePrimaryHost()
    {
        Played played({}, u"scada"_s);
        played.connect();
        QCOMPARE(played.wire.subscribed, (QStringList{commands, u"spBv1.0/STATE/scada"_s}));
        played.step(7);
        played.say(false, 100);
        played.step(7);
        QVERIFY(played.session.waitsForHost() && played.session.room() == 0);
        played.say(true, 200);
        played.step(8);
        QCOMPARE(played.wire.takeKinds(), (QStringList{u"NBIRTH"_s, u"DBIRTH"_s}));
        QVERIFY(!played.session.waitsForHost());
    }
    void aPrimaryHostThatGoesEndsTheSession()
    {
        Played played({}, u"scada"_s);
        played.connect();
        played.say(true, 200);
        played.step();
        static_cast<void>(played.wire.takeKinds());
        played.say(false, 100); // the will of the connection before
        played.step();
        QVERIFY(played.wire.sent.empty() && !played.session.left());
        played.say(false, 200);
        played.step();
        QCOMPARE(played.wire.takeKinds(), QStringList{u"NDEATH"_s});
        QVERIFY(played.session.left() && played.session.room() == 0);
        played.step();
        QVERIFY(played.wire.sent.empty());
    }
    void aNodeThatLeavesSaysSo()
    {
        Played played;
        played.connect();
        played.step();
        static_cast<void>(played.wire.takeKinds());
        played.session.leave();
        QCOMPARE(played.wire.sent.front(), *played.session.will());
    }
    void aRebirthComesOnCommand()
    {
        Played played;
        played.connect();
        played.step();
        static_cast<void>(played.wire.takeKinds());
        played.session.heard(commands, "no protobuf");
        played.session.heard(u"spBv1.0/plant/NCMD/another"_s, rebirthCommand);
        played.step();
        QVERIFY(played.wire.sent.empty());
        for (int i = 0; i < 100; ++i) // many at once are answered once
            played.session.heard(commands, rebirthCommand);
        played.step();
        QCOMPARE(*seqOf(played.wire.sent.front().payload), 0u);
        QCOMPARE(metricNamed(played.wire.sent.front().payload, "bdSeq")->numbers[11], 3u);
        QCOMPARE(played.wire.takeKinds(), (QStringList{u"NBIRTH"_s, u"DBIRTH"_s}));
        played.step();
        QVERIFY(played.wire.sent.empty());
    }
    void whatWaitedIsHistorical()
    {
        Played played(u"results"_s);
        played.connect();
        played.step(2);
        static_cast<void>(played.wire.takeKinds());
        played.session.send(reportsTo(1, 3), sessionTime);
        QCOMPARE(played.wire.sent.size(), 6u); // DDATA and JSON of each
        for (std::size_t i = 0; i < 3; ++i) {
            const bool waited = i < 2;
            const WireFields data = wireFields(played.wire.sent[2 * i].payload);
            QCOMPARE(wireFields(data.metrics[0]).numbers.value(5), waited ? 1u : 0u);
            const QJsonObject json = QJsonDocument::fromJson(played.wire.sent[2 * i + 1].payload).object();
            QCOMPARE(json[u"historical"_s].toBool(), waited);
            QCOMPARE(played.wire.sent[2 * i + 1].qos, 1);
        }
    }
    void aResultIsForgottenOnlyOnceItIsAcknowledged()
    {
        Played played(u"results"_s);
        played.connect();
        played.step();
        played.session.send(reportsTo(1, 3), sessionTime);
        const int last = played.wire.packets;
        QCOMPARE(played.session.acknowledgedTo(), 0u);
        played.session.acknowledged(last - 1); // a DDATA: that it was written says nothing
        QCOMPARE(played.session.acknowledgedTo(), 0u);
        played.session.acknowledged(last - 2);
        QCOMPARE(played.session.acknowledgedTo(), 2u);
        QVERIFY(!played.session.allAcknowledged());
        played.session.acknowledged(last);
        QCOMPARE(played.session.acknowledgedTo(), 3u);
        QVERIFY(played.session.allAcknowledged());
    }
    void withoutJsonAReceiptBehindThemCounts()
    {
        Played played;
        played.connect();
        played.step();
        played.session.send(reportsTo(1, 3), sessionTime);
        played.session.acknowledged(played.wire.packets);
        QCOMPARE(played.session.acknowledgedTo(), 3u);
    }
    void noMoreIsInFlightThanIsAllowed()
    {
        Played played(u"results"_s);
        QCOMPARE(played.session.room(), 0u); // not ready
        played.connect();
        played.step();
        QCOMPARE(played.session.room(), MqttSession::mostInFlight);
        played.session.send(reportsTo(1, MqttSession::mostInFlight), sessionTime);
        QCOMPARE(played.session.room(), 0u);
        played.session.acknowledged(played.wire.packets);
        QCOMPARE(played.session.room(), MqttSession::mostInFlight);
    }
};
GRIPSCOPE_TEST(MqttSessionTest)
#include "mqtt_session_test.moc"
