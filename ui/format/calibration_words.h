// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "ui/format/fact.h"

#include <QCoreApplication>

#include <vector>

namespace gripscope {

/// A calibration in words, the same on the screen and on its certificate.
class CalibrationWords {
    Q_DECLARE_TR_FUNCTIONS(CalibrationWords)
public:
    [[nodiscard]] static QString channel(SensorChannel channel); ///< "Force"
    /// "Holds until 1 Mar 2027.", "Overdue since 1 Mar 2026: ...", "Not calibrated here: ..."; `record` may
    /// be null.
    [[nodiscard]] static QString status(const CalibrationRecord* record, const QDate& today);
    /// For the status line: "force cal. due in 41 days", "force not calibrated"; `record` may be null.
    [[nodiscard]] static QString brief(SensorChannel channel, const CalibrationRecord* record,
                                       const QDate& today);
    /// Expanded uncertainty, linearity and so on; "–" for what the points do not tell.
    [[nodiscard]] static std::vector<Fact> figures(const SensorCalibration& calibration,
                                                   const CalibrationEvaluation& evaluation);
    /// "reading = 0.2001 + 1.0299 × load", both in what is read in place of the channel's `unit`.
    [[nodiscard]] static QString curve(const CalibrationEvaluation& evaluation, const QString& unit);
    /// What speaks against it; empty when nothing does.
    [[nodiscard]] static QString doubt(const CalibrationEvaluation& evaluation);
};

} // namespace gripscope
