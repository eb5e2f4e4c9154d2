// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_export.h"

#include <QPen>
#include <QWidget>

#include <vector>

namespace gripscope {

class PlotFrame;

/// A line or a point of a figure's legend.
struct FigureSign {
    QString name;
    QPen pen;
    bool point = false;
    double fade = 1; ///< of a point: its share of the colour on the surface
};

/// Plots under each other as one figure, with a legend of as many lines as it needs below: on the screen and
/// as one picture. What is arranged is the same in both.
class PlotStack : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    explicit PlotStack(QWidget* parent = nullptr);

    void setLegend(std::vector<FigureSign> signs);
    [[nodiscard]] const std::vector<FigureSign>& legend() const { return m_legend; }
    [[nodiscard]] std::vector<PlotFrame*> plots() const;
    void setExportNames(const QString& plot, const QString& file);

    [[nodiscard]] QString plotName() const override { return m_plotName; }
    [[nodiscard]] QString fileName() const override { return m_fileName; }
    /// Higher than a single plot of the width asked for.
    [[nodiscard]] QSize pictureSize() const override;
    void setPictureSize(QSize size) override { m_pictureSize = size; }
    void paintPicture(QPainter& painter) override;
    /// Those of the plots side by side.
    [[nodiscard]] PlotTable numbers() const override;

    QSize sizeHint() const override { return {600, 420}; }
    QSize minimumSizeHint() const override;

protected:
    /// At the end, `stretch` of the height; it is the stack's then.
    void add(PlotFrame* plot, int stretch);
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct Part {
        PlotFrame* plot;
        int stretch;
    };
    struct Arrangement {
        std::vector<QRect> plots;
        QRect legend;
    };
    [[nodiscard]] Arrangement arrange(QSize size) const;
    void layOut();
    /// Paints nothing without a painter; returns the height.
    int paintLegend(QPainter* painter, QRect room) const;

    std::vector<Part> m_parts;
    std::vector<FigureSign> m_legend;
    QString m_plotName, m_fileName;
    QSize m_pictureSize;
};

} // namespace gripscope
