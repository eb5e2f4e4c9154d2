// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/quality/study_result.h"

#include <QCoreApplication>

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

} // namespace gripscope
