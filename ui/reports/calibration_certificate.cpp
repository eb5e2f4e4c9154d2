// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/calibration_plot.h"
#include "ui/format/calibration_words.h"
#include "ui/format/date_text.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_unit.h"
#include "ui/reports/pdf_document.h"
#include "ui/reports/reports.h"

#include <QCoreApplication>
#include <QImage>
#include <QLocale>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr QSize pictureSize(680, 260); // logical pixels

struct CertificateWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::CalibrationCertificate)
};

QString identityTable(const CalibrationRecord& record)
{
    const CalibrationReference& reference = record.reference;
    QString uncertainty = formatNumber(reference.standardUncertainty, {}, record.unit, 2).valueWithUnit();
    if (reference.relativeUncertainty > 0)
        uncertainty +=
            u" + "_s + formatRate(reference.relativeUncertainty) + u' ' + CertificateWords::tr("of the load");
    return u"<table>"_s +
           pdfRow(CertificateWords::tr("Gripper"), record.gripperName + u", "_s +
                                                       CertificateWords::tr("serial number") + u' ' +
                                                       record.gripperSerial) +
           pdfRow(CertificateWords::tr("Channel"), CalibrationWords::channel(record.channel)) +
           pdfRow(CertificateWords::tr("Reference"), reference.name) +
           pdfRow(CertificateWords::tr("Its certificate"),
                  reference.certificate.isEmpty() ? u"–"_s : reference.certificate) +
           pdfRow(CertificateWords::tr("Its standard uncertainty"), uncertainty) +
           pdfRow(CertificateWords::tr("Taken"), timeText(record.takenUtc)) +
           pdfRow(CertificateWords::tr("By"), record.operatorName) +
           pdfRow(CertificateWords::tr("Holds until"), dateText(record.due)) +
           pdfRow(CertificateWords::tr("Note"), record.note.isEmpty() ? u"–"_s : record.note) + u"</table>"_s;
}

QString pointTable(const CalibrationRecord& record, const CalibrationEvaluation& evaluation)
{
    const ShownUnit shown = readUnit(record.unit);
    QString html =
        u"<table cellspacing='0' cellpadding='2'><thead><tr><th align='right'>%1</th><th "
        u"align='right'>&nbsp;&nbsp;%2</th>"
        "<th align='right'>&nbsp;&nbsp;%3</th><th align='right'>&nbsp;&nbsp;%4</th></tr></thead>"_s.arg(
            CertificateWords::tr("No."), CertificateWords::tr("Load (%1)").arg(shown.unit).toHtmlEscaped(),
            CertificateWords::tr("Reading (%1)").arg(shown.unit).toHtmlEscaped(),
            CertificateWords::tr("Reading less the curve (%1)").arg(shown.unit).toHtmlEscaped());
    for (std::size_t i = 0; i < record.points.size(); ++i)
        html +=
            u"<tr><td align='right'>%1</td><td align='right'>%2</td><td align='right'>%3</td><td align='right'>%4</td></tr>"_s
                .arg(i + 1)
                .arg(QLocale().toString(shown.factor * record.points[i].load, 'g', 8))
                .arg(QLocale().toString(shown.factor * record.points[i].reading, 'g', 8))
                .arg(QLocale().toString(shown.factor * evaluation.residuals[i], 'g', 3));
    return html + u"</table>"_s;
}

} // namespace

QString certificateHtml(const CalibrationRecord& record, const CalibrationEvaluation& evaluation)
{
    QString figures;
    for (const Fact& fact : CalibrationWords::figures(record, evaluation))
        figures += pdfRow(fact.name, fact.text);
    return u"<h1>%1</h1>"_s.arg(CertificateWords::tr("Calibration certificate")) + identityTable(record) +
           u"<h2>%1</h2><p>%2</p><table>%3</table>"_s.arg(
               CertificateWords::tr("Result"),
               CalibrationWords::curve(evaluation, record.unit).toHtmlEscaped(), figures) +
           u"<p>%1</p>"_s.arg(CertificateWords::tr(
               "The expanded uncertainty holds a load found from one reading in 95 of 100 cases. It "
               "counts the "
               "scatter about the curve, the curve itself, the reference and the return of the zero "
               "(JCGM 100:2008). Percentages are of the span of the readings.")) +
           pdfPicture(u"residuals"_s, pictureSize) + u"<h2>%1</h2>"_s.arg(CertificateWords::tr("Points")) +
           pointTable(record, evaluation) +
           u"<p>%1</p>"_s.arg(CertificateWords::tr("Gripscope %1, record %2")
                                  .arg(QStringLiteral(GRIPSCOPE_VERSION), record.id)
                                  .toHtmlEscaped());
}

QImage residualPicture(const CalibrationRecord& record)
{
    const Expected<CalibrationEvaluation> evaluation = evaluateCalibration(record);
    if (!evaluation)
        return {};
    CalibrationPlot plot;
    plot.setAttribute(Qt::WA_DontShowOnScreen); // what was never shown has no layout yet
    plot.resize(pictureSize);
    plot.show();
    plot.setCalibration(record, *evaluation);
    return toImage(plot, 3);
}

Expected<void> writeCertificate(const CalibrationRecord& record, const QImage& residuals, const QString& file)
{
    ASSIGN_OR_RETURN(const CalibrationEvaluation evaluation, evaluateCalibration(record));
    return writePdf(CertificateWords::tr("Calibration certificate"), certificateHtml(record, evaluation),
                    {{u"residuals"_s, residuals}}, file);
}

} // namespace gripscope
