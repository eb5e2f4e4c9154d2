// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/calibration_certificate.h"

#include "ui/charts/calibration_plot.h"
#include "ui/models/calibration_words.h"
#include "ui/widgets/number_format.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QLocale>
#include <QPdfWriter>
#include <QSaveFile>
#include <QTextDocument>
#include <QUrl>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

QString row(const QString& name, const QString& text)
{
    return u"<tr><td>%1</td><td>&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>"_s.arg(name.toHtmlEscaped(),
                                                                               text.toHtmlEscaped());
}

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
           row(CertificateWords::tr("Gripper"), record.gripperName + u", "_s +
                                                    CertificateWords::tr("serial number") + u' ' +
                                                    record.gripperSerial) +
           row(CertificateWords::tr("Channel"), CalibrationWords::channel(record.channel)) +
           row(CertificateWords::tr("Reference"), reference.name) +
           row(CertificateWords::tr("Its certificate"),
               reference.certificate.isEmpty() ? u"–"_s : reference.certificate) +
           row(CertificateWords::tr("Its standard uncertainty"), uncertainty) +
           row(CertificateWords::tr("Taken"),
               QLocale().toString(record.takenUtc.toLocalTime(), QLocale::ShortFormat)) +
           row(CertificateWords::tr("By"), record.operatorName) +
           row(CertificateWords::tr("Holds until"), CalibrationWords::date(record.due)) +
           row(CertificateWords::tr("Note"), record.note.isEmpty() ? u"–"_s : record.note) + u"</table>"_s;
}

QString pointTable(const CalibrationRecord& record, const CalibrationEvaluation& evaluation)
{
    QString html = u"<table cellspacing='0' cellpadding='2'><tr><th align='right'>%1</th><th "
                   u"align='right'>&nbsp;&nbsp;%2</th>"
                   "<th align='right'>&nbsp;&nbsp;%3</th><th align='right'>&nbsp;&nbsp;%4</th></tr>"_s.arg(
                       CertificateWords::tr("No."), CertificateWords::tr("Load (%1)").arg(record.unit),
                       CertificateWords::tr("Reading (%1)").arg(record.unit),
                       CertificateWords::tr("Reading less the curve (%1)").arg(record.unit));
    for (std::size_t i = 0; i < record.points.size(); ++i)
        html +=
            u"<tr><td align='right'>%1</td><td align='right'>%2</td><td align='right'>%3</td><td align='right'>%4</td></tr>"_s
                .arg(i + 1)
                .arg(QLocale().toString(record.points[i].load, 'g', 8))
                .arg(QLocale().toString(record.points[i].reading, 'g', 8))
                .arg(QLocale().toString(evaluation.residuals[i], 'g', 3));
    return html + u"</table>"_s;
}

} // namespace

QString certificateHtml(const CalibrationRecord& record, const CalibrationEvaluation& evaluation)
{
    QString figures;
    for (const Fact& fact : CalibrationWords::figures(record, evaluation))
        figures += row(fact.name, fact.text);
    return u"<h1>%1</h1>"_s.arg(CertificateWords::tr("Calibration certificate")) + identityTable(record) +
           u"<h2>%1</h2><p>%2</p><table>%3</table>"_s.arg(CertificateWords::tr("Result"),
                                                          CalibrationWords::curve(evaluation), figures) +
           u"<p>%1</p>"_s.arg(CertificateWords::tr(
               "The expanded uncertainty holds a load found from one reading in 95 of 100 cases. It "
               "counts the "
               "scatter about the curve, the curve itself, the reference and the return of the zero "
               "(JCGM 100:2008). Percentages are of the span of the readings.")) +
           u"<p><img src='residuals' width='640'></p><h2>%1</h2>"_s.arg(CertificateWords::tr("Points")) +
           pointTable(record, evaluation) +
           u"<p>%1</p>"_s.arg(CertificateWords::tr("Gripscope %1, record %2")
                                  .arg(QStringLiteral(GRIPSCOPE_VERSION), record.id));
}

QImage residualPicture(const CalibrationRecord& record)
{
    const Expected<CalibrationEvaluation> evaluation = evaluateCalibration(record);
    if (!evaluation)
        return {};
    CalibrationPlot plot;
    plot.resize(680, 260);
    plot.setCalibration(record, *evaluation);
    return toImage(plot, 3);
}

Expected<void> writeCertificate(const CalibrationRecord& record, const QImage& residuals, const QString& file)
{
    const Expected<CalibrationEvaluation> evaluation = evaluateCalibration(record);
    if (!evaluation)
        return tl::unexpected<Error>(evaluation.error());
    QSaveFile out(file);
    if (!out.open(QIODevice::WriteOnly))
        return failure(ErrorCode::FileUnwritable, {file, out.errorString()});
    QByteArray bytes;
    {
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter pdf(&buffer);
        pdf.setPageSize(QPageSize(QPageSize::A4));
        pdf.setPageMargins(QMarginsF(20, 20, 20, 20), QPageLayout::Millimeter);
        pdf.setTitle(CertificateWords::tr("Calibration certificate"));
        pdf.setCreator(u"Gripscope "_s + QStringLiteral(GRIPSCOPE_VERSION));
        QTextDocument document;
        document.setDefaultStyleSheet(
            u"h1 { font-size: 20pt; } h2 { font-size: 13pt; } body, td, th, p { font-size: 10pt; }"_s);
        document.addResource(QTextDocument::ImageResource, QUrl(u"residuals"_s), residuals);
        document.setHtml(certificateHtml(record, *evaluation));
        document.print(&pdf);
    }
    if (out.write(bytes) != bytes.size() || !out.commit())
        return failure(ErrorCode::FileUnwritable, {file, out.errorString()});
    return {};
}

} // namespace gripscope
