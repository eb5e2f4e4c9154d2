// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/yield_strip.h"

#include "ui/theme/theme.h"
#include "ui/widgets/outcome_view.h"

#include <QPainter>

#include <algorithm>

namespace gripscope {

YieldStrip::YieldStrip(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    setOutcomes({});
}

void YieldStrip::setOutcomes(std::deque<InspectionOutcome> outcomes)
{
    while (outcomes.size() > length)
        outcomes.pop_front();
    m_outcomes = std::move(outcomes);
    const auto good = std::count(m_outcomes.begin(), m_outcomes.end(), InspectionOutcome::AsExpected);
    setAccessibleName(tr("Last %1 inspections: %2 as expected").arg(m_outcomes.size()).arg(good));
    setToolTip(accessibleName());
    update();
}

void YieldStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const ThemeTokens& t = Theme::instance().tokens();
    const double each = static_cast<double>(width()) / static_cast<double>(length);
    const double bar = std::max(2.0, each - 2);
    const double signs = 14;
    const double floor = height() - 1;
    painter.fillRect(QRectF(0, floor, width(), 1), t.line);
    double x = width() - each * static_cast<double>(m_outcomes.size());
    double lastSign = -100;
    for (const InspectionOutcome outcome : m_outcomes) {
        const QColor color = Theme::instance().outcomeColor(outcome);
        const bool good = outcome == InspectionOutcome::AsExpected;
        const double tall = good ? (floor - signs) * 0.45 : floor - signs;
        painter.fillRect(QRectF(x, floor - tall, bar, tall), color);
        // A sign over what was not as expected, where the one before leaves room.
        if (!good && x - lastSign >= 12) {
            paintOutcomeSign(painter, QRectF(x + bar / 2 - 6, 0, 12, 12), outcome, color);
            lastSign = x;
        }
        x += each;
    }
}

} // namespace gripscope
