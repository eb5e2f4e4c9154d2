// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/offscreen_gl.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

namespace gripscope {

struct OffscreenGl::Private {
    QOffscreenSurface surface;
    QOpenGLContext context;
};

namespace {

QSurfaceFormat sceneFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setRedBufferSize(8);
    format.setGreenBufferSize(8);
    format.setBlueBufferSize(8);
    format.setAlphaBufferSize(8);
    return format;
}

} // namespace

OffscreenGl::OffscreenGl(std::unique_ptr<Private> p) : d(std::move(p)) {}
OffscreenGl::~OffscreenGl() = default;

std::unique_ptr<OffscreenGl> OffscreenGl::create()
{
    if (!qobject_cast<QGuiApplication*>(QCoreApplication::instance()))
        return nullptr;
    auto made = std::make_unique<Private>();
    made->context.setFormat(sceneFormat());
    if (!made->context.create() || made->context.format().version() < std::pair(3, 2))
        return nullptr;
    made->surface.setFormat(made->context.format());
    made->surface.create();
    if (!made->surface.isValid() || !made->context.makeCurrent(&made->surface))
        return nullptr;
    made->context.doneCurrent();
    return std::unique_ptr<OffscreenGl>(new OffscreenGl(std::move(made)));
}

void OffscreenGl::moveToThread(QThread* thread)
{
    d->context.moveToThread(thread);
}

bool OffscreenGl::makeCurrent()
{
    return d->context.makeCurrent(&d->surface);
}

void OffscreenGl::doneCurrent()
{
    d->context.doneCurrent();
}

bool OffscreenGl::isCurrent() const
{
    return QOpenGLContext::currentContext() == &d->context;
}

bool OffscreenGl::threaded()
{
    return QOpenGLContext::supportsThreadedOpenGL();
}

bool sceneAvailable()
{
    static const bool available = OffscreenGl::create() != nullptr;
    return available;
}

} // namespace gripscope
