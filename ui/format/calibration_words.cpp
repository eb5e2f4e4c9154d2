// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/calibration_words.h"

#include "ui/format/date_text.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_unit.h"

#include <QLocale>
#include <QStringList>

#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr double doubtfulMisfit = 0.01;

QString percentOfScale(const std::optional<double>& percent)
{
    constexpr double least = 0.001; // below it there is only the rounding of the computer
    constexpr double whole = 100;   // from there on two significant digits would read 1.7E+02
    if (!percent)
        return u"–"_s;
    const double size = std::abs(*percent);
    const QString number = size < least    ? u"< "_s + QLocale().toString(least)
                           : size >= whole ? QLocale().toString(size, 'f', 0)
                                           : QLocale().toString(size, 'g', 2);
    return number + QChar::Nbsp + u'%';
}

} // namespace

QString CalibrationWords::channel(SensorChannel channel)
{
    return channel == SensorChannel::Force ? tr("Force") : tr("Position");
}

QString CalibrationWords::status(const CalibrationRecord* record, const QDate& today)
{
    switch (calibrationStatus(record ? std::optional(record->due) : std::nullopt, today)) {
    case CalibrationStatus::Missing:
        return tr("Not calibrated here: its own scale is taken.");
    case CalibrationStatus::Overdue:
        return tr("Overdue since %1: measurements are marked as suspect.").arg(dateText(record->due));
    case CalibrationStatus::DueSoon:
        return tr("Holds until %1: calibrate soon.").arg(dateText(record->due));
    case CalibrationStatus::Valid:
        break;
    }
    return tr("Holds until %1.").arg(dateText(record->due));
}

QString CalibrationWords::brief(SensorChannel channel, const CalibrationRecord* record, const QDate& today)
{
    const bool force = channel == SensorChannel::Force;
    if (record == nullptr)
        return force ? tr("force not calibrated") : tr("position not calibrated");
    const auto days = int(today.daysTo(record->due));
    if (days < 0)
        return force ? tr("force cal. overdue since %1").arg(dateText(record->due))
                     : tr("position cal. overdue since %1").arg(dateText(record->due));
    if (days < 2) {
        const QString day = days == 0 ? tr("today") : tr("tomorrow");
        return force ? tr("force cal. due %1").arg(day) : tr("position cal. due %1").arg(day);
    }
    return force ? tr("force cal. due in %n days", nullptr, days)
                 : tr("position cal. due in %n days", nullptr, days);
}

std::vector<Fact> CalibrationWords::figures(const SensorCalibration& calibration,
                                            const CalibrationEvaluation& evaluation)
{
    const CalibrationFigures& found = evaluation.figures;
    const QString fit = found.lackOfFitProbability
                            ? tr("p = %1").arg(QLocale().toString(*found.lackOfFitProbability, 'g', 2))
                            : u"–"_s;
    return {{tr("Expanded uncertainty (95 %)"),
             u"± "_s + formatNumber(evaluation.expandedUncertainty, {}, calibration.unit, 2).valueWithUnit()},
            {tr("Linearity"), percentOfScale(found.linearityPercent)},
            {tr("Repeatability"), percentOfScale(found.repeatabilityPercent)},
            {tr("Reversibility"), percentOfScale(found.reversibilityPercent)},
            {tr("Zero return"), percentOfScale(found.zeroReturnPercent)},
            {tr("Fit of the curve"), fit}};
}

QString CalibrationWords::curve(const CalibrationEvaluation& evaluation, const QString& unit)
{
    Eigen::VectorXd coefficients = evaluation.curve.coefficients();
    const double factor = readUnit(unit).factor;
    for (Eigen::Index i = 0; i < coefficients.size(); ++i)
        coefficients[i] *= std::pow(factor, 1 - double(i));
    constexpr int digits = 6;
    QString text = tr("reading = %1").arg(QLocale().toString(coefficients[0], 'g', digits));
    for (Eigen::Index i = 1; i < coefficients.size(); ++i) {
        text += coefficients[i] < 0 ? u" − "_s : u" + "_s;
        text += QLocale().toString(std::abs(coefficients[i]), 'g', digits) + u" × "_s + tr("load");
        if (i > 1)
            text += QString(u"⁰¹²³⁴⁵⁶⁷⁸"_s[i]);
    }
    return text;
}

QString CalibrationWords::doubt(const CalibrationEvaluation& evaluation)
{
    if (evaluation.figures.lackOfFitProbability.value_or(1) < doubtfulMisfit)
        return tr("The curve does not follow the points as closely as they repeat: try a higher degree, or "
                  "look for a point that is wrong.");
    return {};
}

} // namespace gripscope
