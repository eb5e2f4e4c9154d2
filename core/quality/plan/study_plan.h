// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QStringList>

#include <cstdint>
#include <optional>
#include <vector>

namespace gripscope {

enum class StudyKind {
    Gauge,      ///< repeatability and reproducibility: parts x operators x trials
    TypeOne,    ///< one part, again and again, against its reference value
    Linearity,  ///< parts with reference values over the range, each some times
    Attributes, ///< raters who call parts by a name, each some times
    Transfer    ///< parts of types that were enrolled on another gripper, each some times: its parts are the
                ///< types
};
/// "gauge", "type1", "linearity", "attributes", "transfer": as the command line calls them, and as they are
/// stored.
[[nodiscard]] QString toString(StudyKind kind);
[[nodiscard]] std::optional<StudyKind> studyKindFromString(const QString& text);

/// How a plan goes on. Whatever it is, a part is squeezed once by an operator before it is squeezed by him
/// for the next trial, and the parts of one trial come in an order of their own, drawn at random: a person
/// who knows what comes next, or what came before, measures something else.
enum class PlanOrder {
    OperatorAfterOperator, ///< each operator does all trials before the next one: the usual practice
    TrialAfterTrial,       ///< each trial is done by all operators, in random order: a drift hits all alike
    Mixed                  ///< operators and parts of a trial all mixed: for two who work side by side
};
/// "operators", "trials", "mixed".
[[nodiscard]] QString toString(PlanOrder order);
[[nodiscard]] std::optional<PlanOrder> planOrderFromString(const QString& text);

/// What the reference values of a study are of.
enum class StudyQuantity { Mass, Damping, Stiffness };
[[nodiscard]] QString toString(StudyQuantity quantity); ///< "m", "b", "k"
[[nodiscard]] std::optional<StudyQuantity> studyQuantityFromString(const QString& text);

/// What a study is to be.
struct PlanDesign {
    StudyKind kind = StudyKind::Gauge;
    QStringList parts;           ///< as they are labelled
    QStringList operators = {};  ///< or raters; none: whoever is there
    QStringList stations = {};   ///< or grippers, one after the other; none: this one
    QStringList references = {}; ///< one a part, or none: numbers; of attributes the name that is right
    StudyQuantity quantity = StudyQuantity::Stiffness;
    int trials = 3;
    PlanOrder order = PlanOrder::OperatorAfterOperator;
    bool blind = true; ///< nobody sees what was measured before the study is finished
    std::uint64_t seed = 1;
    friend bool operator==(const PlanDesign&, const PlanDesign&) = default;
};

/// One squeeze of a plan, by places in the design's lists; 0 where a list is empty.
struct PlanRow {
    int part = 0, operators = 0, station = 0;
    int trial = 0; ///< from 0 on
    friend bool operator==(const PlanRow&, const PlanRow&) = default;
};

/// Squeezes in the order in which they are to be made.
struct StudyPlan {
    PlanDesign design;
    std::vector<PlanRow> rows;

    [[nodiscard]] QString part(std::size_t row) const;
    [[nodiscard]] QString operatorName(std::size_t row) const; ///< empty where there are none
    [[nodiscard]] QString station(std::size_t row) const;      ///< empty where there are none
    [[nodiscard]] QString reference(std::size_t row) const;    ///< empty where there are none
    friend bool operator==(const StudyPlan&, const StudyPlan&) = default;
};

/// More squeezes than this are nobody's study; and names no longer than this.
inline constexpr std::size_t mostPlanRows = 10'000;
inline constexpr qsizetype longestPlanLabel = 64;

/// "1" to "count", for parts without names of their own.
[[nodiscard]] QStringList numberedParts(int count);

/// What is wrong with a design: Usage. Labels are distinct, neither empty nor longer than longestPlanLabel. A
/// gauge study has two parts or more, and something that is measured twice; a type-1 study one part, one
/// operator, two trials or more and its reference; linearity two references or more; attributes two parts or
/// more, and two raters or two trials; a transfer two trials or more. References of type-1 and linearity
/// studies are finite numbers.
[[nodiscard]] std::optional<Error> designProblem(const PlanDesign& design);

/// The plan of a design: the same for the same design, on any machine. Each block (station, operator, trial)
/// has its permutation of the parts (Fisher and Yates) from a stream of its own. Errors as designProblem().
[[nodiscard]] Expected<StudyPlan> makePlan(const PlanDesign& design);

} // namespace gripscope
