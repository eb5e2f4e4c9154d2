// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/outcome_view.h"

#include "core/words.h"
#include "ui/theme/theme.h"
#include "ui/widgets/number_format.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

struct OutcomeWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::Outcome)
};

/// The two types with the largest posterior.
QStringList likeliest(const QMap<QString, double>& posterior)
{
    QStringList names = posterior.keys();
    std::stable_sort(names.begin(), names.end(), [&posterior](const QString& a, const QString& b) {
        return posterior[a] > posterior[b];
    });
    return names.mid(0, 2);
}

} // namespace

QString outcomeWord(InspectionOutcome outcome)
{
    switch (outcome) {
    case InspectionOutcome::AsExpected:
        return OutcomeWords::tr("as expected");
    case InspectionOutcome::OtherType:
        return OutcomeWords::tr("other type");
    case InspectionOutcome::Unknown:
        return OutcomeWords::tr("unknown");
    case InspectionOutcome::Inconclusive:
        return OutcomeWords::tr("inconclusive");
    case InspectionOutcome::NotValid:
        return OutcomeWords::tr("not valid");
    }
    return {};
}

namespace {

/// Which two types it may be, and how long to squeeze to know.
QString betweenTypes(const InspectSession::Result& result)
{
    const Verdict& verdict = result.verdict;
    QString first = verdict.nearest, second = verdict.rival;
    if (verdict.posterior.value(first) < verdict.posterior.value(second))
        first.swap(second);
    const QString either = OutcomeWords::tr("It could be %1 (%2) or %3 (%4)")
                               .arg(first, formatProbability(verdict.posterior.value(first)), second,
                                    formatProbability(verdict.posterior.value(second)));
    const std::optional<CorrectedParameters> object = result.identification.object();
    const bool lengthTells = verdict.timesLonger || (object && !object->covariance.isZero(0));
    if (lengthTells && !verdict.timesLonger)
        return OutcomeWords::tr("%1, and a longer squeeze would not tell them apart.").arg(either);
    if (!lengthTells || *verdict.timesLonger < 1.05)
        return OutcomeWords::tr("%1: squeeze it again.").arg(either);
    return OutcomeWords::tr("%1: squeezed for %2 s, nine of ten would be told apart.")
        .arg(either, Words::number(result.seconds * *verdict.timesLonger, 'g', 2));
}

QString reasonOf(const InspectSession::Result& result)
{
    const Verdict& verdict = result.verdict;
    if (result.outcome == InspectionOutcome::NotValid)
        return verdict.reasons.join(u' ');
    const bool contradicted = result.earlyEnd && verdict.kind == VerdictKind::Inconclusive;
    if (result.outcome == InspectionOutcome::Inconclusive && !verdict.rival.isEmpty() && !contradicted)
        return betweenTypes(result);
    return verdict.reasons.value(0);
}

VerdictWords headlineOf(const InspectSession::Result& result)
{
    const Verdict& verdict = result.verdict;
    switch (result.outcome) {
    case InspectionOutcome::AsExpected:
        return {verdict.type,
                result.expectedType.isEmpty() ? OutcomeWords::tr("known type, none was expected")
                                              : outcomeWord(result.outcome),
                {}};
    case InspectionOutcome::OtherType:
        return {verdict.type, OutcomeWords::tr("other type; expected %1").arg(result.expectedType), {}};
    case InspectionOutcome::Unknown:
        return {OutcomeWords::tr("Unknown"),
                verdict.nearest.isEmpty() ? OutcomeWords::tr("no type is enrolled yet")
                                          : OutcomeWords::tr("none of the enrolled types"),
                {}};
    case InspectionOutcome::Inconclusive: {
        const QStringList two = likeliest(verdict.posterior);
        return {two.size() == 2 ? OutcomeWords::tr("%1 or %2?").arg(two[0], two[1])
                                : OutcomeWords::tr("Open"),
                outcomeWord(result.outcome),
                {}};
    }
    case InspectionOutcome::NotValid:
        return {OutcomeWords::tr("Squeeze again"),
                OutcomeWords::tr("measurement not valid; part not judged"),
                {}};
    }
    return {};
}

} // namespace

VerdictWords verdictWords(const InspectSession::Result& result)
{
    VerdictWords words = headlineOf(result);
    words.reason = reasonOf(result);
    return words;
}

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
    }
    painter.restore();
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
    }
    return tokens.surface;
}

} // namespace gripscope
