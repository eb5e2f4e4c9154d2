// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_due.h"
#include "ui/charts/study_charts.h"
#include "ui/format/date_text.h"
#include "ui/format/number_format.h"
#include "ui/format/reference_words.h"
#include "ui/reports/pdf_document.h"
#include "ui/reports/quality_reports.h"

#include <QPainter>

#include <array>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr QSize studyChartSize(430, 250); // logical pixels; two stand beside each other
constexpr int studyPictureScale = 3;

struct StudyReportWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::StudyReport)
};

QString studyParagraph(const QString& text)
{
    return u"<p>%1</p>"_s.arg(text.toHtmlEscaped());
}

QString studyKindWords(StudyKind kind)
{
    switch (kind) {
    case StudyKind::Gauge:
        return StudyReportWords::tr("Gauge repeatability and reproducibility");
    case StudyKind::TypeOne:
        return StudyReportWords::tr("Type-1 study");
    case StudyKind::Linearity:
        return StudyReportWords::tr("Linearity");
    case StudyKind::Transfer:
        return StudyReportWords::tr("Types on another gripper");
    case StudyKind::Attributes:
        break;
    }
    return StudyReportWords::tr("Attribute agreement");
}

QString studyDesignWords(const PlanDesign& design)
{
    if (design.parts.size() == 1 && design.operators.isEmpty())
        return StudyReportWords::tr("One part, %1 squeezes").arg(formatCount(design.trials));
    return design.operators.isEmpty()
               ? StudyReportWords::tr("%1 parts, %2 trials, in random order")
                     .arg(formatCount(design.parts.size()), formatCount(design.trials))
               : StudyReportWords::tr("%1 parts, %2 operators, %3 trials, in random order")
                     .arg(formatCount(design.parts.size()), formatCount(design.operators.size()),
                          formatCount(design.trials));
}

QString studyFacts(const StudyReport& report)
{
    const StudyRecord& record = report.study.record;
    const PlanDesign& design = report.study.plan.design;
    const auto named = [](const QString& text) { return text.isEmpty() ? u"–"_s : text; };
    QString html = u"<table>"_s;
    html += pdfRow(StudyReportWords::tr("Gripper"), named(record.study.gripperSerial));
    html += pdfRow(StudyReportWords::tr("Led by"), named(record.study.operatorName));
    html += pdfRow(
        StudyReportWords::tr("From, to"),
        u"%1 – %2"_s.arg(zonedTimeText(record.begun), zonedTimeText(record.ended.value_or(record.begun))));
    html += pdfRow(StudyReportWords::tr("Kind"), studyKindWords(design.kind));
    html += pdfRow(StudyReportWords::tr("Design"), studyDesignWords(design));
    if (!design.operators.isEmpty())
        html += pdfRow(StudyReportWords::tr("Operators"), design.operators.join(u", "_s));
    if (design.kind != StudyKind::Attributes)
        html += pdfRow(StudyReportWords::tr("Squeezed as"), record.study.recipe.name);
    if (report.result.left + report.result.skipped + report.result.repeated > 0)
        html += pdfRow(StudyReportWords::tr("Squeezes"),
                       StudyReportWords::tr("%1 not made, %2 left out, %3 repeated")
                           .arg(report.result.left)
                           .arg(report.result.skipped)
                           .arg(report.result.repeated));
    if (!record.endReason.isEmpty())
        html += pdfRow(StudyReportWords::tr("Ended because"), record.endReason);
    if (const std::optional<QDate> due = studyHoldsUntil(record))
        html += pdfRow(StudyReportWords::tr("Holds until"), dateText(*due));
    return html + u"</table>"_s;
}

QString studyNumbersHtml(const StudyNumbersTable& table)
{
    const auto cell = [](const QString& text, bool number) {
        return u"<td%1>%2&nbsp;&nbsp;</td>"_s.arg(number ? u" align='right'"_s : QString(),
                                                  text.toHtmlEscaped().replace(u' ', QChar::Nbsp));
    };
    QString html = u"<table class='small'><tr>"_s;
    for (qsizetype i = 0; i < table.heads.size(); ++i)
        html += u"<th align='%1'>%2&nbsp;&nbsp;</th>"_s.arg(i == 0 ? u"left"_s : u"right"_s,
                                                            table.heads[i].toHtmlEscaped());
    html += u"</tr>"_s;
    for (const QStringList& row : table.rows) {
        html += u"<tr>"_s;
        for (qsizetype i = 0; i < row.size(); ++i)
            html += cell(row[i], i > 0);
        html += u"</tr>"_s;
    }
    return html + u"</table>"_s;
}

QString studyPictureName(std::size_t quantity)
{
    return u"study%1"_s.arg(quantity);
}

QSize studyPictureSize()
{
    constexpr int rows = (int(StudyCharts::count) + 1) / 2;
    return {2 * studyChartSize.width(), rows * studyChartSize.height()};
}

QImage studyChartsPicture(const StudyReport& report, std::size_t quantity)
{
    QImage image(studyPictureSize() * studyPictureScale, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(studyPictureScale, studyPictureScale);
    const ThemeTokens paper = themeTokens(ThemeKind::Light);
    // As on the screen: the ranges of all operators and parts have the last line to themselves.
    constexpr std::array<int, StudyCharts::count> places{0, 1, 2, 4, 3};
    const auto charts = StudyCharts::of(report.study, *report.result.gauge(), quantity);
    for (std::size_t i = 0; i < charts.size(); ++i) {
        const int wide = places[i] == 4 ? 2 : 1;
        const QRectF area((places[i] % 2) * studyChartSize.width(), (places[i] / 2) * studyChartSize.height(),
                          wide * studyChartSize.width(), studyChartSize.height());
        paintCategoryChart(painter, area.adjusted(4, 6, -10, -10), charts[i], paper);
    }
    return image;
}

/// Of the kinds that have one chart: as wide as the page.
QSize singlePictureSize()
{
    return {2 * studyChartSize.width(), studyChartSize.height()};
}

QImage singlePicture(const CategoryChart& chart)
{
    QImage image(singlePictureSize() * studyPictureScale, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(studyPictureScale, studyPictureScale);
    paintCategoryChart(painter, QRectF(QPointF(), singlePictureSize()).adjusted(4, 6, -10, -10), chart,
                       themeTokens(ThemeKind::Light));
    return image;
}

QString gaugeHtml(const StudyReport& report, const GaugeResult& gauge)
{
    QString html = pdfHeading(StudyReportWords::tr("Distinct categories"));
    html += studyParagraph(StudyNumbers::categories(gauge).join(u"; "_s));
    for (std::size_t i = gauge.quantities.size(); i-- > 0;) {
        html += pdfHeading(ReferenceWords::quantity(StudyCharts::placeOf(gauge.quantities[i].name)));
        html += studyParagraph(StudyNumbers::remarks(gauge, i).join(u' '));
        html += studyNumbersHtml(StudyNumbers::of(report.result, i)) +
                pdfPicture(studyPictureName(i), studyPictureSize());
    }
    return html;
}

QString singleHtml(const StudyReport& report)
{
    const StudyNumbersTable table = StudyNumbers::of(report.result);
    QString html = pdfHeading(table.title) + studyNumbersHtml(table);
    if (!StudyCharts::single(report.study, report.result).series.empty())
        html += pdfPicture(studyPictureName(0), singlePictureSize());
    return html;
}

} // namespace

QString studyReportHtml(const StudyReport& report, const Letterhead& letterhead)
{
    QString html =
        letterheadHtml(letterhead) + u"<h1>%1</h1>"_s.arg(StudyReportWords::tr("Study of the gripper: %1")
                                                              .arg(report.study.record.study.name)
                                                              .toHtmlEscaped());
    html += studyParagraph(described(report.result.verdict).join(u' '));
    html += studyFacts(report);
    const GaugeResult* const gauge = report.result.gauge();
    html += gauge != nullptr ? gaugeHtml(report, *gauge) : singleHtml(report);
    return html +
           studyParagraph(StudyReportWords::tr("Made %1 by %2 with Gripscope %3.")
                              .arg(zonedTimeText(report.made),
                                   report.operatorName.isEmpty() ? StudyReportWords::tr("somebody not named")
                                                                 : report.operatorName,
                                   QStringLiteral(GRIPSCOPE_VERSION)));
}

Expected<void> writeStudyReport(const StudyReport& report, const QString& file)
{
    ASSIGN_OR_RETURN(const Letterhead letterhead, readLetterhead(report.letterhead));
    std::vector<PdfPicture> pictures = letterheadPictures(letterhead);
    if (const GaugeResult* const gauge = report.result.gauge())
        for (std::size_t i = 0; i < gauge->quantities.size(); ++i)
            pictures.push_back({studyPictureName(i), studyChartsPicture(report, i)});
    else
        pictures.push_back(
            {studyPictureName(0), singlePicture(StudyCharts::single(report.study, report.result))});
    return writePdf(StudyReportWords::tr("Study of the gripper: %1").arg(report.study.record.study.name),
                    studyReportHtml(report, letterhead), pictures, file);
}

} // namespace gripscope
