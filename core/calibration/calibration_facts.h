// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/calibration/calibration_record.h"
#include "core/calibration/sensor_correction.h"
#include "core/signal/recording/recording.h"

#include <QMap>

namespace gripscope {

/// What a recording says of the calibration of one of its channels, as keys of its provenance:
/// `force_calibration` (when, against what, until when), `force_calibration_days_left` (on the day it was
/// recorded; negative: overdue), `force_correction` (the curve, SensorCorrection::text()) and
/// `force_calibration_id` (its key in the library); the same for `position`.
struct CalibrationFact {
    SensorChannel channel = SensorChannel::Force;
    qint64 daysLeft = 0;
    Finding words;
};

void noteCalibration(QMap<QString, QString>& provenance, const CalibrationRecord& calibration,
                     const SensorCorrection& correction, const QDate& today);
/// Corrects a recording of the device's own readings as its provenance notes that it was: what is cut out of
/// kept reports becomes the recording that was made of them, to the last bit.
void correctAsNoted(Recording& recording);
/// Of both channels, those that are noted.
[[nodiscard]] std::vector<CalibrationFact> calibrationFacts(const QMap<QString, QString>& provenance);

/// By which calibration a channel was corrected, as it is stored with a squeeze.
struct CalibrationNote {
    QString words; ///< in English, for heardCalibration(); empty: by none
    QString id;    ///< its key in the library; may be empty
};
/// Nothing for a recording that is of no gripper, and so tells nothing of calibrations.
[[nodiscard]] std::optional<CalibrationNote> calibrationNote(const QMap<QString, QString>& provenance,
                                                             SensorChannel channel);
/// The words of a note, to be said in any language: "taken 2026-03-01 against Weights M1, holds until ...".
[[nodiscard]] Finding heardCalibration(const QString& words);

/// What a recording says of the check on the reference object: `reference_check` (failed, due or passed) and
/// `reference_check_words` (on what, when). Nothing where no check is asked for.
struct ReferenceCheckFact {
    CheckStatus status = CheckStatus::Passed;
    Finding words;
};
void noteReferenceCheck(QMap<QString, QString>& provenance, const ReferenceStanding& standing,
                        const QDateTime& now);
[[nodiscard]] std::optional<ReferenceCheckFact> referenceCheckFact(const QMap<QString, QString>& provenance);

} // namespace gripscope
