// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/joint_gauge.h"
#include "core/quality/gauge/pivotal_intervals.h"
#include "core/quality/gauge/repeat_consistency.h"

#include <QStringList>

namespace gripscope {

enum class GaugeMethod {
    Auto,     ///< Anova where the table is balanced, else Reml
    Anova,    ///< method of moments; Reml where the table is not balanced, which is said
    Reml,     ///< restrictedLikelihood()
    MeanRange ///< rangeSums()
};

/// "anova", "reml" or "range"; Auto is "auto".
[[nodiscard]] QString toString(GaugeMethod method);

/// What is reported, in the order of reports.
enum class GaugeComponent {
    Repeatability, ///< the same part, operator and station again
    Operator,
    PartOperator,
    Station,
    PartStation,
    Reproducibility, ///< all that operators and stations do
    Gauge,           ///< repeatability and reproducibility
    Part,
    Total,
};

/// "repeatability", "operator", "part_operator", ...: names in documents.
[[nodiscard]] QString toString(GaugeComponent component);
/// What a single source is reported as.
[[nodiscard]] GaugeComponent componentOf(GaugeSource source);

struct GaugeOptions {
    GaugeDesign design = GaugeDesign::Auto;
    NestedInside inside = NestedInside::ByLabels;
    GaugeMethod method = GaugeMethod::Auto;
    /// Widths upper - lower in the values' units, above 0: none, one for all values, or one a value.
    std::vector<double> tolerances;
    double studyVariation = 6; ///< standard deviations that a study variation spans
    bool pooling = true;
    double pooledAbove = 0.25; ///< an interaction with a larger p counts as repeatability
    PivotalOptions intervals;
};

/// A variance and its shares.
struct VarianceComponent {
    GaugeComponent component = GaugeComponent::Total;
    double estimate = 0; ///< as estimated: by moments it may be negative
    double taken = 0;    ///< what sums and shares take: max(estimate, 0)
    VarianceInterval interval;
    double percentContribution = 0;   ///< 100 taken / total
    double percentStudyVariation = 0; ///< 100 sqrt(taken / total)
    std::optional<double>
        percentTolerance; ///< 100 studyVariation sqrt(taken) / tolerance, of one that is given
};

/// The study of one value.
struct GaugeValue {
    QString name;
    double mean = 0;
    std::vector<VarianceRow> table;       ///< before pooling; empty by ranges
    std::vector<VarianceRow> pooledTable; ///< empty where nothing was pooled
    std::vector<VarianceComponent> components;
    /// sqrt(2 part / gauge), which AIAG cuts to whole numbers with 1.41 for sqrt(2); here it is not cut. None
    /// where the gauge has no variance at all.
    std::optional<double> distinctCategories;
    VarianceInterval distinctCategoriesInterval;
    std::vector<GaugeSource> pooled;
    std::vector<GaugeSource> atBoundary; ///< by REML: 0, where it would be less
    bool converged = true;
    std::optional<RepeatConsistency> consistency;
    Findings messages; ///< the verdict first

    [[nodiscard]] const VarianceComponent* find(GaugeComponent component) const;
};

struct GaugeStudy {
    GaugeDesign design = GaugeDesign::Crossed;
    GaugeMethod method = GaugeMethod::Anova; ///< the one that was used
    bool balanced = false;
    Eigen::Index rows = 0, parts = 0;
    std::vector<GaugeValue> values;
    std::optional<JointGauge> joint; ///< of several values, not by ranges
    Findings jointMessages;
};

/// Values to study, a column each, a row each of the factors'.
struct GaugeMeasurements {
    GaugeFactors factors;
    QStringList names;
    Eigen::MatrixXd values;
    Eigen::VectorXd origins;               ///< what `values` are less, one a column; empty: 0
    Eigen::MatrixXd standardUncertainties; ///< of the same shape, or empty
};

/// Gauge repeatability and reproducibility (AIAG, Measurement Systems Analysis, 4th edition, chapter III;
/// Burdick, Borror, Montgomery 2005, Design and Analysis of Gauge R&R Studies). The model and what it assumes
/// is gaugeLayout()'s: independent normal random effects. An interaction is pooled into repeatability where
/// its F test says p > pooledAbove (Bancroft 1964); intervals are those of the model before pooling, which
/// does not take an interaction as absent because it was not seen, so that they keep their coverage.
/// Errors: BadInput as gaugeLayout() and sourceSums() have, for values beyond 1e150 or that differ by less
/// than 1e-150; Usage as rangeSums() has.
[[nodiscard]] Expected<GaugeStudy> studyGauge(const GaugeMeasurements& measurements,
                                              const GaugeOptions& options = {});

} // namespace gripscope
