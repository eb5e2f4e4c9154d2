// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/recursive_estimator.h"

#include <QFrame>

#include <array>

class QLabel;

namespace gripscope {

/// m, b and k of the squeeze under way in one line, with their 95 % intervals.
class LiveEstimateCard : public QFrame {
    Q_OBJECT
public:
    explicit LiveEstimateCard(QWidget* parent = nullptr);
    void show(const std::optional<RecursiveState>& state, bool following, const QString& forceUnit,
              const QString& positionUnit);
    using QWidget::show;

private:
    QLabel* m_what;
    std::array<QLabel*, 3> m_values;
    QLabel* m_samples;
};

} // namespace gripscope
