// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"
#include "ui/format/fact.h"

#include <QCoreApplication>

#include <vector>

namespace gripscope {

/// The check on a reference object in words.
class ReferenceWords {
    Q_DECLARE_TR_FUNCTIONS(ReferenceWords)
public:
    static constexpr std::size_t quantities = 3;                  ///< m, b, k
    [[nodiscard]] static QString quantity(std::size_t parameter); ///< "Stiffness k"
    [[nodiscard]] static QString unit(std::size_t parameter);     ///< SI
    [[nodiscard]] static QString verdict(CheckVerdict verdict);   ///< "passed"
    /// "Passed. It holds until 22 Nov, 14:03.", "Due: ...", "Failed: ..."; says what follows for parts.
    [[nodiscard]] static QString status(const std::optional<ReferenceStanding>& standing,
                                        const QDateTime& now);
    /// For the status line: "spring check 3 h ago", "spring check due"; empty where none is asked for.
    [[nodiscard]] static QString brief(const std::optional<ReferenceStanding>& standing,
                                       const QDateTime& now);
    /// What is stated, and how the gripper is checked.
    [[nodiscard]] static std::vector<Fact> reference(const ReferenceObject& reference);
    /// "+0.3 %, En 0.2" of the stated value; "–" where there is none.
    [[nodiscard]] static QString error(const ReferenceCheckRecord& check, std::size_t parameter);
    /// The verdict in a sentence, and why.
    [[nodiscard]] static QString outcome(const ReferenceCheckRecord& check);
};

} // namespace gripscope
