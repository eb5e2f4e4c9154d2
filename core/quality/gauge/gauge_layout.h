// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/quality/table/study_table.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

enum class GaugeDesign {
    /// Nested where no part met more than one operator, or no operator more than one part, and where
    /// "operators" are runs; else crossed. A message says which, and how to say otherwise.
    Auto,
    Crossed, ///< every operator measures the same parts
    Nested,  ///< operators have parts of their own, or each part its own runs ("day/run/error")
};

/// Which of two nested factors is numbered anew inside the other. By labels: the one whose labels all stand
/// under one label of the other; where labels repeat both ways runs inside parts, parts inside persons, else
/// the one with fewer of them (20 days with runs "1" and "2" each), the parts where they are as many.
enum class NestedInside { ByLabels, Parts, Operators };

/// What the operators' column is called after: runs are counted anew within each part, persons have parts of
/// their own where a table is nested.
enum class OperatorsAre { Unknown, Persons, Runs };

/// What makes measurements differ.
enum class GaugeSource { Part, Operator, Station, PartOperator, PartStation, Repeatability };

/// "part", "operator", "station", "part_operator", "part_station", "repeatability": names in documents.
[[nodiscard]] QString toString(GaugeSource source);

/// Who measured what where, one entry a row. A station may as well be a gripper.
struct GaugeFactors {
    StudyLabels part;
    std::optional<StudyLabels> operators, station;
    OperatorsAre operatorsAre = OperatorsAre::Unknown;
};

/// A random effect of the model.
struct GaugeTerm {
    GaugeSource source = GaugeSource::Part;
    unsigned factors = 0;  ///< one bit a factor: a term contains those whose bits it has
    std::vector<int> cell; ///< one a row: which level of the effect
    int cells = 0;         ///< levels
};

/// The random model y = mean + sum over terms of effect(level) + error, and how the rows fill it.
struct GaugeLayout {
    GaugeDesign design = GaugeDesign::Crossed;
    bool operatorsInParts = false; ///< nested the other way round
    std::vector<GaugeTerm> terms;
    std::vector<int> cell;  ///< one a row: the combination of all factors
    std::vector<int> count; ///< rows in each combination
    bool balanced = false;  ///< every combination is there, each as often
    bool replicated = false;
    Findings messages; ///< what a person should know about it

    [[nodiscard]] Eigen::Index rows() const { return Eigen::Index(cell.size()); }
    [[nodiscard]] bool has(GaugeSource source) const;
    /// The same without this effect, which then counts as repeatability.
    [[nodiscard]] GaugeLayout without(GaugeSource source) const;
};

/// Terms: part, operator, station, part x operator (crossed), part x station; further interactions count as
/// repeatability. An interaction whose levels were measured once each cannot be told from repeatability and
/// is left out, which a message says. Factors with one level are left out in the same way.
/// Errors: BadInput for a single part, for parts that are one to one with operators, for a crossed design
/// without a part that two operators measured, and where nothing was measured twice.
[[nodiscard]] Expected<GaugeLayout> gaugeLayout(const GaugeFactors& factors,
                                                GaugeDesign design = GaugeDesign::Auto,
                                                NestedInside inside = NestedInside::ByLabels);

} // namespace gripscope
