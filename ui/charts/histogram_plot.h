// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/control_series.h"
#include "ui/theme/theme.h"

#include <QWidget>

class QPainter;

namespace gripscope {

/// How often values of a quantity fall where, with the curve of a normal process of the same mean and overall
/// deviation, and the tolerance limits. On any thread, nothing outside of `box`.
void paintHistogram(QPainter& painter, const ProcessCapability& capability, const ShownUnit& unit,
                    const QRectF& box, const ThemeTokens& tokens);

class HistogramPlot : public QWidget {
    Q_OBJECT
public:
    explicit HistogramPlot(QWidget* parent = nullptr);
    /// Nothing: there is none.
    void setCapability(std::optional<ProcessCapability> capability, const ShownUnit& unit);
    [[nodiscard]] const std::optional<ProcessCapability>& capability() const { return m_capability; }
    [[nodiscard]] QSize sizeHint() const override { return {240, 150}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 130}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<ProcessCapability> m_capability;
    ShownUnit m_unit;
};

} // namespace gripscope
