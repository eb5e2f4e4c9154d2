// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

namespace gripscope {

/// The force of a squeeze as it will go, between zero and the crush limit: how far, how fast, on how many
/// levels. A look, without numbers of its own.
class ForcePicture : public QWidget {
    Q_OBJECT
public:
    explicit ForcePicture(QWidget* parent = nullptr);
    /// In the order of time, at equal steps; none: an empty frame.
    void show(std::vector<double> force_N, double limit_N);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<double> m_force_N;
    double m_limit_N = 0;
};

} // namespace gripscope
