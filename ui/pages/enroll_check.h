// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/enrollment_advice.h"

#include <QWidget>

class QLabel;
class QTableWidget;

namespace gripscope {

/// What the enrolled squeezes are called by models that do not know them: a row for each type, and under it
/// what that proves.
class EnrollCheck : public QWidget {
    Q_OBJECT
public:
    explicit EnrollCheck(QWidget* parent = nullptr);
    /// The row of `type` stands out.
    void show(const HeldOutConfusion& confusion, const QString& type);
    void clear();

private:
    void fillRow(const HeldOutConfusion& confusion, int row, bool strong);
    QTableWidget* m_table;
    QLabel* m_words;
};

/// What the review says besides the table: outliers, overlap, parts against grips; a sentence each.
[[nodiscard]] QStringList reviewSentences(const EnrollmentReview& review);

} // namespace gripscope
