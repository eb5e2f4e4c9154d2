// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/axis_ticks.h"
#include "ui/charts/plot_export.h"

#include <Eigen/Core>
#include <QColor>
#include <QString>
#include <QWidget>

#include <vector>

namespace gripscope {

struct SpaceClustering;
struct TypeSpace;

/// One number for every unit of a self-organizing map, as a picture of its grid.
struct MapPlane {
    QString title;          ///< "Mass m"
    QString meaning;        ///< what it shows, in a sentence
    AxisScale scale;        ///< unit and digits; low and high are the extremes of `values`
    Eigen::MatrixXd values; ///< rows x columns of the grid
};

/// The map as pictures side by side: the U-matrix, then the component planes of m, b and k.
struct MapPlanes {
    int rows = 0, columns = 0;
    std::vector<MapPlane> planes;
    std::vector<int> hits;         ///< squeezes a unit; unit of row r and column c: r * columns + c
    std::vector<int> groups;       ///< cluster of each unit, from 0
    std::vector<QString> squeezes; ///< who is in a unit, in words: "3 squeezes: 2 of A, 1 of B"

    /// A unit in words: its number in that plane, who is there, where it is.
    [[nodiscard]] QString describe(int unit, int plane) const;
};

/// Empty where the clustering is not a map's.
[[nodiscard]] MapPlanes mapPlanes(const TypeSpace& space, const SpaceClustering& clustering);

/// A colour for a number between 0 (dark blue) and 1 (yellow): lightness rises evenly, and it reads the same
/// to people with any kind of colour blindness. Numbers outside are taken for the nearer end.
/// Source: Nunez, Anderton and Renslow, Optimizing colormaps with consideration for color vision deficiency
/// (cividis, 2018), ten of its colours with straight lines between them.
[[nodiscard]] QColor scaleColor(double share);

/// One plane of a self-organizing map: a cell a unit, its colour the number, borders where the cluster
/// changes, a colour bar with the extremes and the unit below. Pointing at a cell, or going there with the
/// arrow keys, tells the number and the squeezes there.
class HeatMap : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    explicit HeatMap(QWidget* parent = nullptr);

    /// `plane`: index into MapPlanes::planes. With `hits`, a dot grows with the squeezes of each unit.
    void setPlane(const MapPlanes& map, int plane, bool hits);
    /// Frames a unit, -1 none; the same one in all planes shows what belongs together.
    void setMarked(int unit);
    [[nodiscard]] int marked() const { return m_marked; }
    /// The unit whose cell is there, -1 outside.
    [[nodiscard]] int unitAt(QPointF position) const;
    [[nodiscard]] QRectF cell(int unit) const;
    [[nodiscard]] QColor color(int unit) const;
    /// What pointing at a unit tells.
    [[nodiscard]] QString tip(int unit) const;

    [[nodiscard]] QString plotName() const override;
    [[nodiscard]] QString fileName() const override;
    [[nodiscard]] QSize pictureSize() const override;
    void setPictureSize(QSize size) override { m_pictureSize = size; }
    void paintPicture(QPainter& painter) override;
    /// A row a unit: its place on the grid, its number, the squeezes there, its cluster.
    [[nodiscard]] PlotTable numbers() const override;

    QSize sizeHint() const override { return {116, 148}; }
    QSize minimumSizeHint() const override { return {80, 112}; }

signals:
    void pointedAt(int unit); ///< -1: none any more

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    [[nodiscard]] bool empty() const { return m_map.planes.empty(); }
    [[nodiscard]] const MapPlane& plane() const { return m_map.planes[std::size_t(m_plane)]; }
    [[nodiscard]] QRectF grid() const;
    void point(int unit);
    void paint(QPainter& painter) const;
    void paintCells(QPainter& painter) const;
    void paintBorders(QPainter& painter) const;
    void paintHits(QPainter& painter) const;
    void paintBar(QPainter& painter) const;

    MapPlanes m_map;
    int m_plane = 0;
    int m_marked = -1;
    bool m_hits = false;
    QSize m_pictureSize; ///< valid: in place of that on the screen
};

} // namespace gripscope
