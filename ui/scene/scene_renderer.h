// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene/scene_camera.h"
#include "ui/scene/scene_content.h"

#include <QColor>
#include <QImage>
#include <QObject>
#include <QSize>

#include <functional>
#include <memory>

namespace gripscope {

class OffscreenGl;

/// The colours of a scene, resolved on the screen's thread so that the renderer asks nobody.
struct SceneLook {
    QColor background, grid, frame, outline, text;
    double lineWidth = 1; ///< logical pixels
    friend bool operator==(const SceneLook&, const SceneLook&) = default;
};

/// One picture to be made.
struct SceneRequest {
    std::shared_ptr<const SceneContent> content;
    SceneLook look;
    SceneCamera camera;
    QSize size;       ///< logical pixels
    double ratio = 1; ///< device pixels a logical pixel
    bool atRest =
        true; ///< nothing moves: translucent surfaces are sorted exactly (depth peeling), which takes longer
};

/// Radius of a point's glyph on the screen at the middle of the cube, logical pixels.
inline constexpr double glyphRadius = 5.0;

/// Draws grid, points and ellipsoids with VTK into a context of its own and reads the picture back. Words,
/// rings and trails are painted over it by the widget. Belongs to one thread: the one that calls render()
/// first.
class SceneRenderer {
public:
    explicit SceneRenderer(std::unique_ptr<OffscreenGl> gl);
    ~SceneRenderer();
    SceneRenderer(const SceneRenderer&) = delete;
    SceneRenderer& operator=(const SceneRenderer&) = delete;

    /// Null when the context could not be made current.
    [[nodiscard]] QImage render(const SceneRequest& request);
    /// Frees what the graphics driver holds; on the thread that rendered.
    void release();
    [[nodiscard]] OffscreenGl* gl() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

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
