// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/yield_strip.h"

#include "ui/theme/theme.h"
#include "ui/widgets/outcome_view.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace gripscope {

namespace {
constexpr int columns = 10;
constexpr int rows = static_cast<int>(YieldStrip::length) / columns;
} // namespace

YieldStrip::YieldStrip(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    setLines({});
}

void YieldStrip::setLines(std::deque<InspectionLine> lines)
{
    while (lines.size() > length)
        lines.pop_front();
    m_lines = std::move(lines);
    const auto good = std::count_if(m_lines.begin(), m_lines.end(), [](const InspectionLine& line) {
        return line.outcome == InspectionOutcome::AsExpected;
    });
    setAccessibleName(tr("Last %1 inspections: %2 as expected").arg(m_lines.size()).arg(good));
    update();
}

QRect YieldStrip::cell(int place) const
{
    const int row = place / columns;
    const int column = place % columns;
    const int left = column * width() / columns;
    const int top = row * height() / rows;
    return {QPoint(left, top), QPoint((column + 1) * width() / columns - 1, (row + 1) * height() / rows - 1)};
}

const InspectionLine* YieldStrip::at(const QPoint& point) const
{
    for (std::size_t place = 0; place < m_lines.size(); ++place)
        if (cell(static_cast<int>(place)).contains(point))
            return &m_lines[place];
    return nullptr;
}

void YieldStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const ThemeTokens& t = Theme::instance().tokens();
    for (int place = 0; place < static_cast<int>(length); ++place) {
        const QRectF box = QRectF(cell(place)).adjusted(2, 2, -2, -2);
        if (static_cast<std::size_t>(place) >= m_lines.size()) {
            painter.fillRect(QRectF(box.left() + 8, box.center().y() - 1, box.width() - 16, 2), t.line);
            continue;
        }
        const InspectionOutcome outcome = m_lines[static_cast<std::size_t>(place)].outcome;
        const QColor color = Theme::instance().outcomeColor(outcome);
        if (static_cast<std::size_t>(place) + 1 == m_lines.size()) { // the newest is framed
            painter.setPen(QPen(color, t.lineWidth));
            painter.setBrush(Qt::NoBrush);
            painter.drawRect(box.adjusted(0.5, 0.5, -0.5, -0.5));
        }
        paintOutcomeSign(painter, QRectF(box.center() - QPointF(8.5, 8.5), QSizeF(17, 17)), outcome, color);
    }
}

void YieldStrip::mouseReleaseEvent(QMouseEvent* event)
{
    const InspectionLine* line = at(event->position().toPoint());
    if (line && event->button() == Qt::LeftButton)
        emit opened(line->graspId, line->number);
}

bool YieldStrip::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const InspectionLine* line = at(help->pos());
    QToolTip::showText(help->globalPos(), line ? inWords(*line) : QString(), this);
    return true;
}

} // namespace gripscope
