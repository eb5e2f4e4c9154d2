// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

namespace gripscope {

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
