// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/process/process_words.h"
#include "ui/charts/control_plot.h"
#include "ui/charts/histogram_plot.h"
#include "ui/format/date_text.h"
#include "ui/format/number_format.h"
#include "ui/format/reference_words.h"
#include "ui/reports/pdf_document.h"
#include "ui/reports/quality_reports.h"

#include <QPainter>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int reportWidth = 860, reportPanel = 190; // logical pixels
constexpr QSize reportHistogram(430, 190);
constexpr int reportScale = 3;

struct ProcessReportWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::ProcessReport)
};

QString processParagraph(const QString& text)
{
    return text.isEmpty() ? QString() : u"<p>%1</p>"_s.arg(text.toHtmlEscaped());
}

QString tableCell(const QString& text)
{
    return u"<td>%1&nbsp;&nbsp;</td>"_s.arg(text.toHtmlEscaped().replace(u' ', QChar::Nbsp));
}

QString wrappedCell(const QString& text)
{
    return u"<td>%1&nbsp;&nbsp;</td>"_s.arg(text.toHtmlEscaped());
}

QString periodText(const ProcessReport& report)
{
    const ProcessRows& rows = report.picture->rows;
    if (rows.empty())
        return u"–"_s;
    const auto time = [&report](std::uint32_t row) {
        return zonedTimeText(QDateTime::fromMSecsSinceEpoch(report.picture->values->times_ms[row]));
    };
    return u"%1 – %2"_s.arg(time(rows.front()), time(rows.back()));
}

QString processFacts(const ProcessReport& report)
{
    QString html = u"<table>"_s;
    html += pdfRow(ProcessReportWords::tr("Type"), report.type);
    html += pdfRow(ProcessReportWords::tr("Inspections"), formatCount(qint64(report.picture->rows.size())));
    html += pdfRow(ProcessReportWords::tr("From, to"), periodText(report));
    if (!report.narrowed.isEmpty())
        html += pdfRow(ProcessReportWords::tr("Only"), report.narrowed);
    html += pdfRow(ProcessReportWords::tr("Chart"), report.chart);
    if (!report.rules.isEmpty())
        html += pdfRow(ProcessReportWords::tr("Rules"), report.rules);
    return html + u"</table>"_s;
}

QSize chartsSize(const ProcessReport& report)
{
    return {reportWidth, reportPanel * std::max(1, int(report.panels.size()))};
}

template <typename Paint>
QImage reportPicture(QSize size, const Paint& paint)
{
    QImage image(size * reportScale, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(reportScale, reportScale);
    paint(painter, QRectF(QPointF(), QSizeF(size)), themeTokens(ThemeKind::Light));
    return image;
}

QString histogramName(std::size_t place)
{
    return u"histogram%1"_s.arg(place);
}

QString signalsHtml(const ProcessReport& report)
{
    QString html = pdfHeading(ProcessReportWords::tr("Signals"));
    if (report.signalCount == 0)
        return html + processParagraph(ProcessReportWords::tr("Steady: no signal."));
    html += processParagraph(ProcessReportWords::tr("Not steady: %1 signals, the newest %2 of them below.")
                                 .arg(formatCount(qint64(report.signalCount)))
                                 .arg(formatCount(qint64(report.found.size()))) +
                             u' ' + chanceSentence(report.pointCount, report.picture->runLengths).describe());
    html += u"<table class='small'><tr>"_s;
    for (const QString& head :
         {ProcessReportWords::tr("Inspection"), ProcessReportWords::tr("Time"), ProcessReportWords::tr("Of"),
          ProcessReportWords::tr("Signal"), ProcessReportWords::tr("Since inspection")})
        html += u"<th align='left'>%1&nbsp;&nbsp;</th>"_s.arg(head.toHtmlEscaped());
    html += u"</tr>"_s;
    for (const ReportedSignal& signal : report.found)
        html += u"<tr>"_s + tableCell(signal.inspection) + tableCell(signal.time) +
                tableCell(signal.quantity) + wrappedCell(signal.what) + tableCell(signal.since) + u"</tr>"_s;
    return html + u"</table>"_s;
}

QString capabilityHtml(const ReportedCapability& one, std::size_t place)
{
    QString html = pdfHeading(
        ProcessReportWords::tr("Capability: %1").arg(ReferenceWords::quantity(one.capability.quantity)));
    html += processParagraph(one.sentences.join(u' '));
    if (!one.lines.empty()) {
        html += u"<table><tr><th></th><th></th><th align='left'>%1</th></tr>"_s.arg(
            ProcessReportWords::tr("95 % interval").toHtmlEscaped());
        for (const auto& line : one.lines)
            html += u"<tr>"_s + tableCell(line[0]) + tableCell(line[1]) + tableCell(line[2]) + u"</tr>"_s;
        html += u"</table>"_s;
    }
    return html + pdfPicture(histogramName(place), reportHistogram);
}

QString reportTitle(const ProcessReport& report)
{
    return ProcessReportWords::tr("Control charts: %1").arg(report.type);
}

} // namespace

QString processReportHtml(const ProcessReport& report, const Letterhead& letterhead)
{
    QString html = letterheadHtml(letterhead) + u"<h1>%1</h1>"_s.arg(reportTitle(report).toHtmlEscaped());
    html += processFacts(report) + processParagraph(report.limits);
    html +=
        processParagraph(runLengthSentence(report.picture->runLengths, report.picture->options).describe());
    html += pdfPicture(u"charts"_s, chartsSize(report)) + signalsHtml(report);
    for (std::size_t i = 0; i < report.capabilities.size(); ++i)
        html += capabilityHtml(report.capabilities[i], i);
    return html + processParagraph(ProcessReportWords::tr("Made %1 by %2 with Gripscope %3.")
                                       .arg(zonedTimeText(report.made),
                                            report.operatorName.isEmpty()
                                                ? ProcessReportWords::tr("somebody not named")
                                                : report.operatorName,
                                            QStringLiteral(GRIPSCOPE_VERSION)));
}

Expected<void> writeProcessReport(const ProcessReport& report, const QString& file)
{
    ASSIGN_OR_RETURN(const Letterhead letterhead, readLetterhead(report.letterhead));
    std::vector<PdfPicture> pictures = letterheadPictures(letterhead);
    pictures.push_back(
        {u"charts"_s, reportPicture(chartsSize(report), [&](QPainter& painter, const QRectF& room,
                                                            const ThemeTokens& paper) {
             paintControlFigure(painter, *report.picture, report.panels, room, paper);
         })});
    for (std::size_t i = 0; i < report.capabilities.size(); ++i) {
        const ProcessCapability& capability = report.capabilities[i].capability;
        const ShownUnit unit =
            ControlSeries::unitOf(*report.picture->values, capability.quantity, capability.histogram.first);
        pictures.push_back(
            {histogramName(i), reportPicture(reportHistogram, [&](QPainter& painter, const QRectF& room,
                                                                  const ThemeTokens& paper) {
                 paintHistogram(painter, capability, unit, room, paper);
             })});
    }
    return writePdf(reportTitle(report), processReportHtml(report, letterhead), pictures, file);
}

} // namespace gripscope
