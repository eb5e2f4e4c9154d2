// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/work_watch.h"
#include "core/calibration/calibration_record.h"
#include "core/library/library.h"
#include "core/library/records/history.h"
#include "core/recognition/types/type_model.h"
#include "core/recognition/verdict/verdict.h"
#include "ui/reports/letterhead.h"

#include <QImage>

namespace gripscope {

/// The certificate of a calibration on A4: its number, whose it is, what was calibrated, against what, under
/// which conditions, by whom and when, the statement of conformity, as found and as left, the curve and its
/// figures, every point, and a plot of what is left. Written whole or not at all. FileUnwritable,
/// FileUnreadable (the logo). `residuals`: see residualPicture(). On any thread.
[[nodiscard]] Expected<void> writeCertificate(const CalibrationRecord& record, const QImage& residuals,
                                              const LetterheadSource& letterhead, const QString& file);
/// The plot of what is left, drawn for paper; on the screen's thread.
[[nodiscard]] QImage residualPicture(const CalibrationRecord& record);

/// What is in it, for a look beforehand.
[[nodiscard]] QString certificateHtml(const CalibrationRecord& record,
                                      const CalibrationEvaluation& evaluation,
                                      const Letterhead& letterhead = {});

/// What a report of the history tells of.
struct HistoryReport {
    HistoryQuery query;
    HistoryCounts counts;
    HistoryPoints points;
    HistoryInForce inForce;
    std::vector<HistoryEntry> rows; ///< the first of them
    std::size_t total = 0;          ///< of the rows
    TypeModels models;              ///< of the types as they are enrolled now
    VerdictOptions rates;           ///< set now
    QString operatorName;           ///< who asks for it
    qint64 number = 0;              ///< of the entry in the audit trail that tells of it; 0: none yet
    LetterheadSource letterhead;
    QString library; ///< its file
    QDateTime made;
};

/// A table on paper has an end: so many rows are listed.
inline constexpr std::size_t mostReportRows = 500;

/// All of it but models, rates, operator, letterhead and time. On the library's thread.
[[nodiscard]] Expected<HistoryReport> readHistoryReport(Library& library, const HistoryQuery& query);
/// Tells the audit trail that the report goes to `file`, and numbers it by that entry: no other report of the
/// library has its number, and the trail says who made it and when. On the library's thread.
[[nodiscard]] Expected<void> numberHistoryReport(Library& library, HistoryReport& report,
                                                 const QString& file);
/// Filter, counts and yield with exact bounds, m, b and k over time with the intervals of the types, who, on
/// which gripper, what was in force then (calibrations, rates, types, software), and the squeezes, with batch
/// and part number where any has one; its number at the head and at the foot of each page. Written
/// whole or not at all. On any thread. FileUnwritable.
[[nodiscard]] Expected<void> writeHistoryReport(const HistoryReport& report, const QString& file,
                                                const std::shared_ptr<WorkWatch>& watch = {});
/// What is in it, for a look beforehand.
[[nodiscard]] QString historyReportHtml(const HistoryReport& report, const Letterhead& letterhead = {});

} // namespace gripscope
