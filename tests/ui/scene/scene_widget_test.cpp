// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/scene/scene_example.h"
#include "ui/scene/offscreen_gl.h"
#include "ui/scene/scene_view.h"
#include "ui/theme/theme.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

/// Share of pixels whose hue is that of `color` (light and shade change the rest).
double shareOfHue(const QImage& image, const QColor& color)
{
    qint64 hits = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            const int difference = std::abs(pixel.hsvHue() - color.hsvHue());
            if (pixel.hsvSaturation() > 90 && std::min(difference, 360 - difference) <= 6)
                ++hits;
        }
    return double(hits) / (double(image.width()) * image.height());
}

/// Share of pixels that two pictures of equal size do not have in common.
double difference(const QImage& a, const QImage& b)
{
    qint64 hits = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            hits += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    return double(hits) / (double(a.width()) * a.height());
}

} // namespace

class SceneWidgetTest : public QObject {
    Q_OBJECT

    void showSettled(SceneWidget& scene, SceneContent content)
    {
        scene.resize(720, 540);
        scene.setContent(std::move(content));
        scene.show();
        QVERIFY(QTest::qWaitForWindowExposed(&scene, gripscope::test::longEnough_ms));
        QTRY_VERIFY(scene.settled());
    }

private slots:
    void initTestCase()
    {
        QVERIFY2(sceneAvailable(), "these tests run under Xvfb, where Mesa gives OpenGL 3.2 and more");
        Theme::instance().apply(ThemeKind::Light);
    }
    void fourTypesShowTheirColours()
    {
        SceneWidget scene;
        showSettled(scene, test::sceneExample());
        QCOMPARE(scene.rendered().size(), QSize(720, 540) * scene.devicePixelRatioF());
        // Ten glyphs of 11 px across are 0.2 % of the picture; hidden ones and shading take some of it.
        for (int type = 0; type < 4; ++type)
            QVERIFY2(shareOfHue(scene.rendered(), Theme::typeColor(type)) > 0.0005,
                     qPrintable(QString::number(type)));
    }
    void theGlyphIsWhereTheProjectionPutsIt()
    {
        // One point, off centre, under several cameras: the middle of its coloured pixels is its projected
        // place.
        SceneContent content = test::sceneExample();
        content.points.erase(content.points.begin() + 1, content.points.end());
        content.ellipsoids.clear();
        SceneWidget scene;
        showSettled(scene, content);
        SceneCamera shifted;
        shifted.pan = QPointF(0.2, -0.1);
        shifted.zoom = 1.3;
        SceneCamera flat;
        flat.lookAlong(SceneDirection::AlongStiffness);
        flat.orthographic = true;
        for (const SceneCamera& camera : {SceneCamera(), shifted, flat}) {
            scene.setCamera(camera);
            QTRY_VERIFY(scene.settled());
            QPointF sum;
            int hits = 0;
            const QImage& image = scene.rendered();
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    if (image.pixelColor(x, y).hsvSaturation() > 120) {
                        sum += QPointF(x + 0.5, y + 0.5);
                        ++hits;
                    }
            QVERIFY(hits > 20);
            const QPointF middle = sum / hits / scene.devicePixelRatioF();
            const std::optional<QPointF> expected = scene.placeOf(QStringLiteral("A0"));
            QVERIFY(expected);
            QVERIFY(std::hypot(middle.x() - expected->x(), middle.y() - expected->y()) < 1.5);
        }
    }
    void aClickPicksThePointThere()
    {
        SceneWidget scene;
        showSettled(scene, test::sceneExample());
        QSignalSpy spy(&scene, &SceneView::picked);
        const QString wanted = QStringLiteral("D4");
        QTest::mouseClick(&scene, Qt::LeftButton, {}, scene.placeOf(wanted)->toPoint());
        QCOMPARE(spy.size(), 1);
        // Of two points at one place the one in front is picked: it may be another of the same type.
        const QString got = spy.first().first().toString();
        const QPointF a = *scene.placeOf(got), b = *scene.placeOf(wanted);
        QVERIFY(std::hypot(a.x() - b.x(), a.y() - b.y()) < 10);
        QTest::mouseClick(&scene, Qt::LeftButton, {}, QPoint(3, 3));
        QCOMPARE(spy.last().first().toString(), QString());
    }
    void dragTurnsAndKeysTurnAndPick()
    {
        SceneWidget scene;
        showSettled(scene, test::sceneExample());
        const SceneCamera before = scene.camera();
        QTest::mousePress(&scene, Qt::LeftButton, {}, QPoint(300, 300));
        QTest::mouseMove(&scene, QPoint(340, 310));
        QTest::mouseMove(&scene, QPoint(380, 320));
        QTest::mouseRelease(&scene, Qt::LeftButton, {}, QPoint(380, 320));
        QVERIFY(scene.camera().azimuth != before.azimuth);
        QVERIFY(scene.pickedId().isEmpty());
        const double turned = scene.camera().azimuth;
        QTest::keyClick(&scene, Qt::Key_Left);
        QVERIFY(scene.camera().azimuth != turned);
        QTest::keyClick(&scene, Qt::Key_N);
        QCOMPARE(scene.pickedId(), QStringLiteral("A0"));
        QTest::keyClick(&scene, Qt::Key_K);
        QVERIFY(scene.orthographic());
        QTRY_VERIFY(scene.settled());
    }
    void theEllipsoidCoversItsPoints()
    {
        // Ellipsoids alone, then the colour under the middle of each point: tinted, not ground.
        SceneContent content = test::sceneExample();
        const SceneContent all = content;
        content.ellipsoids = {all.ellipsoids[0]};
        for (ScenePoint& point : content.points)
            point.at = all.points[30].at; // far from type A
        SceneWidget scene;
        showSettled(scene, content);
        const QColor ground = Theme::instance().tokens().surface;
        const SceneProjection projection(scene.camera(), scene.size());
        for (int n = 0; n < 10; ++n) {
            const QPointF at =
                projection.at(cubePosition(all, all.points[std::size_t(n)].at)) * scene.devicePixelRatioF();
            QVERIFY(scene.rendered().pixelColor(at.toPoint()).hsvSaturation() > ground.hsvSaturation() + 15);
        }
    }
    void aStepOfTheCentroidsChangesThePicture()
    {
        SceneContent content = test::sceneExample();
        content.centroids = {{{content.points[3].at}, 0}};
        SceneWidget scene;
        showSettled(scene, content);
        const QImage first = scene.picture();
        content.centroids[0].trail.push_back(content.points[25].at);
        content.points[3].color = 2;
        scene.setContent(content);
        QTRY_VERIFY(scene.settled());
        QVERIFY(difference(first, scene.picture()) > 0.001);
    }
    void theSameContentGivesTheSamePicture()
    {
        SceneWidget scene;
        showSettled(scene, test::sceneExample());
        const QImage first = scene.picture();
        scene.setContent(test::sceneExample());
        QTRY_VERIFY(scene.settled());
        QCOMPARE(scene.picture(), first);
    }
    void aNewSizeGivesAPictureOfThatSize()
    {
        SceneWidget scene;
        showSettled(scene, test::sceneExample());
        for (const QSize size : {QSize(900, 420), QSize(400, 700)}) {
            scene.resize(size);
            QTRY_VERIFY(scene.settled() && scene.rendered().size() == size * scene.devicePixelRatioF());
            QCOMPARE(scene.picture().size(), size * scene.devicePixelRatioF());
        }
    }
    void darkThemeHasADarkGround()
    {
        SceneWidget scene;
        showSettled(scene, test::sceneExample());
        Theme::instance().apply(ThemeKind::Dark);
        QTRY_COMPARE(scene.rendered().pixelColor(2, 2), themeTokens(ThemeKind::Dark).surface);
        Theme::instance().apply(ThemeKind::Light);
        QTRY_COMPARE(scene.rendered().pixelColor(2, 2), themeTokens(ThemeKind::Light).surface);
    }
    void manyPointsAreDrawnAsDots()
    {
        SceneContent content = test::sceneExample();
        const std::vector<ScenePoint> few = content.points;
        while (content.points.size() <= 3000)
            content.points.insert(content.points.end(), few.begin(), few.end());
        SceneWidget scene;
        showSettled(scene, content);
        QVERIFY(shareOfHue(scene.rendered(), Theme::typeColor(0)) > 0.00005);
    }
    void viewsOpenAndCloseManyTimes()
    {
        for (int n = 0; n < 8; ++n) {
            SceneWidget scene;
            showSettled(scene, test::sceneExample());
            if (n % 2)
                scene.setContent(test::sceneExample()); // a picture is still under way when it goes
        }
    }
};

GRIPSCOPE_TEST(SceneWidgetTest)
#include "scene_widget_test.moc"
