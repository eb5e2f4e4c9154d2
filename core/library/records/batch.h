// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/inspection_record.h"

namespace gripscope {

/// The longest name and the largest number of parts a batch may have.
inline constexpr int longestBatchName = 60;
inline constexpr qint64 largestBatch = 1'000'000;

/// Parts to be inspected and counted together. It is whole when as many as `target` were as expected; parts
/// of another type, unknown ones and measurements that say nothing do not count towards it.
struct NewBatch {
    QString name; ///< or number, as the operator calls it
    qint64 target = 0;
    QString expectedType; ///< name; empty when nothing is expected
    QString operatorName;
};

struct BatchRecord : NewBatch {
    QString id;
    QDateTime begun;
    std::optional<QDateTime> ended;
    InspectionCounts counts;
    [[nodiscard]] bool whole() const { return counts.asExpected >= target; }
};

} // namespace gripscope
