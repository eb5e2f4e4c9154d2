// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
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

/// The steps of a job on one line: done ones with a check, the present one filled, the others to come.
class StepLine : public QWidget {
    Q_OBJECT
public:
    explicit StepLine(QStringList steps, QWidget* parent = nullptr);
    void setCurrent(int step); ///< beyond the last: all done
    [[nodiscard]] int current() const { return m_current; }
    [[nodiscard]] QSize sizeHint() const override { return {560, 56}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {360, 56}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QStringList m_steps;
    int m_current = 0;
};

} // namespace gripscope
