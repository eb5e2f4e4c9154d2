// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/charts/heat_map.h"
#include "ui/theme/theme.h"

#include <QSignalSpy>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// 3 x 4 units with the numbers 0 to 11; the lower row is another cluster.
MapPlanes examplePlanes()
{
    MapPlanes map;
    map.rows = 3;
    map.columns = 4;
    MapPlane plane;
    plane.title = u"Stiffness k"_s;
    plane.meaning = u"The stiffness of each unit."_s;
    plane.scale.unit = u"N/m"_s;
    plane.scale.high = 11;
    plane.values.resize(3, 4);
    for (int unit = 0; unit < 12; ++unit) {
        plane.values(unit / 4, unit % 4) = unit;
        map.hits.push_back(unit % 3);
        map.groups.push_back(unit / 8);
        map.squeezes.push_back(u"Squeezes: %1 of A"_s.arg(unit % 3));
    }
    map.planes = {plane};
    return map;
}

/// How light a colour looks, 0 to 1 (relative luminance of WCAG 2).
double luminance(const QColor& color)
{
    return (Theme::contrastRatio(color, Qt::black) * 0.05) - 0.05;
}

} // namespace

class HeatMapTest : public QObject {
    Q_OBJECT
private slots:
    void aMapLeavesTheScreenAsFigureAndNumbers()
    {
        HeatMap map;
        map.resize(160, 160);
        map.setPlane(examplePlanes(), 0, true);
        {
            const FigureLayout layout(map, FigureWidth::OneColumn);
            QCOMPARE(map.pictureSize(), figureSize(FigureWidth::OneColumn));
            const QByteArray svg = toSvg(map);
            QVERIFY(svg.contains("Stiffness k"));
            QVERIFY(svg.contains("width=\"84.9"));
            // A unit's colour is in it, and the bar's.
            QVERIFY(svg.contains(map.color(5).name().toLatin1()));
            QVERIFY(map.cell(11).right() > 160); // laid out anew
        }
        QVERIFY(map.cell(11).right() < 160);
        const QList<QByteArray> lines = toCsv(map.numbers()).split('\n');
        QCOMPARE(lines[0], QByteArray("Row,Column,Stiffness k (N/m),Squeezes,Cluster"));
        QCOMPARE(lines[6], QByteArray("2,2,5,2,1"));
    }
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void theScaleRisesInLightnessAlone()
    {
        // Read in grey, as any colour blindness leaves it, every step still is lighter than the one before.
        for (int i = 1; i <= 100; ++i)
            QVERIFY(luminance(scaleColor(i / 100.0)) > luminance(scaleColor((i - 1) / 100.0)));
        QCOMPARE(scaleColor(-3), scaleColor(0));
        QCOMPARE(scaleColor(7), scaleColor(1));
        QCOMPARE(scaleColor(std::nan("")), scaleColor(0));
    }
    void everyCellHasTheColourOfItsNumber()
    {
        HeatMap map;
        map.resize(160, 160);
        map.setPlane(examplePlanes(), 0, false);
        const QImage picture = map.grab().toImage();
        for (int unit = 0; unit < 12; ++unit) {
            const QPointF at = map.cell(unit).center() * map.devicePixelRatioF();
            QCOMPARE(picture.pixelColor(at.toPoint()).rgb(), scaleColor(unit / 11.0).rgb());
            QCOMPARE(map.unitAt(map.cell(unit).center()), unit);
        }
        QCOMPARE(map.unitAt(QPointF(1, 1)), -1);
    }
    void dotsStandWhereSqueezesAre()
    {
        HeatMap map;
        map.resize(160, 160);
        map.setPlane(examplePlanes(), 0, true);
        const QImage picture = map.grab().toImage();
        for (int unit = 0; unit < 12; ++unit) {
            const QPointF at = map.cell(unit).center() * map.devicePixelRatioF();
            QCOMPARE(picture.pixelColor(at.toPoint()) == QColor(Qt::white), unit % 3 > 0);
        }
    }
    void pointingAtACellTellsTheUnit()
    {
        HeatMap map;
        map.resize(160, 160);
        map.setPlane(examplePlanes(), 0, false);
        map.show();
        QSignalSpy spy(&map, &HeatMap::pointedAt);
        QTest::mouseMove(&map, map.cell(6).center().toPoint());
        QTRY_COMPARE(map.marked(), 6);
        QCOMPARE(spy.last().first().toInt(), 6);
        QVERIFY(map.tip(6).contains(u"Stiffness k: 6"_s));
        QVERIFY(map.tip(6).contains(u"Squeezes: 0 of A"_s));
        QVERIFY(map.tip(6).contains(u"Row 2, column 3 of the map, cluster 1"_s));
    }
    void arrowKeysGoFromUnitToUnit()
    {
        HeatMap map;
        map.setPlane(examplePlanes(), 0, false);
        const auto press = [&](Qt::Key key) {
            QTest::keyClick(&map, key);
            return map.marked();
        };
        QCOMPARE(press(Qt::Key_Right), 0);
        QCOMPARE(press(Qt::Key_Right), 1);
        QCOMPARE(press(Qt::Key_Down), 5);
        QCOMPARE(press(Qt::Key_Up), 1);
        QCOMPARE(press(Qt::Key_Up), 1); // the edge
    }
    void withoutAMapThereIsNothing()
    {
        HeatMap map;
        map.resize(160, 160);
        QCOMPARE(map.unitAt(QPointF(80, 80)), -1);
        QTest::keyClick(&map, Qt::Key_Right);
        QCOMPARE(map.marked(), -1);
        QVERIFY(!map.grab().isNull());
        MapPlanes flat = examplePlanes();
        flat.planes[0].values.setConstant(3);
        flat.planes[0].scale.low = flat.planes[0].scale.high = 3;
        map.setPlane(flat, 0, false);
        QCOMPARE(map.color(5), scaleColor(0.5));
    }
};

GRIPSCOPE_TEST(HeatMapTest)
#include "heat_map_test.moc"
