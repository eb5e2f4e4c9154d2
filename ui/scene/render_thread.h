// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene/scene_renderer.h"

#include <QObject>

#include <functional>
#include <memory>

namespace gripscope {

/// A SceneRenderer on a thread of its own (or, where the platform cannot, on the screen's, one event later).
class RenderThread {
public:
    explicit RenderThread(std::unique_ptr<OffscreenGl> gl);
    ~RenderThread(); ///< waits for the picture under way
    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    /// Renders, then calls `done` on the thread of `context`, unless that is gone.
    void render(const SceneRequest& request, QObject* context, std::function<void(const QImage&)> done);
    /// Frees what the pictures so far needed, a good 100 MB, once they are made; the next one begins anew.
    void release();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
