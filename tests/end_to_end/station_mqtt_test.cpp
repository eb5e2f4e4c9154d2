// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/mqtt_broker.h"
#include "tests/end_to_end/station_run.h"
#include "tests/support/mqtt_reader.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

QStringList toBroker(const Broker& broker)
{
    return {u"--mqtt"_s, u"127.0.0.1:%1"_s.arg(broker.port()), u"--mqtt-topic"_s, u"plant/results"_s};
}

} // namespace

/// gripscope-station and a broker, read by a client of its own.
class StationMqttTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsMeasuredArrivesThoughTheStationIsKilledAndTheBrokerWasAway()
    {
        const Workplace work;
        QCOMPARE(work.cli({u"library"_s, u"examples"_s, u"--library"_s, work.path(u"parts.db"_s)}).exit, 0);
        Broker broker;
        QVERIFY(broker.start());
        MqttReader reader(broker.port(), u"plant/results"_s);
        QVERIFY2(reader.subscribed(), "mosquitto-clients is missing, or see above");
        {
            StationRun station(work, toBroker(broker));
            QVERIFY(station.arm());
            QVERIFY(station.says(u"mqtt"_s, u"MQTT: connected"_s));
            QVERIFY(station.inspect(4711));
            QCOMPARE(reader.messages(1).size(), std::size_t(1));
            broker.stop();
            QVERIFY(station.says(u"mqtt"_s, u"not connected"_s));
            QVERIFY(station.inspect(4712));
            QVERIFY(station.says(u"mqtt"_s, u"1 waiting"_s));
            station.kill();
        }
        QVERIFY(broker.start());
        StationRun station(work, toBroker(broker));
        const std::vector<QJsonObject> seen = reader.messages(2);
        QCOMPARE(seen.size(), std::size_t(2));
        QCOMPARE(seen[0][u"part"_s].toString(), u"4711"_s);
        QCOMPARE(seen[0][u"historical"_s].toBool(true), false);
        QCOMPARE(seen[0][u"gripper"_s].toString(), u"VG-7"_s);
        QCOMPARE(seen[0][u"type"_s].toString(), u"A"_s);
        QCOMPARE(seen[0][u"simulated"_s].toBool(), true);
        QCOMPARE(seen[1][u"part"_s].toString(), u"4712"_s);
        QCOMPARE(seen[1][u"historical"_s].toBool(), true);
        QCOMPARE(seen[1][u"sequence"_s].toInt(), seen[0][u"sequence"_s].toInt() + 1);
        QVERIFY(station.says(u"mqtt"_s, u"0 waiting"_s));
    }
};

GRIPSCOPE_TEST(StationMqttTest)
#include "station_mqtt_test.moc"
