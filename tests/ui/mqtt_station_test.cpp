// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/mqtt_broker.h"
#include "tests/support/mqtt_reader.h"
#include "tests/ui/inspecting.h"
#include "ui/line/line_station.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/window_bars.h"

using namespace gripscope;
using namespace gripscope::test;
using namespace gripscope::test::inspecting;

/// A window that sends what is inspected to a broker.
class MqttStationTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsMissingInTheSettingsIsSaid()
    {
        const WindowFixture f;
        const MqttStation& station = MqttStation::of(*f.bench);
        QVERIFY(!station.on());
        Settings& settings = f.bench->settings();
        settings.set(setting::mqttOn, true);
        QVERIFY(station.on());
        const auto problem = [&station] { return station.words().problems.at(0).describe(); };
        QVERIFY2(problem().contains(u"name or address of a broker"_s), qPrintable(problem()));
        settings.set(setting::mqttBroker, u"broker.example:many"_s);
        QVERIFY2(problem().contains(u"broker.example:many"_s), qPrintable(problem()));
        settings.set(setting::mqttBroker, u"127.0.0.1:1"_s);
        QVERIFY2(problem().contains(u"topic for JSON"_s), qPrintable(problem()));
        settings.set(setting::mqttOn, false);
        QCOMPARE(station.words().headline.describe(), u"MQTT: off"_s);
    }
    void aSqueezeByAPersonArrivesAndTheStatusLineSaysHowItStands()
    {
        Broker broker;
        QVERIFY(broker.start());
        MqttReader reader(broker.port(), u"plant/results"_s);
        QVERIFY2(reader.subscribed(), "mosquitto-clients is missing, or see above");
        Armed armed;
        WindowFixture& f = armed.f;
        squeezeBySpace(f); // before it is switched on: not sent
        Settings& settings = f.bench->settings();
        settings.set(setting::mqttBroker, u"127.0.0.1:%1"_s.arg(broker.port()));
        settings.set(setting::mqttTopic, u"plant/results"_s);
        settings.set(setting::mqttOn, true);
        const MqttStation& station = MqttStation::of(*f.bench);
        QTRY_VERIFY_WITH_TIMEOUT(station.words().well, longEnough_ms);
        squeezeBySpace(f);
        const std::vector<QJsonObject> seen = reader.messages(1);
        QCOMPARE(seen.size(), std::size_t(1));
        QCOMPARE(seen[0][u"sequence"_s].toInt(), 1);
        QCOMPARE(seen[0][u"type"_s].toString(), u"A"_s);
        broker.stop();
        QTRY_VERIFY_WITH_TIMEOUT(!station.words().well, longEnough_ms);
        squeezeBySpace(f); // not in the way
        QTRY_VERIFY_WITH_TIMEOUT(station.words().headline.describe().contains(u"1 waiting"_s), longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(
            f.window->findChild<StatusLine*>()->text().contains(u"MQTT: not connected"_s), longEnough_ms);
    }
    /// Of this station and its network: no other station gets them by a file.
    void noExportHoldsTheBroker()
    {
        const WindowFixture f;
        f.bench->settings().set(setting::mqttUser, u"station1"_s);
        for (const Setting& one : allSettings())
            if (QLatin1StringView(one.key).startsWith("mqtt/"_L1))
                QVERIFY2(!one.portable && one.needsSupervisor && one.needsReason, one.key);
    }
};

GRIPSCOPE_TEST(MqttStationTest)
#include "mqtt_station_test.moc"
