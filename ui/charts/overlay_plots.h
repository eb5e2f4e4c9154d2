// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_stack.h"

#include <QString>

#include <memory>
#include <vector>

namespace gripscope {

class TimePlot;

/// A squeeze that lies over others, in its channels' units.
struct OverlaidSqueeze {
    using Values = std::shared_ptr<const std::vector<double>>;
    QString name; ///< "Inspection 12"
    QString forceUnit, positionUnit;
    Values time_s; ///< from its start, ascending
    Values force, position;
    bool held = false; ///< the force, between samples
};

/// The force and the position of several squeezes over each other, from the start of each. Squeezes in
/// other units than the first's are left out: they have no place on its axes.
class OverlayPlots : public PlotStack {
    Q_OBJECT
public:
    static constexpr std::size_t most = 20; ///< that can be told apart

    explicit OverlayPlots(QWidget* parent = nullptr);

    /// The first `most` of them.
    void setSqueezes(std::vector<OverlaidSqueeze> squeezes);
    [[nodiscard]] const std::vector<OverlaidSqueeze>& squeezes() const { return m_squeezes; }
    [[nodiscard]] TimePlot* position() const { return m_position; }
    [[nodiscard]] TimePlot* force() const { return m_force; }
    /// Time, force and position of each squeeze, as recorded.
    [[nodiscard]] PlotTable numbers() const override;

private:
    void showCurves();
    void refreshLegend();

    TimePlot* m_position;
    TimePlot* m_force;
    std::vector<OverlaidSqueeze> m_squeezes;
};

} // namespace gripscope
