// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/quality/study_result.h"
#include "ui/reports/letterhead.h"

#include <QDateTime>

namespace gripscope {

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

} // namespace gripscope
