// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/inspection_list.h"

#include <QWidget>

#include <deque>

namespace gripscope {

/// The last twenty inspections as a sign each, in two rows like text: the newest is the last. Shape tells
/// them apart as well as colour; a click on one opens its squeeze.
class YieldStrip : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t length = 20;
    explicit YieldStrip(QWidget* parent = nullptr);
    void setLines(std::deque<InspectionLine> lines); ///< oldest first; the last twenty are shown
    [[nodiscard]] QRect cell(int place) const;       ///< 0 to 19
    [[nodiscard]] QSize sizeHint() const override { return {272, 64}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 64}; }

signals:
    void opened(const QString& graspId, qint64 number);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] const InspectionLine* at(const QPoint& point) const;
    std::deque<InspectionLine> m_lines;
};

} // namespace gripscope
