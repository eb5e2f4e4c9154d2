// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/table/study_table.h"

namespace gripscope {

/// One verdict on a part; places in the lists of AttributeRatings.
struct Rating {
    int part = 0, rater = 0, verdict = 0;
};

/// Verdicts of raters on parts, in the order in which they were given; any number of each rater on each part.
struct AttributeRatings {
    QStringList parts, raters;
    QStringList classes; ///< of verdicts and of references; NotDecidable is a class like any other
    std::vector<Rating> ratings;
    std::vector<int> reference; ///< the class of each part; empty: none is known
};

/// Which columns of a table hold what.
struct RatingColumns {
    QString part;    ///< empty, with `raters`: each row is a part of its own
    QString rater;   ///< a verdict a row: who gave it
    QString verdict; ///< and which
    QStringList
        raters; ///< or in place of those two: a column a rater, verdicts in it, empty where none was given
    QString reference; ///< empty: none
};

/// More are a wrong column.
inline constexpr int mostRaters = 100, mostClasses = 1000;

/// BadInput as StudyTable::labels(), for a part with two references, and for more raters or classes than
/// anybody has. Usage for columns that do not go together.
[[nodiscard]] Expected<AttributeRatings> readRatings(const StudyTable& table, const RatingColumns& columns);

} // namespace gripscope
