// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene/scene_view.h"

namespace gripscope {

/// The space in three dimensions. Pictures are drawn by a SceneRenderer on a thread of its own; requests that
/// come while one is under way are joined into one. Drag turns, right or middle or Shift-drag moves, the
/// wheel zooms, a click picks; arrow keys turn, + and - zoom, N picks the next point, M, B, K look along an
/// axis, I at the whole, O changes between orthographic and perspective.
class SceneWidget : public SceneView {
    Q_OBJECT
public:
    explicit SceneWidget(QWidget* parent = nullptr);
    ~SceneWidget() override;

    [[nodiscard]] bool threeDimensional() const override { return true; }
    void lookAlong(SceneDirection direction) override;
    void setOrthographic(bool orthographic) override;
    [[nodiscard]] bool orthographic() const override;
    [[nodiscard]] bool settled() const override;

    [[nodiscard]] const SceneCamera& camera() const;
    void setCamera(const SceneCamera& camera);
    /// The rendered part of the picture, without what is painted over it.
    [[nodiscard]] const QImage& rendered() const;

protected:
    [[nodiscard]] std::vector<Spot> spots() const override;
    void contentChanged() override;
    void themeChanged() override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void scheduleRender(bool moving);
    void startRender();
    void changeCamera(const SceneCamera& camera, bool moving);
    void zoomAt(QPointF position, double factor);

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
