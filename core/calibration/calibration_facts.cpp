// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_facts.h"

#include <QStringList>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString wordsKey(SensorChannel channel)
{
    return toString(channel) + u"_calibration"_s;
}
QString daysKey(SensorChannel channel)
{
    return toString(channel) + u"_calibration_days_left"_s;
}

/// "reading = 0.3 + 1.015 x + 0.0002 x^2", to the last digit: readings can be found again from loads.
QString curveText(const SensorCalibration& calibration)
{
    const Expected<CalibrationEvaluation> evaluation = evaluateCalibration(calibration);
    if (!evaluation)
        return {};
    const Eigen::VectorXd coefficients = evaluation->curve.coefficients();
    QStringList terms;
    for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
        const QString power = i == 0 ? QString() : i == 1 ? u" x"_s : u" x^%1"_s.arg(i);
        terms << QString::number(coefficients[i], 'g', 17) + power;
    }
    return u"reading = "_s + terms.join(u" + "_s);
}

} // namespace

void noteCalibration(QMap<QString, QString>& provenance, const CalibrationRecord& calibration,
                     const QDate& today)
{
    provenance[wordsKey(calibration.channel)] = u"taken %1 against %2, holds until %3, %4"_s.arg(
        calibration.takenUtc.date().toString(Qt::ISODate), calibration.reference.name,
        calibration.due.toString(Qt::ISODate), curveText(calibration));
    provenance[daysKey(calibration.channel)] = QString::number(today.daysTo(calibration.due));
}

std::vector<CalibrationFact> calibrationFacts(const QMap<QString, QString>& provenance)
{
    std::vector<CalibrationFact> facts;
    for (const SensorChannel channel : {SensorChannel::Force, SensorChannel::Position}) {
        bool isNumber = false;
        const qint64 days = provenance.value(daysKey(channel)).toLongLong(&isNumber);
        if (isNumber)
            facts.push_back({channel, days, provenance.value(wordsKey(channel))});
    }
    return facts;
}

} // namespace gripscope
