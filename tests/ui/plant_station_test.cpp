// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/plant_server.h"
#include "tests/ui/inspecting.h"
#include "ui/line/line_station.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/window_bars.h"

using namespace gripscope;
using namespace gripscope::test;
using namespace gripscope::test::inspecting;

/// A window whose library is kept in step with its plant's.
class PlantStationTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsNoServerIsNoSetting()
    {
        const WindowFixture f;
        const PlantStation& station = PlantStation::of(*f.bench);
        QVERIFY(!station.on());
        const QString key = QString::fromLatin1(setting::plantServer.key);
        for (const QString& no : {u"other.db"_s, u"postgresql://a:secret@host/plant"_s, u"postgresql://"_s})
            QVERIFY2(!f.bench->settings().setValue(key, no), qPrintable(no));
        QVERIFY(!station.on());
        QCOMPARE(station.words().headline.describe(), u"plant: off"_s);
    }
    void whatIsInspectedGoesThereAndTypesOfAnotherStationAreInForce()
    {
        const PlantServer server;
        Armed armed;
        WindowFixture& f = armed.f;
        f.bench->settings().set(setting::plantServer, server.address());
        const PlantStation& station = PlantStation::of(*f.bench);
        QTRY_VERIFY_WITH_TIMEOUT(station.words().well, longEnough_ms);
        squeezeBySpace(f);
        const auto plant = Library::open(server.address());
        QVERIFY(plant.has_value());
        QTRY_COMPARE_WITH_TIMEOUT((*plant)->inspectionCounts().value_or(InspectionCounts()).total, 1,
                                  longEnough_ms);
        const auto types = f.bench->inspection().types().size();
        QVERIFY(
            (*plant)->retireType((*plant)->findType(u"B"_s)->value().id, {u"Ada"_s, u"no longer made"_s}));
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().types().size(), types - 1, longEnough_ms);
        server.pause();
        squeezeBySpace(f); // not in the way
        server.resume();
        server.halt();
        squeezeBySpace(f);
        auto* line = f.window->findChild<StatusLine*>();
        QTRY_VERIFY_WITH_TIMEOUT(line->text().contains(u"server not reached since"_s), longEnough_ms);
        QVERIFY(!station.words().well);
        server.go();
        QTRY_COMPARE_WITH_TIMEOUT(station.words().headline.describe(), u"plant: in step"_s, longEnough_ms);
        QTRY_COMPARE_WITH_TIMEOUT((*plant)->inspectionCounts().value_or(InspectionCounts()).total, 3,
                                  longEnough_ms);
    }
};
GRIPSCOPE_TEST(PlantStationTest)
#include "plant_station_test.moc"
