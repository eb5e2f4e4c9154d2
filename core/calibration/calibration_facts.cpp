// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_facts.h"

#include "core/base/words.h"

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

QString idKey(SensorChannel channel)
{
    return toString(channel) + u"_calibration_id"_s;
}

QString correctionKey(SensorChannel channel)
{
    return toString(channel) + u"_correction"_s;
}

const auto checkKey = u"reference_check"_s;
const auto checkWordsKey = u"reference_check_words"_s;

QString toString(CheckStatus status)
{
    switch (status) {
    case CheckStatus::Passed:
        return u"passed"_s;
    case CheckStatus::Due:
        return u"due"_s;
    case CheckStatus::Failed:
        return u"failed"_s;
    case CheckStatus::NotAsked:
        break;
    }
    return {};
}

// The file says it in English; who reads it there in another language, by Words::heard().
Finding calibrationWords()
{
    return Words::say("taken %1 against %2, holds until %3");
}

Finding lastCheckWords()
{
    return Words::say("last on %1 at %2");
}

Finding noCheckWords()
{
    return Words::say("never on %1");
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
        calibrationWords()
            .arg(calibration.takenUtc.date().toString(Qt::ISODate), calibration.reference.name.simplified(),
                 calibration.due.toString(Qt::ISODate))
            .english();
    provenance[correctionKey(calibration.channel)] = correction.text();
    provenance[daysKey(calibration.channel)] = QString::number(today.daysTo(calibration.due));
    if (!calibration.id.isEmpty())
        provenance[idKey(calibration.channel)] = calibration.id;
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
            facts.push_back({channel, days, heardCalibration(provenance.value(wordsKey(channel)))});
    }
    return facts;
}

std::optional<CalibrationNote> calibrationNote(const QMap<QString, QString>& provenance,
                                               SensorChannel channel)
{
    const bool noted = provenance.contains(wordsKey(channel));
    if (!noted && !provenance.contains(u"device"_s))
        return std::nullopt;
    return CalibrationNote{provenance.value(wordsKey(channel)), provenance.value(idKey(channel))};
}

Finding heardCalibration(const QString& words)
{
    return Words::heard({calibrationWords()}, words);
}

void noteReferenceCheck(QMap<QString, QString>& provenance, const ReferenceStanding& standing,
                        const QDateTime& now)
{
    const CheckStatus status = checkStatus(standing, now);
    if (status == CheckStatus::NotAsked)
        return;
    provenance[checkKey] = toString(status);
    provenance[checkWordsKey] = standing.last
                                    ? lastCheckWords()
                                          .arg(standing.reference.name.simplified(),
                                               standing.last->made.toUTC().toString(Qt::ISODate))
                                          .english()
                                    : noCheckWords().arg(standing.reference.name.simplified()).english();
}

std::optional<ReferenceCheckFact> referenceCheckFact(const QMap<QString, QString>& provenance)
{
    const QString found = provenance.value(checkKey);
    for (const CheckStatus status : {CheckStatus::Passed, CheckStatus::Due, CheckStatus::Failed})
        if (found == toString(status))
            return ReferenceCheckFact{
                status, Words::heard({lastCheckWords(), noCheckWords()}, provenance.value(checkWordsKey))};
    return std::nullopt;
}

} // namespace gripscope
