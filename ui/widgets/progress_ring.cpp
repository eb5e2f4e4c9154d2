// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/progress_ring.h"

#include "ui/theme/theme.h"

#include <QPainter>

#include <algorithm>

namespace gripscope {

ProgressRing::ProgressRing(QWidget* parent) : QWidget(parent)
{
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void ProgressRing::setCount(int done, int wanted)
{
    if (done == m_done && wanted == m_wanted)
        return;
    m_done = done;
    m_wanted = std::max(1, wanted);
    setAccessibleName(tr("%1 of %2 squeezes").arg(m_done).arg(m_wanted));
    update();
}

void ProgressRing::setRunning(double share)
{
    if (share == m_running)
        return;
    m_running = share;
    update();
}

void ProgressRing::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeTokens& t = Theme::instance().tokens();
    const double size = std::min(width(), height()) - 4;
    const double thick = 12;
    QRectF circle(0, 0, size - thick, size - thick);
    circle.moveCenter(QRectF(rect()).center());
    // One segment a squeeze: the number can be counted as well as read.
    const double gap = m_wanted > 1 ? 4 : 0;
    const int shown = std::max(m_wanted, m_done);
    const double each = 360.0 / shown;
    for (int i = 0; i < shown; ++i) {
        const QColor color = i < m_done ? t.accent : Theme::mix(t.surface, t.secondText, 0.25);
        painter.setPen(QPen(color, thick, Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(circle, static_cast<int>((90 - i * each - gap / 2) * 16),
                        static_cast<int>(-(each - gap) * 16));
    }
    if (m_running >= 0) {
        const QRectF inner = circle.adjusted(12, 12, -12, -12);
        painter.setPen(QPen(t.force, 4, Qt::SolidLine, Qt::RoundCap));
        painter.drawArc(inner, 90 * 16, static_cast<int>(-360 * 16 * std::clamp(m_running, 0.0, 1.0)));
    }
    const bool large = size >= 160;
    const QFont number = Theme::font(large ? metrics::fontVerdict : metrics::fontNumber, true);
    const QFont words = Theme::font(large ? metrics::fontLarge : metrics::fontBase);
    const double tall = QFontMetricsF(number).capHeight();
    const double line = QFontMetricsF(words).height();
    const double base = circle.center().y() + (tall - line) / 2;
    painter.setPen(t.text);
    painter.setFont(number);
    painter.drawText(
        QRectF(circle.left(), base - 2 * tall, circle.width(), 2 * tall + QFontMetricsF(number).descent()),
        Qt::AlignHCenter | Qt::AlignBottom, QString::number(m_done));
    painter.setPen(t.secondText);
    painter.setFont(words);
    painter.drawText(QRectF(circle.left(), base + 4, circle.width(), line + 4),
                     Qt::AlignHCenter | Qt::AlignTop, tr("of %1").arg(m_wanted));
}

} // namespace gripscope
