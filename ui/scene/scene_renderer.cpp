// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/scene_renderer.h"

#include "ui/scene/offscreen_gl.h"
#include "ui/scene/scene_actors.h"
#include "ui/scene/scene_figure.h"
#include "ui/theme/theme.h"

#include <QLoggingCategory>
#include <QThread>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstring>
#include <numbers>

namespace gripscope {

namespace {

Q_LOGGING_CATEGORY(sceneLog, "gripscope.scene", QtWarningMsg)

/// What VTK has to say goes where everything else goes. (Its complaint about GLEW on EGL is harmless: the
/// functions are found all the same.)
class VtkLog : public vtkOutputWindow {
public:
    static VtkLog* New()
    {
        auto* log = new VtkLog;
        log->InitializeObjectBase();
        return log;
    }
    void DisplayText(const char* text) override { qCDebug(sceneLog, "%s", text); }

protected:
    VtkLog() = default;
};

void redirectVtkLog()
{
    static const bool done = [] {
        const auto log = vtkSmartPointer<VtkLog>::New();
        vtkOutputWindow::SetInstance(log);
        vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
        return true;
    }();
    Q_UNUSED(done)
}

} // namespace

struct SceneRenderer::Private {
    std::unique_ptr<OffscreenGl> gl;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window;
    vtkSmartPointer<vtkRenderer> renderer;
    std::vector<PointActors> points;
    std::vector<vtkSmartPointer<vtkActor>> grid;
    std::shared_ptr<const SceneContent> content;
    SceneLook look;
    double ratio = 0;
    Eigen::Vector3i farSide = Eigen::Vector3i::Zero();

    void initialise();
    void build(const SceneRequest& request);
    void buildGrid(const SceneRequest& request);
    void aim(const SceneRequest& request);
    [[nodiscard]] QImage readBack(QSize pixels) const;
    [[nodiscard]] static int oversampling(const SceneRequest& request);
    static void onWindowEvent(vtkObject*, unsigned long event, void* self, void* data);
};

void SceneRenderer::Private::onWindowEvent(vtkObject*, unsigned long event, void* self, void* data)
{
    OffscreenGl& gl = *static_cast<Private*>(self)->gl;
    switch (event) {
    case vtkCommand::WindowMakeCurrentEvent:
        (void)gl.makeCurrent();
        return;
    case vtkCommand::WindowIsCurrentEvent:
        *static_cast<bool*>(data) = gl.isCurrent();
        return;
    case vtkCommand::WindowSupportsOpenGLEvent:
    case vtkCommand::WindowIsDirectEvent:
        *static_cast<int*>(data) = 1;
        return;
    default:
        return;
    }
}

void SceneRenderer::Private::initialise()
{
    redirectVtkLog();
    window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    auto callback = vtkSmartPointer<vtkCallbackCommand>::New();
    callback->SetCallback(&Private::onWindowEvent);
    callback->SetClientData(this);
    for (const vtkCommand::EventIds event :
         {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
          vtkCommand::WindowSupportsOpenGLEvent, vtkCommand::WindowIsDirectEvent})
        window->AddObserver(event, callback);
    window->SetOwnContext(0);
    window->SetFrameBlitModeToNoBlit();
    window->SetMultiSamples(0); // VTK 9.1 draws no translucent surface into a multisampled buffer
    window->SetAlphaBitPlanes(1);
    window->OpenGLInit();
    renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->SetOcclusionRatio(0);
    renderer->SetMaximumNumberOfPeels(6);
    window->AddRenderer(renderer);
}

int SceneRenderer::Private::oversampling(const SceneRequest& request)
{
    // Edges are smoothed by drawing twice as large and scaling down; while it moves a filter must do.
    return request.atRest && request.ratio < 2 ? 2 : 1;
}

void SceneRenderer::Private::build(const SceneRequest& request)
{
    const double drawnRatio = request.ratio * oversampling(request);
    if (content == request.content && look == request.look && ratio == drawnRatio)
        return;
    content = request.content;
    look = request.look;
    ratio = drawnRatio;
    renderer->RemoveAllViewProps();
    renderer->SetBackground(look.background.redF(), look.background.greenF(), look.background.blueF());
    points = pointActors(*content, look, ratio);
    for (const PointActors& actors : points) {
        if (actors.outline)
            renderer->AddActor(actors.outline);
        renderer->AddActor(actors.glyphs);
    }
    const auto add = [this](const Ellipsoid& ellipsoid, const QColor& color, double opacity) {
        const EllipsoidActors actors =
            ellipsoidActors(*content, ellipsoid, color, opacity, look.lineWidth * ratio);
        renderer->AddActor(actors.surface);
        renderer->AddActor(actors.wire);
    };
    for (const SceneEllipsoid& ellipsoid : content->ellipsoids)
        add(ellipsoid.shape, Theme::typeColor(ellipsoid.color), 0.16);
    if (content->highlight && content->highlight->ellipsoid)
        add(*content->highlight->ellipsoid, look.text, 0.25);
    for (const vtkSmartPointer<vtkActor>& actor : errorActors(*content, look.lineWidth * ratio))
        renderer->AddActor(actor);
    grid.clear();
    farSide.setZero();
}

void SceneRenderer::Private::buildGrid(const SceneRequest& request)
{
    const Eigen::Vector3i wanted = farSides(request.camera);
    if (wanted == farSide)
        return;
    farSide = wanted;
    for (const vtkSmartPointer<vtkActor>& actor : grid)
        renderer->RemoveActor(actor);
    grid = gridActors(*content, look, farSide, ratio);
    for (const vtkSmartPointer<vtkActor>& actor : grid)
        renderer->AddActor(actor);
}

void SceneRenderer::Private::aim(const SceneRequest& request)
{
    const SceneProjection projection(request.camera, request.size);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(projection.position.x(), projection.position.y(), projection.position.z());
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(projection.up.x(), projection.up.y(), projection.up.z());
    camera->SetParallelProjection(projection.orthographic ? 1 : 0);
    camera->SetParallelScale(projection.halfHeight);
    camera->SetViewAngle(2 * std::atan(projection.halfHeight / SceneProjection::viewDistance) * 180 /
                         std::numbers::pi);
    const double aspect = double(request.size.width()) / request.size.height();
    camera->SetWindowCenter(-projection.pan.x() / aspect, projection.pan.y());
    camera->SetClippingRange(SceneProjection::viewDistance - 2, SceneProjection::viewDistance + 2);
    // Glyphs keep their size on the screen whatever the zoom.
    const double radius = glyphRadius / projection.pixelsPerUnit();
    const double outlined = (glyphRadius + 1.0) / projection.pixelsPerUnit();
    for (const PointActors& actors : points) {
        if (actors.glyphMapper)
            actors.glyphMapper->SetScaleFactor(radius);
        if (actors.outlineMapper)
            actors.outlineMapper->SetScaleFactor(outlined);
    }
}

QImage SceneRenderer::Private::readBack(QSize pixels) const
{
    auto data = vtkSmartPointer<vtkUnsignedCharArray>::New();
    window->GetPixelData(0, 0, pixels.width() - 1, pixels.height() - 1, 0, data, 0);
    const qsizetype stride = qsizetype(pixels.width()) * 3;
    if (data->GetNumberOfValues() < stride * pixels.height())
        return {};
    QImage image(pixels, QImage::Format_RGB888);
    for (int y = 0; y < pixels.height(); ++y) // OpenGL counts rows from below
        std::memcpy(image.scanLine(pixels.height() - 1 - y), data->GetPointer(y * stride),
                    std::size_t(stride));
    return image;
}

SceneRenderer::SceneRenderer(std::unique_ptr<OffscreenGl> gl) : d(std::make_unique<Private>())
{
    d->gl = std::move(gl);
}

SceneRenderer::~SceneRenderer() = default;

QImage SceneRenderer::render(const SceneRequest& request)
{
    const QSize pixels = (QSizeF(request.size) * request.ratio).toSize();
    if (!request.content || pixels.isEmpty() || !d->gl || !d->gl->makeCurrent())
        return {};
    if (!d->window)
        d->initialise();
    const QSize drawn = pixels * Private::oversampling(request);
    d->window->SetSize(drawn.width(), drawn.height());
    d->build(request);
    d->buildGrid(request);
    d->aim(request);
    d->renderer->SetUseDepthPeeling(request.atRest ? 1 : 0);
    d->renderer->SetUseFXAA(!request.atRest);
    d->window->Render();
    QImage image = d->readBack(drawn);
    if (drawn != pixels)
        image = image.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    image.setDevicePixelRatio(request.ratio);
    d->gl->doneCurrent();
    return image;
}

void SceneRenderer::release()
{
    if (!d->window || !d->gl->makeCurrent())
        return;
    d->points.clear();
    d->grid.clear();
    d->renderer->RemoveAllViewProps();
    d->window->Finalize();
    d->renderer = nullptr;
    d->window = nullptr;
    d->content.reset();
    d->gl->doneCurrent();
}

OffscreenGl* SceneRenderer::gl() const
{
    return d->gl.get();
}

struct RenderThread::Private {
    QThread thread;
    QObject worker; ///< lives on `thread`; work is posted to it
    std::unique_ptr<SceneRenderer> renderer;
};

RenderThread::RenderThread(std::unique_ptr<OffscreenGl> gl) : d(std::make_unique<Private>())
{
    const bool threaded = OffscreenGl::threaded();
    if (threaded)
        gl->moveToThread(&d->thread);
    d->renderer = std::make_unique<SceneRenderer>(std::move(gl));
    if (!threaded)
        return;
    d->worker.moveToThread(&d->thread);
    d->thread.setObjectName(QStringLiteral("scene"));
    d->thread.start();
}

RenderThread::~RenderThread()
{
    // What the graphics driver holds is freed where it was made; then context and worker come home to be
    // destroyed.
    QThread* const home = QThread::currentThread();
    if (!d->thread.isRunning()) {
        d->renderer->release();
        return;
    }
    QMetaObject::invokeMethod(
        &d->worker,
        [this, home] {
            d->renderer->release();
            d->renderer->gl()->moveToThread(home);
            d->worker.moveToThread(home);
        },
        Qt::BlockingQueuedConnection);
    d->thread.quit();
    d->thread.wait();
}

void RenderThread::render(const SceneRequest& request, QObject* context,
                          std::function<void(const QImage&)> done)
{
    QMetaObject::invokeMethod(
        &d->worker,
        [this, request, context, done = std::move(done)] {
            const QImage image = d->renderer->render(request);
            QMetaObject::invokeMethod(
                context, [done, image] { done(image); }, Qt::QueuedConnection);
        },
        Qt::QueuedConnection);
}

void RenderThread::release()
{
    QMetaObject::invokeMethod(
        &d->worker, [this] { d->renderer->release(); }, Qt::QueuedConnection);
}

} // namespace gripscope
