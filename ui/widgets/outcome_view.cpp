// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/outcome_view.h"

#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QPen signPen(const QColor& color, double size)
{
    return QPen(color, size * 0.11, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}

void paintArrow(QPainter& painter, QPointF from, QPointF to, double head)
{
    painter.drawLine(from, to);
    painter.drawLine(to, {to.x() - head, to.y()});
    painter.drawLine(to, {to.x(), to.y() + (to.y() < from.y() ? head : -head)});
}

void paintGlyph(QPainter& painter, const QRectF& box, const QString& glyph, const QColor& color,
                double height)
{
    QFont font = Theme::font(static_cast<int>(std::max(4.0, height * 1.4)));
    font.setWeight(QFont::Bold);
    QPainterPath path;
    path.addText(0, 0, font, glyph);
    const QRectF bounds = path.boundingRect();
    painter.save();
    painter.translate(box.center());
    painter.scale(height / bounds.height(), height / bounds.height());
    painter.translate(-bounds.center());
    painter.fillPath(path, color);
    painter.restore();
}

void paintTriangle(QPainter& painter, const QRectF& box, const QColor& color, double size)
{
    const double s = size;
    const QPointF top(box.center().x(), box.center().y() - 0.38 * s);
    const QPolygonF triangle{
        top, {top.x() + 0.44 * s, top.y() + 0.76 * s}, {top.x() - 0.44 * s, top.y() + 0.76 * s}};
    painter.setPen(QPen(color, s * 0.08, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolygon(triangle);
    painter.setPen(signPen(color, s * 0.85));
    painter.drawLine(QPointF(top.x(), top.y() + 0.27 * s), QPointF(top.x(), top.y() + 0.46 * s));
    painter.drawPoint(QPointF(top.x(), top.y() + 0.62 * s));
}

} // namespace

void paintOutcomeSign(QPainter& painter, const QRectF& box, InspectionOutcome outcome, const QColor& color)
{
    const double s = std::min(box.width(), box.height());
    const QPointF c = box.center();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(signPen(color, s));
    switch (outcome) {
    case InspectionOutcome::AsExpected:
        painter.drawPolyline(QPolygonF{{c.x() - 0.36 * s, c.y() + 0.03 * s},
                                       {c.x() - 0.10 * s, c.y() + 0.29 * s},
                                       {c.x() + 0.38 * s, c.y() - 0.27 * s}});
        break;
    case InspectionOutcome::OtherType:
        paintArrow(painter, {c.x() - 0.36 * s, c.y() + 0.3 * s}, {c.x() + 0.36 * s, c.y() - 0.3 * s},
                   0.26 * s);
        paintArrow(painter, {c.x() - 0.36 * s, c.y() - 0.3 * s}, {c.x() + 0.36 * s, c.y() + 0.3 * s},
                   0.26 * s);
        break;
    case InspectionOutcome::Unknown:
        paintGlyph(painter, box, u"?"_s, color, 0.8 * s);
        break;
    case InspectionOutcome::Inconclusive:
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        for (const double x : {-0.32, 0.0, 0.32})
            painter.drawEllipse(QPointF(c.x() + x * s, c.y()), 0.1 * s, 0.1 * s);
        break;
    case InspectionOutcome::NotValid:
        paintTriangle(painter, box, color, s);
        break;
    case InspectionOutcome::DoesNotConform:
        painter.drawEllipse(c, 0.36 * s, 0.36 * s);
        painter.drawLine(QPointF(c.x() - 0.25 * s, c.y() + 0.25 * s),
                         QPointF(c.x() + 0.25 * s, c.y() - 0.25 * s));
        break;
    }
    painter.restore();
}

void paintJudgedSign(QPainter& painter, const QRectF& box, InspectionOutcome outcome, bool suspect)
{
    const Theme& theme = Theme::instance();
    if (!suspect)
        return paintOutcomeSign(painter, box, outcome, theme.outcomeColor(outcome));
    const QPointF c = box.center();
    const double reach = std::min(box.width(), box.height()) / 2;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.tokens().suspect);
    painter.drawPolygon(QPolygonF{
        {c.x(), c.y() - reach}, {c.x() + reach, c.y()}, {c.x(), c.y() + reach}, {c.x() - reach, c.y()}});
    painter.restore();
    constexpr double inside = 0.52;
    const QRectF within(c.x() - inside * reach, c.y() - inside * reach, 2 * inside * reach,
                        2 * inside * reach);
    paintOutcomeSign(painter, within, outcome, Theme::onColor(theme.tokens().suspect));
}

QBrush suspectStripes()
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    return {Theme::mix(tokens.surface, tokens.suspect, tokens.kind == ThemeKind::Light ? 0.35 : 0.4),
            Qt::FDiagPattern};
}

QBrush outcomeFill(InspectionOutcome outcome)
{
    const Theme& theme = Theme::instance();
    const ThemeTokens& tokens = theme.tokens();
    if (tokens.kind != ThemeKind::HighContrast)
        return Theme::mix(tokens.surface, theme.outcomeColor(outcome),
                          tokens.kind == ThemeKind::Dark ? 0.10 : 0.07);
    QColor faint = Theme::mix(tokens.surface, tokens.text, 0.35);
    switch (outcome) {
    case InspectionOutcome::AsExpected:
        return tokens.surface;
    case InspectionOutcome::OtherType:
        return {faint, Qt::DiagCrossPattern};
    case InspectionOutcome::Unknown:
        return {faint, Qt::BDiagPattern};
    case InspectionOutcome::Inconclusive:
        return {faint, Qt::Dense7Pattern};
    case InspectionOutcome::NotValid:
        return {faint, Qt::HorPattern};
    case InspectionOutcome::DoesNotConform:
        return {faint, Qt::VerPattern};
    }
    return tokens.surface;
}

namespace {
constexpr double padding = 24;
/// Of the field: the sign is read from as far as the words, and leaves them most of the width.
constexpr double signOfHeight = 0.7, signOfWidth = 0.2, leastSign = 64;
/// Of the field's height: the words below the headline.
constexpr double wordsOfHeight = 0.13;
constexpr int largestHeadline = 400;
constexpr double suspectFrame = 8;
/// Below it one line is harder to read from afar than two larger ones.
constexpr int leastOneLine = 44;

/// The line box of a large font is taller than its letters: this brings lines together.
double lineHeight(const QFontMetricsF& metrics)
{
    return metrics.ascent() * 0.92 + metrics.descent() * 0.7;
}

/// What one line of this text cannot exceed in this room: measured once, as letters grow in proportion.
int largestThatMayFit(const QString& text, double room, double tall)
{
    constexpr int measured = metrics::fontVerdict;
    const QFontMetricsF font(Theme::font(measured, true));
    const double growth =
        std::min(room / std::max(1.0, font.horizontalAdvance(text)), tall / lineHeight(font));
    constexpr int rounding = 4; // of hinted letters
    return std::clamp(static_cast<int>(growth * measured) + rounding, leastOneLine, largestHeadline);
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

void VerdictPanel::showOutcome(InspectionOutcome outcome, const QString& headline, const QString& words,
                               bool suspect)
{
    m_outcome = outcome;
    m_suspect = suspect;
    m_alert = false;
    setWords(headline, words);
}

void VerdictPanel::showHint(const QString& headline, const QString& words)
{
    m_outcome.reset();
    m_alert = false;
    setWords(headline, words);
}

void VerdictPanel::showAlert(const QString& headline, const QString& words)
{
    m_outcome.reset();
    m_alert = true;
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
    painter.fillPath(frame, m_alert ? t.accent : t.surface);
    const QColor color = m_outcome ? Theme::instance().outcomeColor(*m_outcome, m_suspect)
                         : m_alert ? Theme::onColor(t.accent)
                                   : t.secondText;
    double left = padding;
    if (m_outcome) {
        painter.fillPath(frame, suspect()  ? suspectStripes()
                                : filled() ? QBrush(color)
                                           : outcomeFill(*m_outcome));
        const double size = signSize();
        const QRectF box(padding, (height() - size) / 2, size, size);
        if (!filled() && !suspect())
            painter.fillRect(box, t.surface);
        if (filled())
            paintOutcomeSign(painter, box, *m_outcome, Theme::onColor(color));
        else
            paintJudgedSign(painter, box, *m_outcome, m_suspect);
        left = box.right() + padding;
    }
    painter.setPen(QPen(m_outcome ? color : t.line, m_outcome ? 2 : w));
    painter.setBrush(Qt::NoBrush);
    if (suspect()) {
        painter.save();
        painter.setClipPath(frame);
        painter.setPen(QPen(color, 2 * suspectFrame)); // half of it is outside
        painter.drawPath(frame);
        painter.restore();
    } else {
        painter.drawPath(frame);
    }
    paintWords(painter, left, filled() ? Theme::onColor(color) : color);
    if (m_progress >= 0) {
        painter.setClipPath(frame);
        painter.fillRect(QRectF(0, height() - 6, width() * std::min(m_progress, 1.0), 6), t.accent);
    }
}

bool VerdictPanel::filled() const
{
    return m_outcome && !m_suspect && Theme::instance().tokens().kind != ThemeKind::HighContrast;
}

double VerdictPanel::signSize() const
{
    return std::max(leastSign, std::min(signOfHeight * height(), signOfWidth * width()));
}

VerdictPanel::Headline VerdictPanel::fitted(double room, double tall) const
{
    const int most = readFromAfar() ? largestThatMayFit(m_headline, room, tall)
                                    : metrics::fontNumber; // read by who stands there
    for (int pixels = most; pixels >= metrics::fontNumber; pixels -= 2) {
        const QFontMetricsF font(Theme::font(pixels, true));
        const QStringList two = pixels < leastOneLine ? inTwoLines(m_headline, font, room) : QStringList();
        if (font.horizontalAdvance(m_headline) <= room && lineHeight(font) <= tall)
            return {{m_headline}, pixels};
        if (!two.isEmpty() && 2 * lineHeight(font) <= tall)
            return {two, pixels};
    }
    const QFontMetricsF least(Theme::font(metrics::fontNumber, true));
    return {{elided(least, m_headline, room)}, metrics::fontNumber};
}

QFont VerdictPanel::wordsFont(double room) const
{
    const bool strong = readFromAfar();
    const int most = std::max(suspect() ? metrics::fontNumber : metrics::fontTitle,
                              strong ? static_cast<int>(wordsOfHeight * height()) : 0);
    for (int pixels = most; pixels > metrics::fontTitle; pixels -= 2)
        if (const QFont font = Theme::font(pixels, strong);
            QFontMetricsF(font).horizontalAdvance(m_words) <= room)
            return font;
    return Theme::font(metrics::fontTitle, strong);
}

VerdictPanel::Words VerdictPanel::fittedWords(double room, double tall) const
{
    const QFont font = wordsFont(room);
    if (readFromAfar() || QFontMetricsF(font).horizontalAdvance(m_words) <= room)
        return {{elided(QFontMetricsF(font), m_words, room)}, font};
    for (const int pixels : {metrics::fontTitle, metrics::fontBase, metrics::fontSmall}) {
        const QFont smaller = Theme::font(pixels);
        const QFontMetricsF measures(smaller);
        const QStringList lines = filledLines(measures, m_words.split(u' '), room);
        if (double(lines.size()) * measures.height() <= tall)
            return {lines, smaller};
    }
    return {{elided(QFontMetricsF(font), m_words, room)}, font};
}

void VerdictPanel::paintWords(QPainter& painter, double left, const QColor& color) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    const double room = width() - left - padding;
    const double leastHeadline = lineHeight(QFontMetricsF(Theme::font(metrics::fontNumber, true)));
    const Words words = fittedWords(room, height() - leastHeadline - 16);
    const QFontMetricsF smallMetrics(words.font);
    const double smallHeight = smallMetrics.height() * double(words.lines.size());
    const Headline headline = fitted(room, height() - smallHeight - 16);
    const QFont large = Theme::font(headline.pixels, true);
    const QFontMetricsF largeMetrics(large);
    const double each = lineHeight(largeMetrics);
    const double largeHeight = each * static_cast<double>(headline.lines.size());
    const double top = (height() - largeHeight - smallHeight) / 2;
    if (m_outcome && (t.kind == ThemeKind::HighContrast || m_suspect)) { // patterns stay behind the words
        double wide = 0;
        for (const QString& line : words.lines)
            wide = std::max(wide, smallMetrics.horizontalAdvance(line));
        for (const QString& line : headline.lines)
            wide = std::max(wide, largeMetrics.horizontalAdvance(line));
        painter.fillRect(QRectF(left - 8, top, wide + 16, largeHeight + smallHeight), t.surface);
    }
    painter.setPen(readFromAfar() ? color : t.text);
    painter.setFont(large);
    double baseline = top + largeMetrics.ascent() * 0.92;
    for (const QString& line : headline.lines) {
        painter.drawText(QPointF(left, baseline), line);
        baseline += each;
    }
    painter.setFont(words.font);
    painter.setPen(readFromAfar() ? color : t.secondText);
    baseline = top + largeHeight + smallMetrics.ascent();
    for (const QString& line : words.lines) {
        painter.drawText(QPointF(left, baseline), line);
        baseline += smallMetrics.height();
    }
}

} // namespace gripscope
