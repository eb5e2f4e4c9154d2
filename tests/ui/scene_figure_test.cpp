// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/charts/plot_export.h"
#include "ui/scene/scene_figure.h"
#include "ui/scene/scene_view.h"
#include "ui/theme/theme.h"

#include <QPainter>
#include <QTest>

#include <cmath>
#include <memory>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// Axes from 0 to 1, so that values are places in the cube; one ellipsoid, two points.
SceneContent exampleContent()
{
    SceneContent content;
    for (AxisScale& axis : content.axes) {
        axis.name = u"Axis"_s;
        axis.low = 0;
        axis.high = 1;
        axis.ticks = {0, 0.5, 1};
        axis.step = 0.5;
    }
    Ellipsoid ball;
    ball.centre = {0.5, 0.5, 0.5};
    ball.radii = {0.2, 0.2, 0.2};
    content.ellipsoids = {{ball, 1}};
    content.points = {{u"a"_s, {0.5, 0.5, 0.5}, 0, 0}, {u"b"_s, {0.1, 0.9, 0.2}, 1, 1}};
    return content;
}

} // namespace

class SceneFigureTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void aBallIsSeenAsADisc()
    {
        const SceneContent content = exampleContent();
        SceneCamera camera;
        camera.orthographic = true;
        const SceneProjection projection(camera, {400, 300});
        const QPolygonF outline = silhouette(content, content.ellipsoids[0].shape, projection);
        QVERIFY(outline.size() > 20);
        const QPointF middle = projection.at({0, 0, 0});
        const double radius = 0.2 * projection.pixelsPerUnit();
        for (const QPointF& point : outline) {
            // Within what the header says of the facets.
            const double distance = std::hypot(point.x() - middle.x(), point.y() - middle.y());
            QVERIFY2(distance <= radius * 1.000001 && distance > radius * 0.99,
                     qPrintable(QString::number(distance / radius)));
        }
    }
    void anEllipsoidIsWhereItsPointsAre()
    {
        SceneContent content = exampleContent();
        Ellipsoid& shape = content.ellipsoids[0].shape;
        shape.radii = {0.4, 0.1, 0.05};
        const SceneProjection projection(SceneCamera(), {400, 300}); // in perspective
        const QRectF box = silhouette(content, shape, projection).boundingRect();
        for (const auto& ring : ellipsoidRings(shape))
            for (const Eigen::Vector3d& value : ring)
                QVERIFY(
                    box.adjusted(-0.5, -0.5, 0.5, 0.5).contains(projection.at(cubePosition(content, value))));
    }
    void theFigureIsVectorsInAJournalsWidth()
    {
        const std::unique_ptr<SceneView> view(makeSceneView(nullptr, SceneKind::PairPlots));
        view->resize(600, 450);
        view->setContent(exampleContent());
        const FigureLayout layout(*view, FigureWidth::TwoColumns);
        QCOMPARE(view->pictureSize().width(), figureSize(FigureWidth::TwoColumns).width());
        const QByteArray svg = toSvg(*view);
        QVERIFY(svg.contains("<text") && !svg.contains("<image"));
        QCOMPARE(toCsv(view->numbers()).count('\n'), qsizetype(3));
    }
    void theSceneIsPaintedWithoutPixels()
    {
        /// The scene in three dimensions needs no OpenGL for that.
        class Figure : public ExportablePlot {
        public:
            QString plotName() const override { return u"scene"_s; }
            QString fileName() const override { return u"scene"_s; }
            QSize pictureSize() const override { return {400, 300}; }
            void setPictureSize(QSize) override {}
            void paintPicture(QPainter& painter) override
            {
                paintSceneFigure(painter, exampleContent(), SceneCamera(), pictureSize());
            }
            PlotTable numbers() const override { return {}; }
        } figure;
        const QByteArray svg = toSvg(figure);
        QVERIFY(svg.contains("<text") && !svg.contains("<image"));
        QVERIFY(svg.contains(Theme::typeColor(1).name().toLatin1())); // the ball's colour
        const QImage image = toImage(figure, 1);
        const SceneProjection projection(SceneCamera(), {400, 300});
        const QPoint at = projection.at({-0.4, 0.4, -0.3}).toPoint(); // where the second point is
        QCOMPARE(image.pixelColor(at), Theme::typeColor(1));
    }
};

GRIPSCOPE_TEST(SceneFigureTest)
#include "scene_figure_test.moc"
