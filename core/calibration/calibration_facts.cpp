// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_facts.h"

#include "core/words.h"

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

QString correctionKey(SensorChannel channel)
{
    return toString(channel) + u"_correction"_s;
}

void correct(std::vector<double>& values, const QString& text)
{
    const std::optional<SensorCorrection> correction = SensorCorrection::fromText(text);
    for (double& value : values)
        value = correction ? correction->loadOf(value) : value;
}

} // namespace

void noteCalibration(QMap<QString, QString>& provenance, const CalibrationRecord& calibration,
                     const SensorCorrection& correction, const QDate& today)
{
    provenance[wordsKey(calibration.channel)] =
        Words::tr("taken %1 against %2, holds until %3")
            .arg(calibration.takenUtc.date().toString(Qt::ISODate), calibration.reference.name.simplified(),
                 calibration.due.toString(Qt::ISODate));
    provenance[correctionKey(calibration.channel)] = correction.text();
    provenance[daysKey(calibration.channel)] = QString::number(today.daysTo(calibration.due));
}

void correctAsNoted(Recording& recording)
{
    correct(recording.force, recording.provenance.value(correctionKey(SensorChannel::Force)));
    correct(recording.position, recording.provenance.value(correctionKey(SensorChannel::Position)));
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
