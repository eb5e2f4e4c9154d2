// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sensor_calibration.h"
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

/// "station-000012": no two alike, and none twice.
QString numberOf(const CalibrationRecord& record)
{
    constexpr int digits = 6;
    return record.certificateNumber > 0
               ? u"%1-%2"_s.arg(record.station).arg(record.certificateNumber, digits, 10, QChar(u'0'))
               : CertificateWords::tr("none: it was stored before certificates had numbers");
}

QString paragraph(const QString& text)
{
    return u"<p>%1</p>"_s.arg(text.toHtmlEscaped());
}

QString quantity(double value, const CalibrationRecord& record)
{
    return formatNumber(value, {}, record.unit, 2).valueWithUnit();
}

QString referenceCertificate(const CalibrationReference& reference)
{
    const QString number = reference.certificate.isEmpty() ? u"–"_s : reference.certificate;
    return reference.due.isValid()
               ? CertificateWords::tr("%1, valid until %2").arg(number, dateText(reference.due))
               : number;
}

QString conditionRows(const CalibrationRecord& record)
{
    const CalibrationConditions& conditions = record.conditions;
    QString rows = pdfRow(CertificateWords::tr("Ambient temperature"),
                          conditions.ambient_C ? QLocale().toString(*conditions.ambient_C, 'f', 1) +
                                                     QChar(QChar::Nbsp) + u"°C"_s
                                               : u"–"_s);
    if (const auto mass = massPerLoad(conditions.loadUnit, conditions.gravity, record.unit))
        rows += pdfRow(CertificateWords::tr("Loads"),
                       CertificateWords::tr("masses in %1, taken for forces by the local gravity of %2 m/s²")
                           .arg(mass->unit, QLocale().toString(conditions.gravity, 'f', 5)));
    return rows;
}

QString identityTable(const CalibrationRecord& record)
{
    const CalibrationReference& reference = record.reference;
    QString uncertainty = quantity(reference.standardUncertainty, record);
    if (reference.relativeUncertainty > 0)
        uncertainty +=
            u" + "_s + formatRate(reference.relativeUncertainty) + u' ' + CertificateWords::tr("of the load");
    return u"<table>"_s + pdfRow(CertificateWords::tr("Certificate number"), numberOf(record)) +
           pdfRow(CertificateWords::tr("Gripper"), record.gripperName + u", "_s +
                                                       CertificateWords::tr("serial number") + u' ' +
                                                       record.gripperSerial) +
           pdfRow(CertificateWords::tr("Channel"), CalibrationWords::channel(record.channel)) +
           pdfRow(CertificateWords::tr("Reference"), reference.name) +
           pdfRow(CertificateWords::tr("Its certificate"), referenceCertificate(reference)) +
           pdfRow(CertificateWords::tr("Its standard uncertainty"), uncertainty) + conditionRows(record) +
           pdfRow(CertificateWords::tr("Taken"), zonedTimeText(record.takenUtc)) +
           pdfRow(CertificateWords::tr("By"), record.operatorName) +
           pdfRow(CertificateWords::tr("Holds until"), dateText(record.due)) +
           pdfRow(CertificateWords::tr("Note"), record.note.isEmpty() ? u"–"_s : record.note) + u"</table>"_s;
}

QString inWords(CalibrationConformity conformity)
{
    switch (conformity) {
    case CalibrationConformity::Conforms:
        return CertificateWords::tr("conforms");
    case CalibrationConformity::DoesNotConform:
        return CertificateWords::tr("does not conform");
    case CalibrationConformity::Undecided:
        break;
    }
    return CertificateWords::tr(
        "not decided: the error is nearer to the tolerance than the uncertainty allows to tell");
}

/// "largest error 0.02 N: conforms"; without a tolerance the error alone.
QString errorText(const LoadErrors& errors, const CalibrationRecord& record,
                  const CalibrationEvaluation& evaluation)
{
    const QString largest = CertificateWords::tr("largest error %1").arg(quantity(errors.largest, record));
    const CalibrationConditions& conditions = record.conditions;
    if (!conditions.tolerance)
        return largest;
    return u"%1: %2"_s.arg(largest, inWords(judgeConformity(errors.largest, evaluation.expandedUncertainty,
                                                            *conditions.tolerance, conditions.rule)));
}

QString ruleText(DecisionRule rule)
{
    return rule == DecisionRule::Guarded
               ? CertificateWords::tr(
                     "Decision rule: it conforms where the largest error and the expanded uncertainty "
                     "together are within the tolerance, and does not where the error less the "
                     "uncertainty is beyond it (guard band of one expanded uncertainty, "
                     "ILAC-G8:09/2019).")
               : CertificateWords::tr(
                     "Decision rule: it conforms where the largest error is within the tolerance, "
                     "without regard to the uncertainty (simple acceptance, JCGM 106:2012).");
}

QString conformitySection(const CalibrationRecord& record, const CalibrationEvaluation& evaluation)
{
    const std::optional<LoadErrors> found = errorsAsFound(record);
    const std::optional<double>& tolerance = record.conditions.tolerance;
    QString html = pdfHeading(CertificateWords::tr("As found and as left")) + u"<table>"_s;
    if (tolerance)
        html += pdfRow(CertificateWords::tr("Tolerance"), u"± "_s + quantity(*tolerance, record));
    html += pdfRow(CertificateWords::tr("As found"),
                   found ? errorText(*found, record, evaluation) : CertificateWords::tr("not recorded"));
    html += pdfRow(CertificateWords::tr("As left"),
                   errorText(errorsAsLeft(record, evaluation), record, evaluation)) +
            u"</table>"_s;
    html += paragraph(
        tolerance ? ruleText(record.conditions.rule)
                  : CertificateWords::tr("No tolerance was stated, so there is no statement of conformity."));
    if (found)
        html += paragraph(
            record.foundCorrection->isEmpty()
                ? CertificateWords::tr("As found: by the gripper's own scale, uncorrected until then.")
                : CertificateWords::tr("As found: by the calibration that was in force until then."));
    html += paragraph(
        record.checkPoints.empty()
            ? CertificateWords::tr(
                  "As left: the same readings by the new curve, which corrects them from now on. "
                  "Nothing was adjusted in the gripper itself.")
            : CertificateWords::tr(
                  "As left: by the new curve, at the points of a check that was taken afterwards and "
                  "is no part of the curve. Nothing was adjusted in the gripper itself."));
    return html;
}

QString resultSection(const CalibrationRecord& record, const CalibrationEvaluation& evaluation)
{
    QString figures;
    for (const Fact& fact : CalibrationWords::figures(record, evaluation))
        figures += pdfRow(fact.name, fact.text);
    if (evaluation.coverageFactor > 0)
        figures += pdfRow(CertificateWords::tr("Coverage factor"),
                          CertificateWords::tr("k = %1, coverage about 95 %")
                              .arg(QLocale().toString(evaluation.coverageFactor, 'f', 2)));
    return pdfHeading(CertificateWords::tr("Result")) +
           paragraph(CalibrationWords::curve(evaluation, record.unit)) + u"<table>%1</table>"_s.arg(figures) +
           paragraph(CertificateWords::tr("The expanded uncertainty is the standard uncertainty times the "
                                          "coverage factor k, by Student's t. It "
                                          "holds a load found from one reading in 95 of 100 cases. It counts "
                                          "the scatter about the curve, the "
                                          "curve itself, the reference and the return of the zero (JCGM "
                                          "100:2008). Percentages are of the span "
                                          "of the readings."));
}

QString numbersHeader(const QStringList& names)
{
    QString html = u"<thead><tr>"_s;
    for (const QString& name : names)
        html += u"<th align='right'>%1</th>"_s.arg(name.toHtmlEscaped());
    return html + u"</tr></thead>"_s;
}

QString numbersRow(const QStringList& cells)
{
    QString html = u"<tr>"_s;
    for (const QString& cell : cells)
        html += u"<td align='right'>%1</td>"_s.arg(cell.isEmpty() ? u"–"_s : cell.toHtmlEscaped());
    return html + u"</tr>"_s;
}

const auto numbersTable = u"<table class='small' width='100%' cellspacing='0' cellpadding='2'>"_s;

QString upAndDownTable(const CalibrationRecord& record)
{
    const ShownUnit shown = readUnit(record.unit);
    const auto number = [&shown](const std::optional<double>& value, int digits) {
        return value ? QLocale().toString(shown.factor * *value, 'g', digits) : QString();
    };
    QString html =
        numbersTable + numbersHeader({CertificateWords::tr("Load (%1)").arg(shown.unit),
                                      CertificateWords::tr("Reading going up (%1)").arg(shown.unit),
                                      CertificateWords::tr("Reading going down (%1)").arg(shown.unit),
                                      CertificateWords::tr("Difference (%1)").arg(shown.unit)});
    for (const UpAndDown& row : upAndDown(record.points)) {
        const std::optional<double> difference =
            row.up && row.down ? std::optional(*row.down - *row.up) : std::nullopt;
        html +=
            numbersRow({number(row.load, 8), number(row.up, 8), number(row.down, 8), number(difference, 3)});
    }
    return html + u"</table>"_s;
}

/// The points that were fitted, or those of the check, with the errors of the loads that the gripper said.
class PointTable {
public:
    PointTable(const CalibrationRecord& record, const CalibrationEvaluation& evaluation)
        : m_record(record), m_evaluation(evaluation), m_shown(readUnit(record.unit)),
          m_mass(massPerLoad(record.conditions.loadUnit, record.conditions.gravity, record.unit))
    {
    }

    [[nodiscard]] QString fitted() const
    {
        const std::optional<LoadErrors> found = errorsAsFound(m_record);
        SensorCalibration without = m_record;
        without.checkPoints.clear();
        return table(m_record.points, found ? found->each : std::vector<double>(),
                     errorsAsLeft(without, m_evaluation).each);
    }
    [[nodiscard]] QString check() const
    {
        return table(m_record.checkPoints, {}, errorsAsLeft(m_record, m_evaluation).each);
    }

private:
    [[nodiscard]] QString number(double value, int digits) const
    {
        return QLocale().toString(m_shown.factor * value, 'g', digits);
    }
    [[nodiscard]] QString header() const
    {
        QStringList names{CertificateWords::tr("No."), CertificateWords::tr("Way")};
        if (m_mass)
            names << CertificateWords::tr("Mass (%1)").arg(m_mass->unit);
        for (const QString& name :
             {CertificateWords::tr("Load (%1)"), CertificateWords::tr("Reading (%1)"),
              CertificateWords::tr("Error as found (%1)"), CertificateWords::tr("Error as left (%1)")})
            names << name.arg(m_shown.unit);
        return numbersHeader(names);
    }
    [[nodiscard]] QString table(const std::vector<CalibrationPoint>& points, const std::vector<double>& found,
                                const std::vector<double>& left) const
    {
        const std::vector<bool> ascending = ascendingPoints(points);
        QString html = numbersTable + header();
        for (std::size_t i = 0; i < points.size(); ++i) {
            QStringList cells{QString::number(i + 1),
                              ascending[i] ? CertificateWords::tr("up") : CertificateWords::tr("down")};
            if (m_mass)
                cells << QLocale().toString(m_mass->factor * points[i].load, 'g', 8);
            cells << number(points[i].load, 8) << number(points[i].reading, 8)
                  << (i < found.size() ? number(found[i], 3) : QString()) << number(left[i], 3);
            html += numbersRow(cells);
        }
        return html + u"</table>"_s;
    }

    const CalibrationRecord& m_record;
    const CalibrationEvaluation& m_evaluation;
    ShownUnit m_shown;
    std::optional<ShownUnit> m_mass;
};

QString signatureLines(const CalibrationRecord& record)
{
    const QString line = QString(30, u'_');
    return u"<p>&nbsp;</p><table width='100%'><tr><td>%1<br>%2</td><td>%1<br>%3</td></tr></table>"_s.arg(
        line, CertificateWords::tr("Calibrated by %1, signature").arg(record.operatorName).toHtmlEscaped(),
        CertificateWords::tr("Released by, date, signature").toHtmlEscaped());
}

} // namespace

QString certificateHtml(const CalibrationRecord& record, const CalibrationEvaluation& evaluation,
                        const Letterhead& letterhead)
{
    const PointTable points(record, evaluation);
    QString html =
        letterheadHtml(letterhead) + u"<h1>%1</h1>"_s.arg(CertificateWords::tr("Calibration certificate")) +
        identityTable(record) + conformitySection(record, evaluation) + resultSection(record, evaluation) +
        pdfPicture(u"residuals"_s, pictureSize) + pdfHeading(CertificateWords::tr("Up and down")) +
        upAndDownTable(record) + pdfHeading(CertificateWords::tr("Points")) + points.fitted();
    if (!record.checkPoints.empty())
        html += pdfHeading(CertificateWords::tr("Points of the check afterwards")) + points.check();
    return html + signatureLines(record) +
           paragraph(CertificateWords::tr("Gripscope %1, record %2")
                         .arg(QStringLiteral(GRIPSCOPE_VERSION), record.id));
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

Expected<void> writeCertificate(const CalibrationRecord& record, const QImage& residuals,
                                const LetterheadSource& source, const QString& file)
{
    ASSIGN_OR_RETURN(const CalibrationEvaluation evaluation, evaluateCalibration(record));
    ASSIGN_OR_RETURN(const Letterhead letterhead, readLetterhead(source));
    std::vector<PdfPicture> pictures = letterheadPictures(letterhead);
    pictures.push_back({u"residuals"_s, residuals});
    return writePdf(CertificateWords::tr("Calibration certificate %1").arg(numberOf(record)),
                    certificateHtml(record, evaluation, letterhead), pictures, file);
}

} // namespace gripscope
