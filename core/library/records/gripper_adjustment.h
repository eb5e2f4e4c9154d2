// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/type_shift.h"

#include <QDateTime>
#include <QString>
#include <QStringList>

#include <optional>

namespace gripscope {

/// That squeezes of a gripper are to be adjusted to types that were enrolled on another.
struct NewAdjustment {
    QString gripperSerial; ///< whose squeezes are adjusted
    QString gripperName;
    QStringList enrolledOn; ///< serial numbers of the grippers that the types are from, as far as known
    QStringList types;      ///< that were squeezed on both
    int squeezes = 0;       ///< on this gripper
    CommonShift error;      ///< of the logarithms: what this gripper finds less what the other does
    QString studyId;        ///< its squeezes; empty: not of this library
    QString operatorName, reason;
};

struct AdjustmentRecord {
    QString id;
    NewAdjustment adjustment;
    QDateTime accepted;
    QString station, program;
    qint64 libraryVersion = 0; ///< of the types that it was accepted with
    bool inForce = false;
    bool withdrawn = false; ///< by a person; else, where it is not in force, replaced
    QDateTime withdrawnAt = {};
    QString withdrawnBy = {}, withdrawnReason = {};
};

/// An adjustment in force, and what has changed since it was accepted.
struct AdjustmentStanding {
    AdjustmentRecord record;
    /// The newest calibration or measurement of the gripper's own channels after it: what was corrected since
    /// is corrected twice.
    std::optional<QDateTime> calibratedSince;
    QStringList ownTypes; ///< in use, and enrolled on this gripper itself
};

/// "mass +2.1 ± 0.3 %, ..." of what this gripper finds, against the other.
[[nodiscard]] Finding adjustmentInWords(const CommonShift& error);
/// What speaks against an adjustment, a sentence each; empty where nothing does.
[[nodiscard]] Findings adjustmentSignals(const AdjustmentStanding& standing);

} // namespace gripscope
