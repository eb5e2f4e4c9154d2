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
/// recorded; negative: overdue) and `force_correction` (the curve, SensorCorrection::text()); the same for
/// `position`.
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
