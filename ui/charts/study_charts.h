// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/quality/study_result.h"
#include "ui/charts/plot_export.h"
#include "ui/theme/theme.h"

#include <QCoreApplication>
#include <QPointF>
#include <QStringList>
#include <QWidget>

#include <array>
#include <optional>
#include <vector>

namespace gripscope {

/// Values by part, by operator, by source of scatter: what stands along the horizontal axis has names, no
/// numbers.
struct CategoryChart {
    enum class Marks { Bars, Points, Lines }; ///< Lines: points that are joined
    struct Series {
        QString name;  ///< empty: not in the legend
        int place = 0; ///< of its colour and shape, Theme::typeColor()
        Marks marks = Marks::Points;
        std::vector<QPointF> points; ///< x: place of the category, from 0, with a shift to keep points apart
    };
    struct Level {
        double value = 0;
        QString name;
        bool limit = false; ///< dashed, in the colour of what is not valid; else a centre line
    };
    struct Group {
        QString name;
        int categories = 0; ///< so many of the next ones
    };
    QString title;      ///< with its unit: "Stiffness k by part (kN/m)"
    QString fileName;   ///< "study_parts"
    QString empty = {}; ///< what is said where there is nothing to draw
    QStringList categories;
    QString categoryTitle = {};
    std::vector<Group> groups = {};
    std::vector<Series> series;
    std::vector<Level> levels = {};
    bool fromZero = false;
    std::optional<double> top = {}; ///< of the axis, where it is known beforehand
};

/// Paints it into `area` (logical pixels) in these colours; nothing outside. On any thread.
void paintCategoryChart(QPainter& painter, const QRectF& area, const CategoryChart& chart,
                        const ThemeTokens& tokens);

/// The chart on the screen, in the colours of the theme.
class CategoryPlot : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    explicit CategoryPlot(QWidget* parent = nullptr);
    void setChart(CategoryChart chart);
    [[nodiscard]] const CategoryChart& chart() const { return m_chart; }

    [[nodiscard]] QString plotName() const override { return m_chart.title; }
    [[nodiscard]] QString fileName() const override { return m_chart.fileName; }
    [[nodiscard]] QSize pictureSize() const override;
    void setPictureSize(QSize size) override { m_pictureSize = size; }
    void paintPicture(QPainter& painter) override;
    /// A row a point: series, category, value.
    [[nodiscard]] PlotTable numbers() const override;

    QSize sizeHint() const override { return {420, 240}; }
    QSize minimumSizeHint() const override { return {240, 200}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    CategoryChart m_chart;
    QSize m_pictureSize; ///< valid: in place of that on the screen
};

/// The charts of a study, as they are on the screen and on paper.
class StudyCharts {
    Q_DECLARE_TR_FUNCTIONS(StudyCharts)
public:
    /// "Repeatability", "Operator", ...
    [[nodiscard]] static QString component(GaugeComponent component);
    /// Where m, b, k is among the values of a measurement; 0 for another name.
    [[nodiscard]] static std::size_t placeOf(const QString& quantity);

    /// Components of variation; measurements by part; by operator; ranges by operator and part; interaction.
    static constexpr std::size_t count = 5;
    [[nodiscard]] static std::array<CategoryChart, count> of(const KeptStudy& study,
                                                             const GaugeResult& result, std::size_t quantity);
    /// The one chart of another kind: of a type-1 study its readings in their order beside the reference, of
    /// linearity the bias of each reading by reference, of attributes the parts that each rater judges alike,
    /// and right; empty for a gauge study.
    [[nodiscard]] static CategoryChart single(const KeptStudy& study, const StudyResult& result);
};

} // namespace gripscope
