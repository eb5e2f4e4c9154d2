// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/pivotal_intervals.h"

#include <QStringList>

class QJsonObject;

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

/// What repeats scatter beside what the squeezes state of themselves.
struct RepeatConsistency {
    double chiSquared = 0; ///< sum over cells of (y - weighted mean)^2 / u^2
    double degreesOfFreedom = 0;
    double above = 1, below = 1; ///< P(chi-squared larger), P(smaller) if the statements are true
    double ratio = 0;            ///< sqrt(chiSquared / degreesOfFreedom): Birge's ratio
    double statedDeviation = 0;  ///< root mean square of the standard uncertainties
};

/// Within each combination of part, operator and station the values differ by their own standard
/// uncertainties u alone if these are complete; then chiSquared is chi-squared (Birge 1932, Physical Review
/// 40; Cochran 1954, Biometrics 10). Assumes errors that are independent from squeeze to squeeze: what is
/// common to all (a sensor's calibration) belongs in u but does not scatter, so a ratio below 1 need not be
/// wrong. Nothing where nothing was repeated. Errors: BadInput for an uncertainty that is not above 0.
[[nodiscard]] Expected<std::optional<RepeatConsistency>>
repeatConsistency(const GaugeLayout& layout, const Eigen::VectorXd& values,
                  const Eigen::VectorXd& standardUncertainty);

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

/// One combination of the values in which parts and gauge are both uncorrelated with the other combinations.
struct JointDirection {
    double ratio = 0;        ///< lambda: variance of the parts over that of the gauge along it
    double kinds = 1;        ///< sqrt(1 + 2 lambda)
    Eigen::VectorXd weights; ///< of the values, scaled to gauge variance 1
};

/// Several values judged together.
struct JointGauge {
    Eigen::MatrixXd part, gauge;            ///< covariances, negative directions taken as 0
    std::vector<JointDirection> directions; ///< the most telling first
    double kinds = 1;                       ///< product over the directions
    bool partProjected = false;             ///< a direction of the parts' covariance was negative
};

/// How many kinds of part can be told apart in the space of all values:
///     kinds = product over i of sqrt(1 + 2 lambda_i) = sqrt(det(gauge + 2 part) / det(gauge)),
/// lambda_i the generalised eigenvalues of part v = lambda gauge v. For one value that is Wheeler's
/// discrimination ratio (Wheeler and Lyday 1989, Evaluating the Measurement Process), close to sqrt(2 lambda)
/// where that is large; each factor is at least 1, so that a value that tells nothing takes nothing away.
/// A volume that counts is what it is: of kinds spread evenly, not of corners that no part fills. The
/// covariances are the multivariate method of moments from `sums` (mean squares and products, as in MANOVA),
/// each taken to the nearest that is not negative, in the metric of repeatability (Amemiya 1985, The American
/// Statistician 39). Nothing is said where the gauge's covariance is singular: a value that never scatters,
/// or that others determine.
[[nodiscard]] std::optional<JointGauge> jointGauge(const SourceSums& sums);

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

/// The document of `study gauge`. A component whose variance was estimated below 0 says so and holds
/// "taken_as": 0, which its shares and all sums are of; an upper bound of null: there is none.
[[nodiscard]] QJsonObject gaugeJson(const GaugeStudy& study);

} // namespace gripscope
