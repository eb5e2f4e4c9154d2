// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/progress.h"

#include "ui/theme/theme.h"
#include "ui/widgets/outcome_view.h"

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
    // One segment a squeeze: the number can be counted as well as read, as long as there are gaps to be seen.
    const int shown = std::max(m_wanted, m_done);
    const double each = 360.0 / shown;
    const double gap = m_wanted > 1 && each >= 8 ? 4 : 0;
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

StepLine::StepLine(QStringList steps, QWidget* parent) : QWidget(parent), m_steps(std::move(steps))
{
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCurrent(0);
}

void StepLine::setCurrent(int step)
{
    m_current = step;
    if (step >= 0 && step < m_steps.size())
        setAccessibleName(tr("Step %1 of %2: %3").arg(step + 1).arg(m_steps.size()).arg(m_steps[step]));
    else
        setAccessibleName(tr("All steps done"));
    update();
}

void StepLine::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeTokens& t = Theme::instance().tokens();
    const auto count = static_cast<int>(m_steps.size());
    const double each = static_cast<double>(width()) / count;
    const double y = 15;
    const double radius = 13;
    for (int i = 0; i < count; ++i) {
        const QPointF c(each * (i + 0.5), y);
        const bool done = i < m_current;
        if (i + 1 < count) {
            painter.setPen(QPen(done ? t.accent : t.line, 2));
            painter.drawLine(QPointF(c.x() + radius + 6, y), QPointF(c.x() + each - radius - 6, y));
        }
        const bool present = i == m_current;
        painter.setPen(QPen(done || present ? t.accent : t.secondText, present ? 2 : 1.5));
        painter.setBrush(present ? t.accent : t.surface);
        painter.drawEllipse(c, radius, radius);
        const QRectF disc(c.x() - radius, c.y() - radius, 2 * radius, 2 * radius);
        if (done) {
            paintOutcomeSign(painter, disc.adjusted(5, 5, -5, -5), InspectionOutcome::AsExpected, t.accent);
        } else {
            painter.setPen(present ? Theme::onColor(t.accent) : t.secondText);
            painter.setFont(Theme::font(metrics::fontSmall, true));
            painter.drawText(disc, Qt::AlignCenter, QString::number(i + 1));
        }
        painter.setPen(present ? t.text : t.secondText);
        painter.setFont(Theme::font(metrics::fontBase, present));
        painter.drawText(QRectF(each * i, 32, each, 24), Qt::AlignHCenter | Qt::AlignVCenter, m_steps[i]);
    }
}

} // namespace gripscope
