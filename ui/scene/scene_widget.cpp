// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/offscreen_gl.h"
#include "ui/scene/scene_figure.h"
#include "ui/scene/scene_marks.h"
#include "ui/scene/scene_renderer.h"
#include "ui/scene/scene_view.h"
#include "ui/theme/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QWheelEvent>

namespace gripscope {

using namespace std::chrono_literals;

struct SceneWidget::Private {
    std::unique_ptr<RenderThread> renderer;
    SceneCamera camera;

    // What the picture on the screen shows; what is painted over it goes by these.
    QImage image;
    SceneCamera shownCamera;
    std::shared_ptr<const SceneContent> shownContent;
    bool shownAtRest = false;

    bool scheduled = false, rendering = false, again = false, moving = false;
    QTimer rest; ///< runs out when nothing has moved for a while
    QPointF pressedAt, lastAt;
    bool dragged = false;
};

namespace {

SceneLook sceneLook()
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    SceneLook look;
    look.background = tokens.surface;
    look.grid =
        tokens.kind == ThemeKind::HighContrast ? Theme::mix(tokens.surface, tokens.line, 0.4) : tokens.line;
    look.frame = Theme::mix(tokens.line, tokens.secondText, 0.5);
    look.outline = tokens.kind == ThemeKind::Light ? tokens.surface : tokens.text;
    look.text = tokens.text;
    look.lineWidth = tokens.lineWidth;
    return look;
}

} // namespace

SceneWidget::SceneWidget(QWidget* parent) : SceneView(parent), d(std::make_unique<Private>())
{
    d->renderer = std::make_unique<RenderThread>(OffscreenGl::create());
    d->rest.setSingleShot(true);
    d->rest.setInterval(150ms);
    connect(&d->rest, &QTimer::timeout, this, [this] { scheduleRender(false); });
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::OpenHandCursor);
}

SceneWidget::~SceneWidget() = default;

const SceneCamera& SceneWidget::camera() const
{
    return d->camera;
}
const QImage& SceneWidget::rendered() const
{
    return d->image;
}
bool SceneWidget::orthographic() const
{
    return d->camera.orthographic;
}

bool SceneWidget::settled() const
{
    return !d->scheduled && !d->rendering && !d->again && d->shownAtRest &&
           d->shownContent == sharedContent();
}

void SceneWidget::setCamera(const SceneCamera& camera)
{
    changeCamera(camera, false);
}

void SceneWidget::changeCamera(const SceneCamera& camera, bool moving)
{
    d->camera = camera;
    scheduleRender(moving);
    emit cameraChanged();
}

void SceneWidget::lookAlong(SceneDirection direction)
{
    SceneCamera camera = d->camera;
    camera.lookAlong(direction);
    camera.orthographic = direction != SceneDirection::Isometric;
    changeCamera(camera, false);
}

void SceneWidget::setOrthographic(bool orthographic)
{
    SceneCamera camera = d->camera;
    camera.orthographic = orthographic;
    changeCamera(camera, false);
}

void SceneWidget::scheduleRender(bool moving)
{
    d->moving = moving;
    if (moving)
        d->rest.start();
    else
        d->rest.stop();
    if (d->rendering) {
        d->again = true;
        return;
    }
    if (d->scheduled || !isVisible())
        return;
    d->scheduled = true;
    QMetaObject::invokeMethod(
        this, [this] { startRender(); }, Qt::QueuedConnection);
}

void SceneWidget::startRender()
{
    d->scheduled = false;
    if (d->rendering || !isVisible() || size().isEmpty())
        return;
    SceneRequest request{sharedContent(), sceneLook(), d->camera, size(), devicePixelRatioF(), !d->moving};
    d->rendering = true;
    d->again = false;
    d->renderer->render(request, this, [this, request](const QImage& image) {
        d->rendering = false;
        if (!image.isNull()) {
            d->image = image;
            d->shownCamera = request.camera;
            d->shownContent = request.content;
            d->shownAtRest = request.atRest;
            update();
        }
        if (d->again)
            startRender();
    });
}

void SceneWidget::contentChanged()
{
    scheduleRender(false);
}
void SceneWidget::themeChanged()
{
    scheduleRender(false);
}

void SceneWidget::resizeEvent(QResizeEvent* event)
{
    SceneView::resizeEvent(event);
    scheduleRender(false);
}

void SceneWidget::showEvent(QShowEvent* event)
{
    SceneView::showEvent(event);
    d->scheduled = false; // one that was asked for out of view was dropped
    scheduleRender(false);
}

void SceneWidget::hideEvent(QHideEvent* event)
{
    SceneView::hideEvent(event);
    d->renderer->release(); // the last picture stays, to be shown while the next is drawn
}

std::vector<SceneView::Spot> SceneWidget::spots() const
{
    const SceneProjection projection(d->camera, size());
    std::vector<Spot> result;
    const auto add = [&](const ScenePoint& point) {
        const auto place = projection.place(cubePosition(content(), point.at));
        result.push_back({&point, place.at, place.depth});
    };
    for (const ScenePoint& point : content().points)
        add(point);
    if (content().highlight)
        add(content().highlight->point);
    return result;
}

void SceneWidget::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.fillRect(rect(), tokens.surface);
    if (empty()) {
        painter.setPen(tokens.secondText);
        painter.setFont(Theme::font(metrics::fontBase));
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, emptyText());
        return;
    }
    if (d->image.isNull() || !d->shownContent)
        return;
    painter.drawImage(QRectF(rect()), d->image);
    const SceneContent& shown = *d->shownContent;
    const SceneProjection projection(d->shownCamera, size());
    const auto at = [&](const Eigen::Vector3d& value) { return projection.at(cubePosition(shown, value)); };
    paintSceneAxes(painter, shown, d->shownCamera, size());
    if (shown.net)
        drawNet(painter, *shown.net, at);
    for (const SceneCentroid& centroid : shown.centroids)
        drawCentroid(painter, centroid, at);
    if (shown.highlight)
        drawHighlightRing(painter, at(shown.highlight->point.at));
    if (pickedError())
        for (const std::vector<Eigen::Vector3d>& ring : ellipsoidRings(*pickedError()))
            drawOwnError(painter, ring, at);
    if (!pickedId().isEmpty())
        for (const ScenePoint& point : shown.points)
            if (point.id == pickedId())
                drawPickRing(painter, at(point.at));
    if (hasFocus()) {
        painter.setPen(QPen(tokens.accent, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void SceneWidget::paintPicture(QPainter& painter)
{
    if (!empty())
        paintSceneFigure(painter, content(), d->camera, pictureSize());
}

void SceneWidget::mousePressEvent(QMouseEvent* event)
{
    d->pressedAt = d->lastAt = event->position();
    d->dragged = false;
}

void SceneWidget::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() == Qt::NoButton) {
        setCursor(pointNear(event->position()) ? Qt::PointingHandCursor : Qt::OpenHandCursor);
        return;
    }
    constexpr double clickSlack = 4; // a hand that clicks moves this much
    if (!d->dragged && (event->position() - d->pressedAt).manhattanLength() < clickSlack)
        return;
    d->dragged = true;
    setCursor(Qt::ClosedHandCursor);
    const QPointF moved = event->position() - d->lastAt;
    d->lastAt = event->position();
    SceneCamera camera = d->camera;
    const bool shift = event->modifiers() & Qt::ShiftModifier;
    if ((event->buttons() & Qt::LeftButton) && !shift)
        camera.turn(-0.4 * moved.x(), 0.4 * moved.y());
    else
        camera.pan += moved / (height() / 2.0);
    changeCamera(camera, true);
}

void SceneWidget::mouseReleaseEvent(QMouseEvent* event)
{
    if (!d->dragged && event->button() == Qt::LeftButton)
        pickAt(event->position());
    setCursor(Qt::OpenHandCursor);
}

void SceneWidget::mouseDoubleClickEvent(QMouseEvent*)
{
    lookAlong(SceneDirection::Isometric);
}

void SceneWidget::zoomAt(QPointF position, double factor)
{
    SceneCamera camera = d->camera;
    camera.zoomBy(factor);
    // What is under the pointer stays there.
    const double change = camera.zoom / d->camera.zoom;
    const QPointF pointer = (position - QPointF(width(), height()) / 2) / (height() / 2.0);
    camera.pan = pointer - (pointer - camera.pan) * change;
    changeCamera(camera, true);
}

void SceneWidget::wheelEvent(QWheelEvent* event)
{
    zoomAt(event->position(), std::pow(1.0015, event->angleDelta().y()));
    event->accept();
}

void SceneWidget::keyPressEvent(QKeyEvent* event)
{
    constexpr double turn = 5; // degrees
    SceneCamera camera = d->camera;
    switch (event->key()) {
    case Qt::Key_Left:
        camera.turn(turn, 0);
        break;
    case Qt::Key_Right:
        camera.turn(-turn, 0);
        break;
    case Qt::Key_Up:
        camera.turn(0, turn);
        break;
    case Qt::Key_Down:
        camera.turn(0, -turn);
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        camera.zoomBy(1.15);
        break;
    case Qt::Key_Minus:
        camera.zoomBy(1 / 1.15);
        break;
    default:
        SceneView::keyPressEvent(event);
        return;
    }
    changeCamera(camera, true);
}

} // namespace gripscope
