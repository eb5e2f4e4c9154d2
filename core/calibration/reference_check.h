// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"

#include <QDateTime>
#include <QString>

#include <array>
#include <optional>

namespace gripscope {

// The check of a gripper on an object whose m, b, k are known, a spring mostly: does the whole chain, from
// the sensors to the estimate, still find them?

/// One of m, b, k of a reference object as its owner vouches for it, in SI.
struct ReferenceQuantity {
    double value = 0;
    double standardUncertainty = 0;
    double tolerance = 0; ///< the largest error that may be found
    friend bool operator==(const ReferenceQuantity&, const ReferenceQuantity&) = default;
};

/// A reference object, and how a gripper is to be checked with it.
struct ReferenceObject {
    QString gripperSerial; ///< of the gripper that is checked with it
    QString name, certificate;
    std::array<std::optional<ReferenceQuantity>, 3> stated; ///< m, b, k; k always
    double bias_N = 20, peak_N = 10;
    int squeezes = 3;
    int intervalHours = 24; ///< a check holds so long; 0: no check is asked for
    QString operatorName;   ///< who stated it
    friend bool operator==(const ReferenceObject&, const ReferenceObject&) = default;
};

/// Why a reference object cannot be used, and what would do; empty when it can.
[[nodiscard]] Finding problemOf(const ReferenceObject& reference);

/// What was found of one of m, b, k, in SI.
struct MeasuredQuantity {
    double value = 0, standardUncertainty = 0;
    friend bool operator==(const MeasuredQuantity&, const MeasuredQuantity&) = default;
};
using MeasuredQuantities = std::array<std::optional<MeasuredQuantity>, 3>;

/// (measured - stated) / sqrt(U^2 + U_ref^2), U the expanded uncertainties with a factor of 2: the En number
/// (ISO 13528:2015, 9.7). Within -1 and 1 the difference is explained by what is uncertain. Zero where
/// nothing is uncertain and nothing differs; nothing where only the former holds.
[[nodiscard]] std::optional<double> enNumber(const MeasuredQuantity& measured,
                                             const ReferenceQuantity& stated);

enum class CheckVerdict { Passed, Failed, NotValid };
[[nodiscard]] QString toString(CheckVerdict verdict); ///< "passed", "failed", "not_valid"
[[nodiscard]] std::optional<CheckVerdict> checkVerdictFromString(const QString& text);

/// Failed: one of the stated quantities is off by more than its tolerance. Passed: none is, and each was
/// measured well enough to tell, its expanded uncertainty (factor 2) not above the tolerance. Else not valid.
/// The tolerance decides, not the En number: of checks of a gripper in order one in seven has an |En| above
/// 1 in m, b or k where uncertainties are stated right, and one that is off by less than anybody minds is no
/// reason to stop. (Simple acceptance with a stated measurement capability, JCGM 106:2012, 8.2 and 7.6.3.)
[[nodiscard]] CheckVerdict judgeCheck(const ReferenceObject& reference, const MeasuredQuantities& measured);

struct ReferenceObjectRecord : ReferenceObject {
    QString id;
    QDateTime created;
};

/// A check as it is kept.
struct ReferenceCheck {
    QString gripperSerial, referenceId;
    MeasuredQuantities measured; ///< empty where the squeezes were not valid
    CheckVerdict verdict = CheckVerdict::NotValid;
    QString obstacle; ///< why the squeezes were not valid; empty when they were
    int squeezes = 0;
    QString operatorName;
};

struct ReferenceCheckRecord : ReferenceCheck {
    QString id;
    QDateTime made;
    ReferenceObjectRecord reference; ///< as it was then
};

/// How a gripper stands: its reference object, and the newest check on it that passed or failed.
struct ReferenceStanding {
    ReferenceObjectRecord reference;
    std::optional<ReferenceCheckRecord> last;
};

enum class CheckStatus { NotAsked, Passed, Due, Failed };
[[nodiscard]] CheckStatus checkStatus(const std::optional<ReferenceStanding>& standing, const QDateTime& now);
/// Until when the last check holds; nothing where no check is asked for or none was made.
[[nodiscard]] std::optional<QDateTime> checkHoldsUntil(const ReferenceStanding& standing);

} // namespace gripscope
