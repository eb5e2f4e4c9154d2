// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/control_series.h"
#include "ui/reports/letterhead.h"

#include <QDateTime>

namespace gripscope {

struct ReportedSignal {
    QString inspection, time, quantity, what, since;
};

/// A quantity against its tolerance limits: name, value and interval of each index, and sentences.
struct ReportedCapability {
    ProcessCapability capability;
    std::vector<std::array<QString, 3>> lines;
    QStringList sentences;
};

/// The control charts of a type's inspections on paper.
struct ProcessReport {
    std::shared_ptr<const ProcessPicture> picture;
    std::vector<ControlPanel> panels;
    QString type, chart, rules;
    QString limits;                    ///< where they come from
    QString narrowed;                  ///< by which filters; empty: by none
    std::vector<ReportedSignal> found; ///< the newest
    std::size_t signalCount = 0;       ///< of all
    std::size_t pointCount = 0;        ///< on all charts
    std::vector<ReportedCapability> capabilities;
    LetterheadSource letterhead;
    QString operatorName; ///< who asks for it
    QDateTime made;
};

/// Which inspections, the charts with their limits, what they signal, run lengths, and the capability with
/// its histograms. Written whole or not at all. On any thread. FileUnwritable, FileUnreadable (the logo).
[[nodiscard]] Expected<void> writeProcessReport(const ProcessReport& report, const QString& file);
/// What is in it, for a look beforehand.
[[nodiscard]] QString processReportHtml(const ProcessReport& report, const Letterhead& letterhead = {});

} // namespace gripscope
