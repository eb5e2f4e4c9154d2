// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/step_line.h"

#include "ui/theme/theme.h"
#include "ui/widgets/outcome_view.h"

#include <QPainter>

namespace gripscope {

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
