// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"

#include <QMap>

namespace gripscope {

/// What a recording says of the calibration of one of its channels, as keys of its provenance:
/// `force_calibration` (when, against what, until when, the curve) and `force_calibration_days_left` (on the
/// day it was recorded; negative: overdue); the same for `position`.
struct CalibrationFact {
    SensorChannel channel = SensorChannel::Force;
    qint64 daysLeft = 0;
    QString words;
};

void noteCalibration(QMap<QString, QString>& provenance, const CalibrationRecord& calibration,
                     const QDate& today);
/// Of both channels, those that are noted.
[[nodiscard]] std::vector<CalibrationFact> calibrationFacts(const QMap<QString, QString>& provenance);

} // namespace gripscope
