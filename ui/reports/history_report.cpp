// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/records/history_list.h"
#include "core/math/binomial_evidence.h"
#include "ui/charts/trend_figure.h"
#include "ui/charts/trend_plot.h"
#include "ui/format/date_text.h"
#include "ui/format/history_words.h"
#include "ui/format/number_format.h"
#include "ui/format/parameter_text.h"
#include "ui/format/yield_text.h"
#include "ui/reports/pdf_document.h"
#include "ui/reports/reports.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr QSize trendPlotsSize(680, 446); // logical pixels, without the legend
constexpr int pictureScale = 3;

struct HistoryReportWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::HistoryReport)
};

QString enDash()
{
    return QString(QChar(0x2013));
}

/// Breaks nowhere: a number stays with its unit, a day with its hour (see layOutPdf()).
QString cell(const QString& text, bool number = false)
{
    const QString whole = (text.isEmpty() ? enDash() : text).toHtmlEscaped();
    return u"<td%1>%2&nbsp;&nbsp;</td>"_s.arg(number ? u" align='right'"_s : QString(),
                                              QString(whole).replace(u' ', QChar::Nbsp));
}

/// Wraps between words, and within one that is as long as no word is.
QString wordsCell(const QString& text)
{
    constexpr qsizetype longest = 20;
    QString wrapped;
    qsizetype letters = 0;
    for (const QChar letter : text.isEmpty() ? enDash() : text) {
        letters = letter.isSpace() ? 0 : letters + 1;
        if (letters > longest && !letter.isLowSurrogate()) {
            wrapped += QChar(0x200B); // a place to break that is not seen
            letters = 1;
        }
        wrapped += letter;
    }
    return u"<td>%1</td>"_s.arg(wrapped.toHtmlEscaped());
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
    if (const Yield yield = yieldOf(counts); yield.judged > 0) {
        html += pdfRow(HistoryReportWords::tr("Yield"), yieldText(yield));
        if (yield.unasked < yield.judged)
            html += pdfRow(HistoryReportWords::tr("As expected"),
                           shareText(counts.asExpected - counts.knownType, yield.judged));
        if (yield.unasked > 0)
            html += pdfRow(HistoryReportWords::tr("Known type, none expected"),
                           shareText(counts.knownType, yield.judged));
        html += pdfRow(HistoryReportWords::tr("Other type"), shareText(counts.otherType, yield.judged));
        if (counts.doesNotConform > 0)
            html += pdfRow(HistoryReportWords::tr("Does not conform to its limits"),
                           shareText(counts.doesNotConform, yield.judged));
        html += pdfRow(HistoryReportWords::tr("Unknown"), shareText(counts.unknown, yield.judged));
    }
    html += pdfRow(HistoryReportWords::tr("Inconclusive, not judged"), formatCount(counts.inconclusive));
    html += pdfRow(HistoryReportWords::tr("Measurement not valid, not judged"), formatCount(counts.notValid));
    if (counts.voided > 0)
        html +=
            pdfRow(HistoryReportWords::tr("Voided, counted in none of these"), formatCount(counts.voided));
    html += pdfRow(HistoryReportWords::tr("Measurement suspect"), formatCount(counts.suspect));
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
        const auto time = [](qint64 ms) { return zonedTimeText(QDateTime::fromMSecsSinceEpoch(ms)); };
        html += pdfRow(HistoryReportWords::tr("From, to"),
                       u"%1 – %2"_s.arg(time(points.front().time_ms), time(points.back().time_ms)));
    }
    return html + u"</table>"_s;
}

QString operatorsText(const HistoryInForce& inForce)
{
    QStringList names;
    for (auto i = inForce.operators.cbegin(); i != inForce.operators.cend(); ++i)
        names << u"%1 (%2)"_s.arg(i.key().isEmpty() ? HistoryReportWords::tr("not named") : i.key(),
                                  formatCount(i.value()));
    return names.join(u", "_s);
}

/// Each with the number of its squeezes.
QString calibrationsThen(const std::map<std::optional<QString>, qint64>& calibrations)
{
    QStringList texts;
    for (const auto& [words, count] : calibrations)
        texts << u"%1 (%2)"_s.arg(HistoryWords::calibration(words), formatCount(count));
    return texts.join(u"; "_s);
}

/// What the verdicts were held to, which types they were judged by, and by which program.
QString judgedByTable(const HistoryInForce& inForce)
{
    QString html = u"<table>"_s;
    for (const HistoryInForce::Rates& rates : inForce.rates)
        html += pdfRow(HistoryReportWords::tr("Rates then"),
                       u"%1 (%2)"_s.arg(HistoryWords::heldTo(rates.heldTo), formatCount(rates.inspections)));
    QStringList versions;
    if (inForce.firstVersion && inForce.lastVersion)
        versions << (*inForce.firstVersion == *inForce.lastVersion
                         ? HistoryReportWords::tr("version %1 of the library").arg(*inForce.firstVersion)
                         : HistoryReportWords::tr("versions %1 to %2 of the library")
                               .arg(*inForce.firstVersion)
                               .arg(*inForce.lastVersion));
    if (inForce.withoutVersion > 0)
        versions << u"%1 (%2)"_s.arg(HistoryWords::notRecorded(), formatCount(inForce.withoutVersion));
    if (!versions.isEmpty())
        html += pdfRow(HistoryReportWords::tr("Types then"), versions.join(u"; "_s));
    QStringList programs;
    for (const auto& [program, count] : inForce.programs)
        programs << u"%1 (%2)"_s.arg(program.isEmpty() ? HistoryWords::notRecorded() : program,
                                     formatCount(count));
    if (!programs.isEmpty())
        html += pdfRow(HistoryReportWords::tr("Judged by Gripscope"), programs.join(u", "_s));
    return html + u"</table>"_s;
}

QString grippersTable(const HistoryReport& report)
{
    QString html = u"<table>"_s + pdfRow(HistoryReportWords::tr("Operators"), operatorsText(report.inForce));
    for (auto i = report.inForce.serials.cbegin(); i != report.inForce.serials.cend(); ++i) {
        const QString name = i.key().isEmpty() ? HistoryReportWords::tr("not known")
                                               : report.inForce.devices.value(i.key()) + u' ' + i.key();
        html += pdfRow(HistoryReportWords::tr("Gripper"), u"%1 (%2)"_s.arg(name, formatCount(i.value())));
        const auto found = report.inForce.calibrations.find(i.key());
        if (i.key().isEmpty() || found == report.inForce.calibrations.end())
            continue;
        html +=
            pdfRow(HistoryReportWords::tr("Force, calibration then"), calibrationsThen(found->second.force));
        html += pdfRow(HistoryReportWords::tr("Position, calibration then"),
                       calibrationsThen(found->second.position));
    }
    return html + u"</table>"_s;
}

QString typesTable(const TrendContent& content)
{
    if (content.bands.empty())
        return {};
    QString html = pdfHeading(HistoryReportWords::tr("Types as they are enrolled")) +
                   u"<table class='small' width='100%' cellspacing='0' cellpadding='2'><thead>"_s +
                   headerRow({HistoryReportWords::tr("Type"), HistoryReportWords::tr("m"),
                              HistoryReportWords::tr("95 % of squeezes"), HistoryReportWords::tr("b"),
                              HistoryReportWords::tr("95 % of squeezes"), HistoryReportWords::tr("k"),
                              HistoryReportWords::tr("95 % of squeezes")},
                             1, 6) +
                   u"</thead>"_s;
    const ParameterUnits units = siParameterUnits();
    const QString unit[] = {units.m, units.b, units.k};
    for (const TrendBand& band : content.bands) {
        html += u"<tr>"_s + wordsCell(band.type);
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

/// With why it was voided.
QString outcomeText(const HistoryEntry& entry)
{
    const QString outcome = HistoryWords::outcome(entry);
    return entry.voided.isEmpty() ? outcome : u"%1 (%2)"_s.arg(outcome, entry.voided);
}

/// A column that stands only where some row has something to say.
bool anyHas(const std::vector<HistoryEntry>& rows, QString HistoryEntry::*text)
{
    return std::any_of(rows.begin(), rows.end(),
                       [text](const HistoryEntry& entry) { return !(entry.*text).isEmpty(); });
}

QString rowsTable(const HistoryReport& report)
{
    const bool batches = anyHas(report.rows, &HistoryEntry::batch);
    const bool partNumbers = anyHas(report.rows, &HistoryEntry::partNumber);
    QStringList names{HistoryReportWords::tr("No."), HistoryReportWords::tr("Time")};
    if (batches)
        names << HistoryReportWords::tr("Batch");
    if (partNumbers)
        names << HistoryReportWords::tr("Part number");
    names << HistoryReportWords::tr("Outcome") << HistoryReportWords::tr("Type");
    const auto firstNumber = int(names.size());
    names << HistoryReportWords::tr("m") << HistoryReportWords::tr("b") << HistoryReportWords::tr("k")
          << HistoryReportWords::tr("Operator") << HistoryReportWords::tr("Gripper")
          << HistoryReportWords::tr("Software");
    QString html = u"<table class='small' width='100%' cellspacing='0' cellpadding='2'><thead>"_s +
                   headerRow(names, firstNumber, firstNumber + 2) + u"</thead>"_s;
    for (const HistoryEntry& entry : report.rows) {
        ParameterTexts texts;
        if (entry.parameters)
            texts =
                parameterTexts(*entry.parameters, entry.standardErrors, entry.forceUnit, entry.positionUnit);
        html += u"<tr>"_s + cell(entry.number > 0 ? QString::number(entry.number) : QString()) +
                cell(timeText(entry.time)) + (batches ? wordsCell(entry.batch) : QString()) +
                (partNumbers ? wordsCell(entry.partNumber) : QString()) + wordsCell(outcomeText(entry)) +
                wordsCell(entry.type) + cell(entry.parameters ? texts.m.text() : QString(), true) +
                cell(entry.parameters ? texts.b.text() : QString(), true) +
                cell(entry.parameters ? texts.k.text() : QString(), true) + wordsCell(entry.operatorName) +
                wordsCell(HistoryWords::device(entry)) + cell(entry.program) + u"</tr>"_s;
    }
    return html + u"</table>"_s;
}

QSize chartsSize(const TrendContent& content)
{
    return trendPlotsSize + QSize(0, typeLegendHeight(content, trendPlotsSize.width()));
}

QImage chartsPicture(const TrendContent& content)
{
    const QSize size = chartsSize(content);
    QImage image(size * pictureScale, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(pictureScale, pictureScale);
    paintTrendFigure(painter, content, size, themeTokens(ThemeKind::Light));
    return image;
}

TrendContent contentOf(const HistoryReport& report)
{
    return trendContent(std::make_shared<HistoryPoints>(report.points), report.models, true,
                        gateIntervals(report.models, report.rates));
}

QString reportTitle(const HistoryReport& report)
{
    return report.number > 0 ? HistoryReportWords::tr("Report of squeezes no. %1").arg(report.number)
                             : HistoryReportWords::tr("Report of squeezes");
}

QString reportParagraph(const QString& words)
{
    return u"<p>%1</p>"_s.arg(words.toHtmlEscaped());
}

QString chartsPart(const HistoryReport& report, const TrendContent& content)
{
    if (report.points.points.empty())
        return {};
    QString html = pdfHeading(HistoryReportWords::tr("m, b and k over time")) +
                   pdfPicture(u"trend"_s, chartsSize(content));
    if (content.gated())
        html += reportParagraph(trendGateNote());
    if (report.points.oneIn > 1)
        html += reportParagraph(HistoryReportWords::tr("One inspection in %1 is drawn, by its number.")
                                    .arg(formatCount(report.points.oneIn)));
    return html;
}

} // namespace

Expected<HistoryReport> readHistoryReport(Library& library, const HistoryQuery& query)
{
    HistoryReport report;
    report.query = query;
    report.library = library.file();
    ASSIGN_OR_RETURN(HistoryList list, library.historyList(query));
    while (!list.through) {
        ASSIGN_OR_RETURN(list, library.historyStretch(std::move(list)));
    }
    report.total = std::size_t(list.counts.total());
    ASSIGN_OR_RETURN(auto rows, library.historyPage(list, 0, qint64(mostReportRows)));
    report.rows = std::move(rows);
    report.counts = list.counts;
    ASSIGN_OR_RETURN(auto points, library.historyPoints(list));
    report.points = std::move(points);
    ASSIGN_OR_RETURN(auto inForce, library.historyInForce(query));
    report.inForce = std::move(inForce);
    return report;
}

Expected<void> numberHistoryReport(Library& library, HistoryReport& report, const QString& file)
{
    return library.atOnce([&]() -> Expected<void> { // nobody else's entry comes between
        RETURN_IF_ERROR(library.tellExport(file, u"pdf"_s, qint64(report.total)));
        AuditFilter newest;
        newest.action = QString::fromUtf16(audit_action::exported);
        newest.limit = 1;
        ASSIGN_OR_RETURN(const std::vector<AuditEntry> entries, library.auditTrail().entries(newest));
        report.number = entries.front().number;
        return {};
    });
}

QString historyReportHtml(const HistoryReport& report, const Letterhead& letterhead)
{
    const TrendContent content = contentOf(report);
    QString html = letterheadHtml(letterhead) + u"<h1>%1</h1>"_s.arg(reportTitle(report).toHtmlEscaped()) +
                   filterTable(report) + pdfHeading(HistoryReportWords::tr("Counts")) +
                   countsTable(report.counts) + pdfHeading(HistoryReportWords::tr("Who and with what")) +
                   grippersTable(report) + judgedByTable(report.inForce);
    html += reportParagraph(
        HistoryReportWords::tr(
            "Made %1 by %2 with Gripscope %3 from %4. Each squeeze keeps the version it was identified with.")
            .arg(zonedTimeText(report.made),
                 report.operatorName.isEmpty() ? HistoryReportWords::tr("somebody not named")
                                               : report.operatorName,
                 QStringLiteral(GRIPSCOPE_VERSION), report.library));
    if (report.number > 0)
        html +=
            reportParagraph(HistoryReportWords::tr("Its number is that of its entry in the audit trail."));
    html +=
        chartsPart(report, content) + typesTable(content) + pdfHeading(HistoryReportWords::tr("Squeezes"));
    if (report.total > report.rows.size())
        html += reportParagraph(
            HistoryReportWords::tr("The first %1 of %2; an export as CSV or JSON holds all.")
                .arg(formatCount(qint64(report.rows.size())), formatCount(qint64(report.total))));
    return html + rowsTable(report);
}

Expected<void> writeHistoryReport(const HistoryReport& report, const QString& file,
                                  const std::shared_ptr<WorkWatch>& watch)
{
    ASSIGN_OR_RETURN(const Letterhead letterhead, readLetterhead(report.letterhead));
    std::vector<PdfPicture> pictures = letterheadPictures(letterhead);
    pictures.push_back({u"trend"_s, chartsPicture(contentOf(report))});
    return writePdf(reportTitle(report), historyReportHtml(report, letterhead), pictures, file, watch);
}

} // namespace gripscope
