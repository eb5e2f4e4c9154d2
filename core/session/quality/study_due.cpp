// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_due.h"

#include "core/calibration/sensor_calibration.h"
#include "core/session/quality/study_options.h"

#include <algorithm>

namespace gripscope {

StudyStatus StudyStanding::status(const QDate& today) const
{
    if (!last)
        return StudyStatus::Missing;
    switch (calibrationStatus(due, today)) {
    case CalibrationStatus::Missing:
        return StudyStatus::NotAsked;
    case CalibrationStatus::Overdue:
        return StudyStatus::Overdue;
    case CalibrationStatus::DueSoon:
        return StudyStatus::DueSoon;
    case CalibrationStatus::Valid:
        break;
    }
    return StudyStatus::Valid;
}

std::vector<StudyKind> studyKindsInOrder()
{
    return {StudyKind::TypeOne, StudyKind::Gauge, StudyKind::Linearity, StudyKind::Attributes};
}

std::optional<QDate> studyHoldsUntil(const StudyRecord& study)
{
    const int months = studyOptionsFromJson(study.study.options).repeatAfterMonths;
    if (study.state != StudyState::Finished || !study.ended || months <= 0)
        return std::nullopt;
    return study.ended->toLocalTime().date().addMonths(months);
}

std::vector<StudyStanding> studyStandings(const std::vector<StudyRecord>& studies,
                                          const QString& gripperSerial)
{
    std::vector<StudyStanding> standings;
    for (const StudyKind kind : studyKindsInOrder()) {
        StudyStanding standing;
        standing.kind = kind;
        const auto last = std::ranges::find_if(studies, [&](const StudyRecord& study) {
            return study.study.kind == toString(kind) && study.state == StudyState::Finished &&
                   (gripperSerial.isEmpty() || kind == StudyKind::Attributes ||
                    study.study.gripperSerial == gripperSerial);
        });
        if (last != studies.end()) {
            standing.last = *last;
            standing.due = studyHoldsUntil(*last);
        }
        standings.push_back(std::move(standing));
    }
    return standings;
}

} // namespace gripscope
