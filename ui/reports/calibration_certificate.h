// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"

#include <QImage>

namespace gripscope {

/// The certificate of a calibration on A4: what was calibrated, against what, by whom and when, the curve and
/// its figures, every point, and a plot of what is left. Written whole or not at all. FileUnwritable.
/// `residuals`: see residualPicture(). On any thread.
[[nodiscard]] Expected<void> writeCertificate(const CalibrationRecord& record, const QImage& residuals,
                                              const QString& file);
/// The plot of what is left, drawn for paper; on the screen's thread.
[[nodiscard]] QImage residualPicture(const CalibrationRecord& record);

/// What is in it, for a look beforehand.
[[nodiscard]] QString certificateHtml(const CalibrationRecord& record,
                                      const CalibrationEvaluation& evaluation);

} // namespace gripscope
