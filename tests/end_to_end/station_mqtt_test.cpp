// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/line_values.h"
#include "tests/devices/mqtt_broker.h"
#include "tests/end_to_end/small_plc.h"
#include "tests/end_to_end/station_console.h"
#include "tests/support/mqtt_reader.h"
#include "tests/support/test_registry.h"

#include <csignal>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// gripscope-station with a virtual gripper, a PLC and a broker.
class MqttStationRun {
public:
    MqttStationRun(const Workplace& work, std::uint16_t broker) : m_work(work), m_port(freePort())
    {
        work.prepare(m_station,
                     {u"--library"_s, work.path(u"parts.db"_s), u"--address"_s,
                      u"virtual:?object=A&seed=7&speed=0"_s, u"--modbus"_s, u"127.0.0.1:%1"_s.arg(m_port),
                      u"--console"_s, work.path(u"console"_s), u"--heartbeat"_s, u"60"_s, u"--mqtt"_s,
                      u"127.0.0.1:%1"_s.arg(broker), u"--mqtt-topic"_s, u"plant/results"_s});
        m_station.setProgram(stationProgram());
        m_station.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_station.start();
    }
    ~MqttStationRun() { kill(); }
    MqttStationRun(const MqttStationRun&) = delete;
    MqttStationRun& operator=(const MqttStationRun&) = delete;

    [[nodiscard]] ProgramRun ask(const QString& command) const { return askStation(m_work, command); }
    [[nodiscard]] bool says(const QString& key, const QString& words) const
    {
        return QTest::qWaitFor([&] { return ask(u"status"_s).json()[key].toString().contains(words); },
                               longEnough_ms);
    }
    [[nodiscard]] bool arm()
    {
        return says(u"state"_s, u"Initialized"_s) && m_plc.connectTo(m_port) && m_plc.write(0, 0) &&
               ask(u"arm"_s).exit == 0 && says(u"state"_s, u"Ready"_s);
    }
    /// The part of this token; its result is acknowledged.
    [[nodiscard]] bool inspect(std::uint32_t token)
    {
        const std::uint16_t trigger = ++m_trigger;
        std::vector<std::uint16_t> seen;
        const bool done =
            m_plc.write(trigger, token) && QTest::qWaitFor(
                                               [&] {
                                                   seen = m_plc.read();
                                                   return seen.size() == 48 && seen[23] == token;
                                               },
                                               longEnough_ms);
        return done && m_plc.write(trigger, token, (std::uint32_t(seen[20]) << 16) + seen[21]);
    }
    void kill()
    {
        m_station.kill();
        m_station.waitForFinished(longEnough_ms);
    }

private:
    const Workplace& m_work;
    std::uint16_t m_port;
    QProcess m_station;
    SmallPlc m_plc;
    std::uint16_t m_trigger = 0;
};

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
            MqttStationRun station(work, broker.port());
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
        MqttStationRun station(work, broker.port());
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
