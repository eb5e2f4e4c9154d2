// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_export.h"
#include "ui/scene/scene_camera.h"
#include "ui/scene/scene_content.h"

#include <QImage>
#include <QWidget>

#include <functional>
#include <memory>

namespace gripscope {

/// A view of the m-b-k space: in three dimensions where there is OpenGL, else three pair plots. Who uses it
/// need not know which.
class SceneView : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    explicit SceneView(QWidget* parent);
    ~SceneView() override;

    void setContent(SceneContent content);
    [[nodiscard]] const SceneContent& content() const { return *m_content; }
    /// What stands in the middle of an empty view: what to do.
    void setEmptyText(const QString& text);

    [[nodiscard]] virtual bool threeDimensional() const = 0;
    virtual void lookAlong(SceneDirection) {}
    virtual void setOrthographic(bool) {}
    [[nodiscard]] virtual bool orthographic() const { return true; }
    /// What is shown now is drawn to the end, nothing is under way.
    [[nodiscard]] virtual bool settled() const { return true; }
    /// The picture as it is on the screen, for the clipboard or a file.
    [[nodiscard]] virtual QImage picture();

    [[nodiscard]] QString plotName() const override;
    [[nodiscard]] QString fileName() const override;
    [[nodiscard]] QSize pictureSize() const override;
    void setPictureSize(QSize size) override { m_pictureSize = size; }
    /// As lines and signs, from where it is looked at now.
    void paintPicture(QPainter& painter) override = 0;
    /// m, b and k of every point.
    [[nodiscard]] PlotTable numbers() const override;

    /// What is shown of a point that is pointed at, by its id. Asked then, so that no words are made for
    /// thousands of points that nobody points at.
    void setTips(std::function<QString(const QString& id)> tips) { m_tips = std::move(tips); }

    /// Rings a point, and shows the ellipsoid of its own error; an id that is not there rings none.
    void pick(const QString& id, const std::optional<Ellipsoid>& error = std::nullopt);
    [[nodiscard]] const QString& pickedId() const { return m_pickedId; }
    /// Where a point is on the screen; null when it is not there. The first of several places.
    [[nodiscard]] std::optional<QPointF> placeOf(const QString& id) const;

    QSize sizeHint() const override { return {720, 540}; }
    QSize minimumSizeHint() const override { return {280, 240}; }

signals:
    void picked(const QString& id); ///< by mouse or keyboard; empty: nothing any more
    void cameraChanged();

protected:
    /// A point on the screen; in a pair plot each has three.
    struct Spot {
        const ScenePoint* point = nullptr;
        QPointF at;
        double depth = 0;
    };
    [[nodiscard]] virtual std::vector<Spot> spots() const = 0;
    virtual void contentChanged() = 0;
    virtual void themeChanged() { update(); }
    /// The one under the pointer: within reach, the nearest to the eye first.
    [[nodiscard]] const ScenePoint* pointNear(QPointF position) const;
    [[nodiscard]] const std::shared_ptr<const SceneContent>& sharedContent() const { return m_content; }
    [[nodiscard]] const QString& emptyText() const { return m_emptyText; }
    [[nodiscard]] const std::optional<Ellipsoid>& pickedError() const { return m_pickedError; }
    [[nodiscard]] bool empty() const;

    bool event(QEvent* event) override;
    /// Picks the point there, or none.
    void pickAt(QPointF position);
    void keyPressEvent(QKeyEvent* event) override;

private:
    void pickNext(int step);

    std::shared_ptr<const SceneContent> m_content;
    QString m_pickedId;
    std::optional<Ellipsoid> m_pickedError;
    std::function<QString(const QString&)> m_tips;
    QString m_emptyText;
    QSize m_pictureSize; ///< valid: in place of that on the screen
};

/// Best: three dimensions where there is OpenGL.
enum class SceneKind { Best, PairPlots };
[[nodiscard]] SceneView* makeSceneView(QWidget* parent, SceneKind kind = SceneKind::Best);

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
    void paintPicture(QPainter& painter) override;
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

/// The space as three plots of two parameters each (m-b, b-k, m-k), where there is no OpenGL. Painted by
/// hand: nothing but points, ellipses and axes.
class PairPlots : public SceneView {
    Q_OBJECT
public:
    explicit PairPlots(QWidget* parent = nullptr);

    [[nodiscard]] bool threeDimensional() const override { return false; }
    void paintPicture(QPainter& painter) override;

protected:
    [[nodiscard]] std::vector<Spot> spots() const override;
    void contentChanged() override {}
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    struct Plot {
        int horizontal = 0, vertical = 1;
        QRectF area; ///< inside the axes
    };
    [[nodiscard]] std::vector<Plot> plots() const;
    [[nodiscard]] QPointF place(const Plot& plot, const Eigen::Vector3d& value) const;
    [[nodiscard]] static std::vector<Eigen::Vector3d> outlineOf(const Ellipsoid& ellipsoid, const Plot& plot);
    void paintPlots(QPainter& painter) const;
    void paintFrame(QPainter& painter, const Plot& plot) const;
    void paintContent(QPainter& painter, const Plot& plot) const;
    void paintPoints(QPainter& painter, const Plot& plot) const;
};

} // namespace gripscope
