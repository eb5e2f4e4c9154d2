// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/binomial_evidence.h"
#include "ui/charts/trend_plot.h"
#include "ui/format/calibration_words.h"
#include "ui/format/date_text.h"
#include "ui/format/history_words.h"
#include "ui/format/number_format.h"
#include "ui/format/outcome_words.h"
#include "ui/format/parameter_text.h"
#include "ui/reports/pdf_document.h"
#include "ui/reports/reports.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr QSize trendPictureSize(680, 470); // logical pixels
constexpr int legendHeight = 24;
constexpr int pictureScale = 3;
constexpr int trendPlots = 3;

struct HistoryReportWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::HistoryReport)
};

QString enDash()
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
    QString whole = (text.isEmpty() ? enDash() : text).toHtmlEscaped();
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
    return HistoryReportWords::tr("%1 of %2 (%3); with 95 % confidence each at least %4, at most %5")
        .arg(formatCount(count), formatCount(of), formatPercent(100.0 * double(count) / double(of)),
             formatPercent(100 * evidence.lowest), formatPercent(100 * evidence.highest));
}

QString countsTable(const HistoryCounts& counts)
{
    QString html = u"<table>"_s;
    html += pdfRow(HistoryReportWords::tr("Inspected"), formatCount(counts.inspections));
    if (counts.judged() > 0) {
        html += pdfRow(HistoryReportWords::tr("As expected"), shareText(counts.asExpected, counts.judged()));
        html += pdfRow(HistoryReportWords::tr("Other type"), shareText(counts.otherType, counts.judged()));
        html += pdfRow(HistoryReportWords::tr("Unknown"), shareText(counts.unknown, counts.judged()));
        html +=
            pdfRow(HistoryReportWords::tr("Inconclusive"), shareText(counts.inconclusive, counts.judged()));
    }
    html += pdfRow(HistoryReportWords::tr("Measurement not valid"), formatCount(counts.notValid));
    html += pdfRow(HistoryReportWords::tr("Enrolled"), formatCount(counts.enrolled));
    return html + u"</table>"_s;
}

QString filterTable(const HistoryReport& report)
{
    QString html = u"<table>"_s;
    for (const Fact& fact : HistoryWords::filter(report.query))
        html += pdfRow(fact.name, fact.text);
    if (html == u"<table>"_s)
        html += pdfRow(HistoryReportWords::tr("Squeezes"), HistoryReportWords::tr("all"));
    const auto& points = report.points.points;
    if (!points.empty()) {
        const auto time = [](qint64 ms) { return timeText(QDateTime::fromMSecsSinceEpoch(ms)); };
        html += pdfRow(HistoryReportWords::tr("From, to"),
                       u"%1 – %2"_s.arg(time(points.front().time_ms), time(points.back().time_ms)));
    }
    return html + u"</table>"_s;
}

QString operatorsText(const HistoryPoints& points)
{
    QStringList names;
    for (auto i = points.operators.cbegin(); i != points.operators.cend(); ++i)
        names << u"%1 (%2)"_s.arg(i.key().isEmpty() ? HistoryReportWords::tr("not named") : i.key(),
                                  formatCount(i.value()));
    return names.join(u", "_s);
}

QString calibrationText(const std::optional<CalibrationRecord>& record)
{
    if (!record)
        return HistoryReportWords::tr("not calibrated here: its own scale is taken");
    return HistoryReportWords::tr("taken %1 by %2 against %3, holds until %4")
        .arg(dateText(record->takenUtc), record->operatorName, record->reference.name, dateText(record->due));
}

QString grippersTable(const HistoryReport& report)
{
    QString html = u"<table>"_s + pdfRow(HistoryReportWords::tr("Operators"), operatorsText(report.points));
    for (auto i = report.points.serials.cbegin(); i != report.points.serials.cend(); ++i) {
        const QString name = i.key().isEmpty() ? HistoryReportWords::tr("not known")
                                               : report.points.devices.value(i.key()) + u' ' + i.key();
        html += pdfRow(HistoryReportWords::tr("Gripper"), u"%1 (%2)"_s.arg(name, formatCount(i.value())));
        const auto found = report.calibrations.find(i.key());
        if (found == report.calibrations.end())
            continue;
        html += pdfRow(HistoryReportWords::tr("Force, in force now"), calibrationText(found->second.force));
        html +=
            pdfRow(HistoryReportWords::tr("Position, in force now"), calibrationText(found->second.position));
    }
    return html + u"</table>"_s;
}

QString typesTable(const TrendContent& content)
{
    if (content.bands.empty())
        return {};
    QString html = u"<h2 style='page-break-before: always'>%1</h2>"_s.arg(
                       HistoryReportWords::tr("Types as they are enrolled").toHtmlEscaped()) +
                   u"<table class='small' width='100%' cellspacing='0' cellpadding='2'>"_s +
                   headerRow({HistoryReportWords::tr("Type"), HistoryReportWords::tr("m"),
                              HistoryReportWords::tr("95 % of squeezes"), HistoryReportWords::tr("b"),
                              HistoryReportWords::tr("95 % of squeezes"), HistoryReportWords::tr("k"),
                              HistoryReportWords::tr("95 % of squeezes")},
                             1, 6);
    const ParameterUnits units = siParameterUnits();
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
                   headerRow({HistoryReportWords::tr("No."), HistoryReportWords::tr("Time"),
                              HistoryReportWords::tr("Outcome"), HistoryReportWords::tr("Type"),
                              HistoryReportWords::tr("m"), HistoryReportWords::tr("b"),
                              HistoryReportWords::tr("k"), HistoryReportWords::tr("Operator"),
                              HistoryReportWords::tr("Gripper"), HistoryReportWords::tr("Software")},
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
    QImage image(trendPictureSize * pictureScale, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(pictureScale, pictureScale);
    const ThemeTokens tokens = themeTokens(ThemeKind::Light);
    painter.setRenderHint(QPainter::Antialiasing);
    paintTypeLegend(painter, content, QRectF(0, 0, trendPictureSize.width(), legendHeight), tokens);
    const double each = double(trendPictureSize.height() - legendHeight - 18) / trendPlots;
    for (int i = 0; i < trendPlots; ++i)
        TrendPlot(content, i,
                  QRectF(0, legendHeight + i * each, trendPictureSize.width(),
                         each + (i == trendPlots - 1 ? 18 : 0)),
                  i == trendPlots - 1)
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
    ASSIGN_OR_RETURN(const auto keys, library.historyKeys(query));
    report.total = keys.size();
    ASSIGN_OR_RETURN(auto rows, library.historyEntries(keys.part(0, mostReportRows)));
    report.rows = std::move(rows);
    ASSIGN_OR_RETURN(const auto counts, library.historyCounts(query));
    report.counts = counts;
    ASSIGN_OR_RETURN(auto points, library.historyPoints(query));
    report.points = std::move(points);
    for (auto i = report.points.serials.cbegin(); i != report.points.serials.cend(); ++i) {
        if (i.key().isEmpty())
            continue;
        ASSIGN_OR_RETURN(auto inForce, library.calibrationsInForce(i.key()));
        report.calibrations[i.key()] = std::move(inForce);
    }
    return report;
}

QString historyReportHtml(const HistoryReport& report)
{
    const TrendContent content = contentOf(report);
    QString html = u"<h1>%1</h1>"_s.arg(HistoryReportWords::tr("Report of squeezes").toHtmlEscaped()) +
                   filterTable(report) + heading(HistoryReportWords::tr("Counts")) +
                   countsTable(report.counts) + heading(HistoryReportWords::tr("Who and with what")) +
                   grippersTable(report);
    html += u"<p>%1</p>"_s.arg(
        HistoryReportWords::tr(
            "Made %1 by %2 with Gripscope %3 from %4. Each squeeze keeps the version it was identified with.")
            .arg(timeText(report.made),
                 report.operatorName.isEmpty() ? HistoryReportWords::tr("somebody not named")
                                               : report.operatorName,
                 QStringLiteral(GRIPSCOPE_VERSION), report.library)
            .toHtmlEscaped());
    if (!report.points.points.empty())
        html += heading(HistoryReportWords::tr("m, b and k over time")) +
                pdfPicture(u"trend"_s, trendPictureSize);
    html += typesTable(content) + heading(HistoryReportWords::tr("Squeezes"));
    if (report.total > report.rows.size())
        html += u"<p>%1</p>"_s.arg(
            HistoryReportWords::tr("The first %1 of %2; an export as CSV or JSON holds all.")
                .arg(formatCount(qint64(report.rows.size())), formatCount(qint64(report.total)))
                .toHtmlEscaped());
    return html + rowsTable(report);
}

Expected<void> writeHistoryReport(const HistoryReport& report, const QString& file)
{
    return writePdf(HistoryReportWords::tr("Report of squeezes"), historyReportHtml(report),
                    {{u"trend"_s, picture(contentOf(report))}}, file);
}

} // namespace gripscope
