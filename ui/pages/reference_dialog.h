// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace gripscope {

/// What is known of a reference object, and how often a gripper is to be checked on it. Says at once what is
/// wrong.
class ReferenceDialog : public QDialog {
    Q_OBJECT
public:
    explicit ReferenceDialog(const ReferenceObject& reference, QWidget* parent = nullptr);
    [[nodiscard]] ReferenceObject reference() const;

private:
    struct Quantity {
        QCheckBox* stated;
        QDoubleSpinBox *value, *uncertainty, *tolerance; ///< the latter two in percent of the value
    };
    void build();
    void addQuantity(QGridLayout* grid, int row, std::size_t parameter);
    void show(const ReferenceObject& reference);
    void validate();

    ReferenceObject m_known; ///< what is not edited here
    QLineEdit *m_name, *m_certificate;
    std::array<Quantity, 3> m_quantities{}; ///< m, b, k
    QDoubleSpinBox *m_bias, *m_peak;
    QSpinBox* m_squeezes;
    QComboBox* m_interval;
    QLabel* m_words;
    QPushButton* m_keep;
};

} // namespace gripscope
