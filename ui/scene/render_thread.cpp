// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/render_thread.h"

#include "ui/scene/offscreen_gl.h"

#include <QThread>

namespace gripscope {

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
