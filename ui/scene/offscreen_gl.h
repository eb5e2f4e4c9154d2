// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

class QThread;

namespace gripscope {

/// An OpenGL 3.2 context of its own on an off-screen surface: no window and no widget has a part in it, so
/// nothing else in the program repaints slower because of it. Made and destroyed on the screen's thread; may
/// be handed to one other thread in between.
class OffscreenGl {
public:
    /// Null where the platform gives no such context.
    [[nodiscard]] static std::unique_ptr<OffscreenGl> create();
    ~OffscreenGl();
    OffscreenGl(const OffscreenGl&) = delete;
    OffscreenGl& operator=(const OffscreenGl&) = delete;

    void moveToThread(QThread* thread);
    [[nodiscard]] bool makeCurrent();
    void doneCurrent();
    [[nodiscard]] bool isCurrent() const;
    /// Whether this platform may render away from the screen's thread.
    [[nodiscard]] static bool threaded();

private:
    struct Private;
    explicit OffscreenGl(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

/// Whether a 3-D scene can be drawn here; asked once, then remembered. The offscreen platform without DISPLAY
/// has no OpenGL at all.
[[nodiscard]] bool sceneAvailable();

} // namespace gripscope
