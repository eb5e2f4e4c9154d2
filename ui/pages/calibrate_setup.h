// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_plan.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace gripscope {

class Workbench;

/// What a calibration is to be: the channel, the loads, how often, against what. Says at once what is wrong.
class CalibrateSetup : public QWidget {
    Q_OBJECT
public:
    explicit CalibrateSetup(Workbench& workbench, QWidget* parent = nullptr);
    [[nodiscard]] CalibrationPlan plan() const; ///< loads in the channel's unit

signals:
    void begun(const gripscope::CalibrationPlan& plan);

private:
    void build();
    void proposeLoads();
    void validate();
    /// Loads as they are typed, newtons or millimetres; nothing when it is not a list of numbers.
    [[nodiscard]] std::optional<std::vector<double>> typedLoads() const;
    enum class Way { Weights, LoadCell, GaugeBlocks };
    [[nodiscard]] Way way() const;
    [[nodiscard]] SensorChannel channel() const;
    [[nodiscard]] double perTyped() const; ///< channel's units in a newton or millimetre
    [[nodiscard]] QString problem() const;

    Workbench* m_workbench;
    QComboBox* m_channel;
    QLineEdit* m_loads;
    QSpinBox* m_runs;
    QCheckBox* m_descending;
    QSpinBox* m_degree;
    QLineEdit* m_reference;
    QLineEdit* m_certificate;
    QDoubleSpinBox* m_uncertainty;
    QLabel* m_summary;
    QPushButton* m_begin;
};

} // namespace gripscope
