// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace gripscope {

/// A ring that fills with the squeezes taken ("7 of 10"), and a thin one inside it for the squeeze under way.
class ProgressRing : public QWidget {
    Q_OBJECT
public:
    explicit ProgressRing(QWidget* parent = nullptr);
    void setCount(int done, int wanted);
    void setRunning(double share); ///< 0 to 1 of the squeeze under way; negative: none
    [[nodiscard]] QSize sizeHint() const override { return {168, 168}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {96, 96}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int m_done = 0, m_wanted = 10;
    double m_running = -1;
};

} // namespace gripscope
