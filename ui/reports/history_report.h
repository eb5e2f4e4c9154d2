// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/recognition/type_model.h"
#include "core/store/history.h"
#include "core/store/library.h"

#include <QImage>

#include <map>

namespace gripscope {

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
