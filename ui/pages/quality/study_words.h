// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/study_record.h"
#include "core/quality/plan/study_plan.h"
#include "ui/settings/values/setting.h"

#include <QCoreApplication>

namespace gripscope {

/// Kinds of study and how far one is, in words.
class StudyWords {
    Q_DECLARE_TR_FUNCTIONS(StudyWords)
public:
    [[nodiscard]] static QString name(StudyKind kind);   ///< "Gauge repeatability and reproducibility"
    [[nodiscard]] static QString answer(StudyKind kind); ///< the question that it answers, a sentence
    /// Where it is set after how many months such a study is due again.
    [[nodiscard]] static SettingKey<double> repeatMonths(StudyKind kind);
    /// Of one as the library has it: "unfinished: 37 of 90", "finished", "given up".
    [[nodiscard]] static QString state(const StudyRecord& study, std::size_t planned);
};

} // namespace gripscope
