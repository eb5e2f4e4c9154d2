// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/frequency/frequency_response.h"
#include "ui/charts/plot_frame.h"
#include "ui/charts/plot_stack.h"

#include <optional>
#include <vector>

class QLineSeries;
class QScatterSeries;

namespace gripscope {

/// Values in shown units over ascending frequencies; `low` and `high`, the ends of 95 % intervals, may be
/// empty.
struct FrequencyCurve {
    std::vector<double> frequency_Hz, value, low, high;
    void append(double frequency, double at);
    void append(double frequency, double at, double from, double to);
};

/// A quantity over a logarithmic frequency axis: the model as a line with its band, what was measured as
/// points with their intervals, and pale, without intervals, the points that are worth little.
class FrequencyPlot : public PlotFrame {
    Q_OBJECT
public:
    explicit FrequencyPlot(QWidget* parent = nullptr);

    void setCurves(FrequencyCurve model, FrequencyCurve measured, FrequencyCurve doubtful);
    [[nodiscard]] const FrequencyCurve& model() const { return m_model; }
    [[nodiscard]] const FrequencyCurve& measured() const { return m_measured; }
    [[nodiscard]] const FrequencyCurve& doubtful() const { return m_doubtful; }
    /// The values are shown on a logarithmic axis, too; those that are not above zero are left out.
    void setLogarithmicValues();
    /// The range of everything but of the doubtful points, which may be anywhere.
    void fitVertical();
    [[nodiscard]] PlotTable numbers() const override;

protected:
    void themeChanged() override;
    void drawBackground(QPainter* painter, const QRectF& rect) override;
    [[nodiscard]] bool empty() const override;

private:
    [[nodiscard]] double drawn(double value) const; ///< its place on the vertical axis
    void fill(QXYSeries& series, const FrequencyCurve& curve) const;
    [[nodiscard]] QPolygonF band() const;

    QLineSeries* m_line;
    QScatterSeries *m_points, *m_pale;
    FrequencyCurve m_model, m_measured, m_doubtful;
    bool m_logarithmicValues = false;
};

/// What a squeeze's Bode plot shows.
struct BodeContent {
    std::optional<EmpiricalResponse> measured; ///< none yet
    std::vector<ModelLine> model;              ///< empty: there is none
    QString modelName;                         ///< "output error"
    QString unit;                              ///< of the magnitude as shown; empty: the source names none
    double factor = 1;                         ///< shown magnitude = magnitude * factor
};

/// The transfer function from force to position: magnitude, phase and coherence of what was measured with the
/// model's over them. What of it is not reliable is pale, and it is said where the coherence is too low.
class BodePlots : public PlotStack {
    Q_OBJECT
public:
    explicit BodePlots(QWidget* parent = nullptr);

    void show(const BodeContent& content);
    using QWidget::show;

    [[nodiscard]] FrequencyPlot* magnitude() const { return m_magnitude; }
    [[nodiscard]] FrequencyPlot* phase() const { return m_phase; }
    [[nodiscard]] FrequencyPlot* coherence() const { return m_coherence; }

private:
    void showMeasured(const BodeContent& content);
    void showFinding(const std::optional<EmpiricalResponse>& measured);
    void refreshLegend();
    void linkFrequencies();

    FrequencyPlot* m_magnitude;
    FrequencyPlot* m_phase;
    FrequencyPlot* m_coherence;
    QString m_modelName;
};

} // namespace gripscope
