// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/library/library.h"
#include "core/library/records/history.h"
#include "core/recognition/types/type_model.h"

#include <QImage>

#include <map>

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

/// What a report of the history tells of.
struct HistoryReport {
    HistoryQuery query;
    HistoryCounts counts;
    HistoryPoints points;
    std::vector<HistoryEntry> rows;                      ///< the first of them
    std::size_t total = 0;                               ///< of the rows
    std::map<QString, CalibrationsInForce> calibrations; ///< by the serial number of the gripper
    TypeModels models;                                   ///< of the types as they are enrolled now
    QString operatorName;                                ///< who asks for it
    QString library;                                     ///< its file
    QDateTime made;
};

/// A table on paper has an end: so many rows are listed.
inline constexpr std::size_t mostReportRows = 500;

/// All of it but models, operator and time. On the library's thread.
[[nodiscard]] Expected<HistoryReport> readHistoryReport(Library& library, const HistoryQuery& query);
/// Filter, counts and yield with exact bounds, m, b and k over time with the intervals of the types, who, on
/// which gripper, calibrated how, with which software, and the squeezes. Written whole or not at all. On any
/// thread. FileUnwritable.
[[nodiscard]] Expected<void> writeHistoryReport(const HistoryReport& report, const QString& file);
/// What is in it, for a look beforehand.
[[nodiscard]] QString historyReportHtml(const HistoryReport& report);

} // namespace gripscope
