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
/// Below it one line is harder to read from afar than two larger ones.
constexpr int leastOneLine = 44;

/// The line box of a large font is taller than its letters: this brings lines together.
double lineHeight(const QFontMetricsF& metrics)
{
    return metrics.ascent() * 0.92 + metrics.descent() * 0.7;
}

/// Broken at the space that leaves the longer line shortest; nothing where that does not fit.
QStringList inTwoLines(const QString& text, const QFontMetricsF& metrics, double room)
{
    QStringList best;
    double shortest = room;
    for (qsizetype at = text.indexOf(u' '); at > 0; at = text.indexOf(u' ', at + 1)) {
        const QStringList lines{text.left(at), text.mid(at + 1)};
        const double longer =
            std::max(metrics.horizontalAdvance(lines[0]), metrics.horizontalAdvance(lines[1]));
        if (longer <= shortest) {
            shortest = longer;
            best = lines;
        }
    }
    return best;
}
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

VerdictPanel::Headline VerdictPanel::fitted(double room, double tall) const
{
    const int most = m_outcome ? metrics::fontVerdict : metrics::fontNumber;
    for (int pixels = most; pixels >= metrics::fontNumber; pixels -= 2) {
        const QFontMetricsF font(Theme::font(pixels, true));
        const QStringList two = pixels < leastOneLine ? inTwoLines(m_headline, font, room) : QStringList();
        if (font.horizontalAdvance(m_headline) <= room && lineHeight(font) <= tall)
            return {{m_headline}, pixels};
        if (!two.isEmpty() && 2 * lineHeight(font) <= tall)
            return {two, pixels};
    }
    const QFontMetricsF least(Theme::font(metrics::fontNumber, true));
    return {{least.elidedText(m_headline, Qt::ElideRight, room)}, metrics::fontNumber};
}

void VerdictPanel::paintWords(QPainter& painter, double left, const QColor& color) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    const double room = width() - left - padding;
    const QFont small = Theme::font(metrics::fontTitle, m_outcome.has_value());
    const QFontMetricsF smallMetrics(small);
    const Headline headline = fitted(room, height() - smallMetrics.height() - 16);
    const QFont large = Theme::font(headline.pixels, true);
    const QFontMetricsF largeMetrics(large);
    const double each = lineHeight(largeMetrics);
    const double largeHeight = each * static_cast<double>(headline.lines.size());
    const double top = (height() - largeHeight - smallMetrics.height()) / 2;
    const QString words = smallMetrics.elidedText(m_words, Qt::ElideRight, room);
    if (m_outcome && t.kind == ThemeKind::HighContrast) {
        double wide = smallMetrics.horizontalAdvance(words);
        for (const QString& line : headline.lines)
            wide = std::max(wide, largeMetrics.horizontalAdvance(line));
        painter.fillRect(QRectF(left - 8, top, wide + 16, largeHeight + smallMetrics.height()), t.surface);
    }
    painter.setPen(m_outcome ? color : t.text);
    painter.setFont(large);
    double baseline = top + largeMetrics.ascent() * 0.92;
    for (const QString& line : headline.lines) {
        painter.drawText(QPointF(left, baseline), line);
        baseline += each;
    }
    painter.setFont(small);
    painter.setPen(m_outcome ? color : t.secondText);
    painter.drawText(QPointF(left, top + largeHeight + smallMetrics.ascent()), words);
}

} // namespace gripscope
