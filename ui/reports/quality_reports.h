// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/quality/study_result.h"
#include "ui/charts/control_series.h"
#include "ui/reports/letterhead.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QString>
#include <QStringList>

#include <array>
#include <memory>
#include <vector>

namespace gripscope {

/// Numbers of a study, worded, the same on the screen and on paper. The first column says what a row is of.
struct StudyNumbersTable {
    QString title;
    QStringList heads;
    std::vector<QStringList> rows; ///< each as long as `heads`
};

class StudyNumbers {
    Q_DECLARE_TR_FUNCTIONS(StudyNumbers)
public:
    /// Of a gauge study the components of one of its quantities; of a type-1 study its figures, of linearity
    /// the bias at each reference, of attributes the share that each rater has right.
    [[nodiscard]] static StudyNumbersTable of(const StudyResult& result, std::size_t quantity = 0);
    /// "k: 6.2 kinds (95 %: 4.1 to 8.9)", one a quantity, and of all jointly.
    [[nodiscard]] static QStringList categories(const GaugeResult& result);
    /// What a gauge study says of this quantity beyond the verdict.
    [[nodiscard]] static QStringList remarks(const GaugeResult& result, std::size_t quantity);
};

struct StudyReport {
    KeptStudy study;
    StudyResult result;
    LetterheadSource letterhead;
    QString operatorName; ///< who asks for it
    QDateTime made;
};

/// Who, when, on which gripper, the verdict, and its numbers and charts: of a gauge study for each quantity.
/// Written whole or not at all. On any thread. FileUnwritable, FileUnreadable (the logo).
[[nodiscard]] Expected<void> writeStudyReport(const StudyReport& report, const QString& file);
/// What is in it, for a look beforehand.
[[nodiscard]] QString studyReportHtml(const StudyReport& report, const Letterhead& letterhead = {});

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
