// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/history_report.h"

#include "core/recognition/binomial_evidence.h"
#include "ui/charts/trend_plot.h"
#include "ui/models/calibration_words.h"
#include "ui/models/history_words.h"
#include "ui/reports/pdf_document.h"
#include "ui/widgets/date_text.h"
#include "ui/widgets/number_format.h"
#include "ui/widgets/outcome_view.h"
#include "ui/widgets/parameter_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr QSize pictureSize(680, 470); // logical pixels
constexpr int legendHeight = 24;
constexpr int pictureScale = 3;
constexpr int plots = 3;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(gripscope::HistoryReport)
};

QString dash()
{
    return QString(QChar(0x2013));
}

QString heading(const QString& text)
{
    return u"<h2>%1</h2>"_s.arg(text.toHtmlEscaped());
}

/// Breaks nowhere: a number stays with its unit, a day with its hour.
QString cell(const QString& text, bool number = false)
{
    QString whole = (text.isEmpty() ? dash() : text).toHtmlEscaped();
    return u"<td%1>%2&nbsp;&nbsp;</td>"_s.arg(number ? u" align='right'"_s : QString(),
                                              whole.replace(u' ', QChar::Nbsp));
}

QString headerRow(const QStringList& names, int firstNumber, int lastNumber)
{
    QString html = u"<tr>"_s;
    for (int i = 0; i < names.size(); ++i)
        html += u"<th align='%1'>%2&nbsp;&nbsp;</th>"_s.arg(
            i >= firstNumber && i <= lastNumber ? u"right"_s : u"left"_s, names[i].toHtmlEscaped());
    return html + u"</tr>"_s;
}

/// "402 of 411 (97.8 %); with 95 % confidence each at least 96.1 % and at most 98.9 %".
QString shareText(qint64 count, qint64 of)
{
    const BinomialEvidence evidence = binomialEvidence(count, of);
    return Words::tr("%1 of %2 (%3); with 95 % confidence each at least %4, at most %5")
        .arg(formatCount(count), formatCount(of), formatPercent(100.0 * double(count) / double(of)),
             formatPercent(100 * evidence.lowest), formatPercent(100 * evidence.highest));
}

QString countsTable(const HistoryCounts& counts)
{
    QString html = u"<table>"_s;
    html += pdfRow(Words::tr("Inspected"), formatCount(counts.inspections));
    if (counts.judged() > 0) {
        html += pdfRow(Words::tr("As expected"), shareText(counts.asExpected, counts.judged()));
        html += pdfRow(Words::tr("Other type"), shareText(counts.otherType, counts.judged()));
        html += pdfRow(Words::tr("Unknown"), shareText(counts.unknown, counts.judged()));
        html += pdfRow(Words::tr("Inconclusive"), shareText(counts.inconclusive, counts.judged()));
    }
    html += pdfRow(Words::tr("Measurement not valid"), formatCount(counts.notValid));
    html += pdfRow(Words::tr("Enrolled"), formatCount(counts.enrolled));
    return html + u"</table>"_s;
}

QString filterTable(const HistoryReport& report)
{
    QString html = u"<table>"_s;
    for (const Fact& fact : HistoryWords::filter(report.query))
        html += pdfRow(fact.name, fact.text);
    if (html == u"<table>"_s)
        html += pdfRow(Words::tr("Squeezes"), Words::tr("all"));
    const auto& points = report.points.points;
    if (!points.empty()) {
        const auto time = [](qint64 ms) { return timeText(QDateTime::fromMSecsSinceEpoch(ms)); };
        html += pdfRow(Words::tr("From, to"),
                       u"%1 – %2"_s.arg(time(points.front().time_ms), time(points.back().time_ms)));
    }
    return html + u"</table>"_s;
}

QString operatorsText(const HistoryPoints& points)
{
    QStringList names;
    for (auto i = points.operators.cbegin(); i != points.operators.cend(); ++i)
        names << u"%1 (%2)"_s.arg(i.key().isEmpty() ? Words::tr("not named") : i.key(),
                                  formatCount(i.value()));
    return names.join(u", "_s);
}

QString calibrationText(const std::optional<CalibrationRecord>& record)
{
    if (!record)
        return Words::tr("not calibrated here: its own scale is taken");
    return Words::tr("taken %1 by %2 against %3, holds until %4")
        .arg(dateText(record->takenUtc), record->operatorName, record->reference.name, dateText(record->due));
}

QString grippersTable(const HistoryReport& report)
{
    QString html = u"<table>"_s + pdfRow(Words::tr("Operators"), operatorsText(report.points));
    for (auto i = report.points.serials.cbegin(); i != report.points.serials.cend(); ++i) {
        const QString name = i.key().isEmpty() ? Words::tr("not known")
                                               : report.points.devices.value(i.key()) + u' ' + i.key();
        html += pdfRow(Words::tr("Gripper"), u"%1 (%2)"_s.arg(name, formatCount(i.value())));
        const auto found = report.calibrations.find(i.key());
        if (found == report.calibrations.end())
            continue;
        html += pdfRow(Words::tr("Force, in force now"), calibrationText(found->second.force));
        html += pdfRow(Words::tr("Position, in force now"), calibrationText(found->second.position));
    }
    return html + u"</table>"_s;
}

QString typesTable(const TrendContent& content)
{
    if (content.bands.empty())
        return {};
    QString html =
        u"<h2 style='page-break-before: always'>%1</h2>"_s.arg(
            Words::tr("Types as they are enrolled").toHtmlEscaped()) +
        u"<table class='small' width='100%' cellspacing='0' cellpadding='2'>"_s +
        headerRow({Words::tr("Type"), Words::tr("m"), Words::tr("95 % of squeezes"), Words::tr("b"),
                   Words::tr("95 % of squeezes"), Words::tr("k"), Words::tr("95 % of squeezes")},
                  1, 6);
    const ParameterUnits units = parameterUnits(u"N"_s, u"m"_s);
    const QString unit[] = {units.m, units.b, units.k};
    for (const TrendBand& band : content.bands) {
        html += u"<tr>"_s + cell(band.type);
        for (std::size_t i = 0; i < band.intervals.size(); ++i) {
            const TypeInterval& interval = band.intervals[i];
            const ShownUnit shown = shownUnit(unit[i], interval.mean);
            const auto number = [&shown](double value) {
                return QLocale().toString(value * shown.factor, 'g', 4);
            };
            html += cell(number(interval.mean) + QChar::Nbsp + shown.unit, true);
            html += cell(number(interval.low) + u" – "_s + number(interval.high), true);
        }
        html += u"</tr>"_s;
    }
    return html + u"</table>"_s;
}

QString rowsTable(const HistoryReport& report)
{
    QString html = u"<table class='small' width='100%' cellspacing='0' cellpadding='1'><thead>"_s +
                   headerRow({Words::tr("No."), Words::tr("Time"), Words::tr("Outcome"), Words::tr("Type"),
                              Words::tr("m"), Words::tr("b"), Words::tr("k"), Words::tr("Operator"),
                              Words::tr("Gripper"), Words::tr("Software")},
                             4, 6) +
                   u"</thead>"_s;
    for (const HistoryEntry& entry : report.rows) {
        const auto outcome = entry.outcome();
        ParameterTexts texts;
        if (entry.parameters)
            texts =
                parameterTexts(*entry.parameters, entry.standardErrors, entry.forceUnit, entry.positionUnit);
        html += u"<tr>"_s + cell(entry.number > 0 ? QString::number(entry.number) : QString()) +
                cell(timeText(entry.time)) +
                cell(outcome ? outcomeWord(*outcome) : HistoryWords::kind(entry.kind)) + cell(entry.type) +
                cell(entry.parameters ? texts.m.text() : QString(), true) +
                cell(entry.parameters ? texts.b.text() : QString(), true) +
                cell(entry.parameters ? texts.k.text() : QString(), true) + cell(entry.operatorName) +
                cell(HistoryWords::device(entry)) + cell(entry.program) + u"</tr>"_s;
    }
    return html + u"</table>"_s;
}

QImage picture(const TrendContent& content)
{
    QImage image(pictureSize * pictureScale, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(pictureScale, pictureScale);
    const ThemeTokens tokens = themeTokens(ThemeKind::Light);
    painter.setRenderHint(QPainter::Antialiasing);
    paintTypeLegend(painter, content, QRectF(0, 0, pictureSize.width(), legendHeight), tokens);
    const double each = double(pictureSize.height() - legendHeight - 18) / plots;
    for (int i = 0; i < plots; ++i)
        TrendPlot(content, i,
                  QRectF(0, legendHeight + i * each, pictureSize.width(), each + (i == plots - 1 ? 18 : 0)),
                  i == plots - 1)
            .paint(painter, tokens);
    return image;
}

TrendContent contentOf(const HistoryReport& report)
{
    return trendContent(std::make_shared<HistoryPoints>(report.points), report.models, true);
}

} // namespace

Expected<HistoryReport> readHistoryReport(Library& library, const HistoryQuery& query)
{
    HistoryReport report;
    report.query = query;
    report.library = library.file();
    const auto keys = library.historyKeys(query);
    if (!keys)
        return tl::unexpected<Error>(keys.error());
    report.total = keys->size();
    auto rows = library.historyEntries(keys->part(0, mostReportRows));
    if (!rows)
        return tl::unexpected<Error>(rows.error());
    report.rows = std::move(*rows);
    const auto counts = library.historyCounts(query);
    if (!counts)
        return tl::unexpected<Error>(counts.error());
    report.counts = *counts;
    auto points = library.historyPoints(query);
    if (!points)
        return tl::unexpected<Error>(points.error());
    report.points = std::move(*points);
    for (auto i = report.points.serials.cbegin(); i != report.points.serials.cend(); ++i) {
        if (i.key().isEmpty())
            continue;
        auto inForce = library.calibrationsInForce(i.key());
        if (!inForce)
            return tl::unexpected<Error>(inForce.error());
        report.calibrations[i.key()] = std::move(*inForce);
    }
    return report;
}

QString historyReportHtml(const HistoryReport& report)
{
    const TrendContent content = contentOf(report);
    QString html = u"<h1>%1</h1>"_s.arg(Words::tr("Report of squeezes").toHtmlEscaped()) +
                   filterTable(report) + heading(Words::tr("Counts")) + countsTable(report.counts) +
                   heading(Words::tr("Who and with what")) + grippersTable(report);
    html += u"<p>%1</p>"_s.arg(
        Words::tr(
            "Made %1 by %2 with Gripscope %3 from %4. Each squeeze keeps the version it was identified with.")
            .arg(timeText(report.made),
                 report.operatorName.isEmpty() ? Words::tr("somebody not named") : report.operatorName,
                 QStringLiteral(GRIPSCOPE_VERSION), report.library)
            .toHtmlEscaped());
    if (!report.points.points.empty())
        html += heading(Words::tr("m, b and k over time")) + pdfPicture(u"trend"_s, pictureSize);
    html += typesTable(content) + heading(Words::tr("Squeezes"));
    if (report.total > report.rows.size())
        html += u"<p>%1</p>"_s.arg(
            Words::tr("The first %1 of %2; an export as CSV or JSON holds all.")
                .arg(formatCount(qint64(report.rows.size())), formatCount(qint64(report.total)))
                .toHtmlEscaped());
    return html + rowsTable(report);
}

Expected<void> writeHistoryReport(const HistoryReport& report, const QString& file)
{
    return writePdf(Words::tr("Report of squeezes"), historyReportHtml(report),
                    {{u"trend"_s, picture(contentOf(report))}}, file);
}

} // namespace gripscope
