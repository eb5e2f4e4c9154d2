// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/scene/scene_example.h"
#include "ui/scene/offscreen_gl.h"
#include "ui/scene/scene_view.h"
#include "ui/theme/theme.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace gripscope;

class PairPlotsTest : public QObject {
    Q_OBJECT
private slots:
    void withoutADisplayThereIsNoSceneButPlots()
    {
        QVERIFY(!sceneAvailable());
        const std::unique_ptr<SceneView> view(makeSceneView(nullptr));
        QVERIFY(!view->threeDimensional());
        QVERIFY(view->settled());
    }
    void showsTheColourOfEveryType()
    {
        Theme::instance().apply(ThemeKind::Light);
        PairPlots plots;
        plots.resize(700, 600);
        plots.setContent(test::sceneExample());
        const QImage picture = plots.picture();
        for (int type = 0; type < 4; ++type) {
            int hits = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    hits += picture.pixelColor(x, y) == Theme::typeColor(type) ? 1 : 0;
            QVERIFY(hits > 100); // ten signs of 9 px in each of three plots
        }
    }
    void aClickPicksThePointThere()
    {
        PairPlots plots;
        plots.resize(700, 600);
        SceneContent content = test::sceneExample();
        content.points = {content.points[0], content.points[15], content.points[39]};
        plots.setContent(content);
        QSignalSpy picked(&plots, &SceneView::picked);
        for (const ScenePoint& point : content.points) {
            QTest::mouseClick(&plots, Qt::LeftButton, {}, plots.placeOf(point.id)->toPoint());
            QCOMPARE(picked.last().first().toString(), point.id);
        }
        QTest::mouseClick(&plots, Qt::LeftButton, {}, QPoint(2, 2));
        QCOMPARE(picked.last().first().toString(), QString());
    }
    void theKeyboardGoesFromPointToPoint()
    {
        PairPlots plots;
        plots.setContent(test::sceneExample());
        QTest::keyClick(&plots, Qt::Key_N);
        QCOMPARE(plots.pickedId(), QStringLiteral("A0"));
        QTest::keyClick(&plots, Qt::Key_N);
        QCOMPARE(plots.pickedId(), QStringLiteral("A1"));
        QTest::keyClick(&plots, Qt::Key_N, Qt::ShiftModifier);
        QTest::keyClick(&plots, Qt::Key_N, Qt::ShiftModifier);
        QCOMPARE(plots.pickedId(), QStringLiteral("D9"));
    }
    void anOutlineIsTheShadowOfTheWholeEllipsoid()
    {
        // Rotated by 30 degrees in the plane, radii 3 and 1, and 2 across it: the shadow is that same
        // ellipse.
        const double a = std::numbers::pi / 6;
        Ellipsoid ellipsoid;
        ellipsoid.centre = {10, 20, 30};
        ellipsoid.axes << std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a), 0, 0, 0, 1;
        ellipsoid.radii = {3, 1, 2};
        const Eigen::Matrix2Xd outline = ellipsoidOutline(ellipsoid, 0, 1);
        for (Eigen::Index i = 0; i < outline.cols(); ++i) {
            const double x = outline(0, i) - 10, y = outline(1, i) - 20;
            const double u = (x * std::cos(a) + y * std::sin(a)) / 3;
            const double v = -x * std::sin(a) + y * std::cos(a);
            QVERIFY(std::abs(u * u + v * v - 1) < 1e-12);
        }
        QVERIFY(std::abs(outline.row(0).maxCoeff() - 10 - halfExtent(ellipsoid).x()) < 0.02);
    }
    void anEmptyViewSaysWhatToDo()
    {
        PairPlots plots;
        plots.resize(400, 300);
        const QImage blank = plots.picture();
        plots.setEmptyText(QStringLiteral("Enrol a type first."));
        QVERIFY(plots.picture() != blank);
    }
};

GRIPSCOPE_TEST(PairPlotsTest)
#include "pair_plots_test.moc"
