// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/verdict_panel.h"

#include "ui/theme/theme.h"
#include "ui/widgets/outcome_view.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace gripscope {

namespace {
constexpr double signSize = 88;
constexpr double padding = 24;
} // namespace

VerdictPanel::VerdictPanel(QWidget* parent) : QWidget(parent)
{
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void VerdictPanel::setWords(const QString& headline, const QString& words)
{
    m_headline = headline;
    m_words = words;
    setAccessibleName(headline);
    setAccessibleDescription(words);
    update();
}

void VerdictPanel::showOutcome(InspectionOutcome outcome, const QString& headline, const QString& words)
{
    m_outcome = outcome;
    setWords(headline, words);
}

void VerdictPanel::showHint(const QString& headline, const QString& words)
{
    m_outcome.reset();
    setWords(headline, words);
}

void VerdictPanel::setProgress(double share)
{
    if (share == m_progress)
        return;
    m_progress = share;
    update();
}

void VerdictPanel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeTokens& t = Theme::instance().tokens();
    const double w = t.lineWidth;
    QPainterPath frame;
    frame.addRoundedRect(QRectF(rect()).adjusted(w / 2, w / 2, -w / 2, -w / 2), metrics::radius,
                         metrics::radius);
    painter.fillPath(frame, t.surface);
    const QColor color = m_outcome ? Theme::instance().outcomeColor(*m_outcome) : t.secondText;
    double left = padding;
    if (m_outcome) {
        painter.fillPath(frame, outcomeFill(*m_outcome));
        const QRectF box(padding, (height() - signSize) / 2, signSize, signSize);
        if (t.kind == ThemeKind::HighContrast)
            painter.fillRect(box, t.surface);
        paintOutcomeSign(painter, box, *m_outcome, color);
        left = box.right() + padding;
    }
    painter.setPen(QPen(m_outcome ? color : t.line, m_outcome ? 2 : w));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(frame);
    paintWords(painter, left, color);
    if (m_progress >= 0) {
        painter.setClipPath(frame);
        painter.fillRect(QRectF(0, height() - 6, width() * std::min(m_progress, 1.0), 6), t.accent);
    }
}

void VerdictPanel::paintWords(QPainter& painter, double left, const QColor& color) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    const double room = width() - left - padding;
    int pixels = m_outcome ? metrics::fontVerdict : metrics::fontNumber;
    const int least = std::min(pixels, static_cast<int>(metrics::fontNumber));
    const double tall = height() - 44 - metrics::fontTitle; // what the line below and some air leave
    while (pixels > least &&
           (QFontMetricsF(Theme::font(pixels, true)).horizontalAdvance(m_headline) > room || pixels > tall))
        pixels -= 2;
    const QFont large = Theme::font(pixels, true);
    const QFont small = Theme::font(metrics::fontTitle, m_outcome.has_value());
    const QFontMetricsF largeMetrics(large);
    const QFontMetricsF smallMetrics(small);
    // The line box of the large font is taller than its letters: bring the two lines together.
    const double largeHeight = largeMetrics.ascent() * 0.92 + largeMetrics.descent() * 0.7;
    const double top = (height() - largeHeight - smallMetrics.height()) / 2;
    const QString headline = largeMetrics.elidedText(m_headline, Qt::ElideRight, room);
    const QString words = smallMetrics.elidedText(m_words, Qt::ElideRight, room);
    if (m_outcome && t.kind == ThemeKind::HighContrast)
        painter.fillRect(
            QRectF(left - 8, top,
                   std::max(largeMetrics.horizontalAdvance(headline), smallMetrics.horizontalAdvance(words)) +
                       16,
                   largeHeight + smallMetrics.height()),
            t.surface);
    painter.setPen(m_outcome ? color : t.text);
    painter.setFont(large);
    painter.drawText(QPointF(left, top + largeMetrics.ascent() * 0.92), headline);
    painter.setFont(small);
    painter.setPen(m_outcome ? color : t.secondText);
    painter.drawText(QPointF(left, top + largeHeight + smallMetrics.ascent()), words);
}

} // namespace gripscope
