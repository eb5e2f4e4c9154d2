// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/gauge/gauge_study.h"

#include "core/base/words.h"
#include "core/quality/gauge/cell_means.h"
#include "core/quality/gauge/gauge_words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double largestValue = 1e150, leastSpread = 1e-150; // their squares are numbers still

/// What one value is studied with.
struct ValueTask {
    const GaugeLayout& layout;
    const SourceSums& sums; ///< of all values, before pooling
    Eigen::Index column;
    Eigen::VectorXd values;
    GaugeMethod method;
    const GaugeOptions& options;
};

std::vector<GaugeSource> pooledSources(const std::vector<VarianceRow>& table, const GaugeOptions& options)
{
    std::vector<GaugeSource> pooled;
    for (const VarianceRow& row : table)
        if (options.pooling && row.p && *row.p > options.pooledAbove &&
            (row.source == GaugeSource::PartOperator || row.source == GaugeSource::PartStation))
            pooled.push_back(row.source);
    return pooled;
}

/// Sources with their variances.
struct Estimates {
    std::vector<GaugeSource> sources;
    Eigen::VectorXd variances;
};

Expected<Estimates> estimateVariances(const ValueTask& task, GaugeValue& value)
{
    GaugeLayout layout = task.layout;
    for (const GaugeSource source : value.pooled)
        layout = layout.without(source);
    Expected<SourceSums> pooled;
    const SourceSums* sums = &task.sums;
    Eigen::Index column = task.column;
    if (!value.pooled.empty()) {
        pooled = sourceSums(layout, task.values);
        if (!pooled)
            return tl::make_unexpected(pooled.error());
        sums = &*pooled;
        column = 0;
        value.pooledTable = varianceTable(*sums);
    }
    if (task.method != GaugeMethod::Reml)
        return Estimates{sums->sources, sums->momentVariances(column)};
    const RestrictedLikelihoodResult found = restrictedLikelihood(layout, task.values);
    value.converged = found.converged;
    for (std::size_t l = 0; l < found.boundary.size(); ++l)
        if (found.boundary[l])
            value.atBoundary.push_back(sums->sources[l]);
    return Estimates{sums->sources, found.variances};
}

VarianceComponent component(GaugeComponent name, double estimate, double taken, VarianceInterval interval)
{
    VarianceComponent one;
    one.component = name;
    one.estimate = estimate;
    one.taken = taken;
    one.interval = interval;
    return one;
}

void addComponents(const Estimates& found, const GaugeIntervals& intervals,
                   const std::vector<GaugeSource>& sources, GaugeValue& value)
{
    double part = 0, reproducibility = 0, repeatability = 0;
    const bool others = sources.size() > 2;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const auto at = std::ranges::find(found.sources, sources[s]);
        const double estimate = at == found.sources.end() ? 0 : found.variances[at - found.sources.begin()];
        const double taken = std::max(0.0, estimate);
        (sources[s] == GaugeSource::Part            ? part
         : sources[s] == GaugeSource::Repeatability ? repeatability
                                                    : reproducibility) += taken;
        value.components.push_back(component(componentOf(sources[s]), estimate, taken, intervals.sources[s]));
    }
    const double gauge = reproducibility + repeatability, total = gauge + part;
    if (others)
        value.components.push_back(component(GaugeComponent::Reproducibility, reproducibility,
                                             reproducibility, intervals.reproducibility));
    value.components.push_back(component(GaugeComponent::Gauge, gauge, gauge, intervals.gauge));
    value.components.push_back(component(GaugeComponent::Total, total, total, intervals.total));
    std::ranges::sort(value.components, {}, &VarianceComponent::component);
    if (gauge > 0)
        value.distinctCategories = std::sqrt(2 * part / gauge);
    value.distinctCategoriesInterval = intervals.distinctCategories;
}

std::optional<double> toleranceOf(const GaugeOptions& options, std::size_t value)
{
    if (options.tolerances.empty())
        return std::nullopt;
    return options.tolerances[std::min(value, options.tolerances.size() - 1)];
}

void addShares(double studyVariation, std::optional<double> tolerance, GaugeValue& value)
{
    const double total = value.components.back().taken;
    for (VarianceComponent& one : value.components) {
        const double share = total > 0 ? one.taken / total : 0;
        one.percentContribution = 100 * share;
        one.percentStudyVariation = 100 * std::sqrt(share);
        if (tolerance)
            one.percentTolerance = 100 * studyVariation * std::sqrt(one.taken) / *tolerance;
    }
}

GaugeIntervals intervalsOf(const ValueTask& task)
{
    const SourceSums& sums = task.sums;
    Eigen::VectorXd degrees = sums.degreesOfFreedom;
    if (!sums.kernels.empty())
        degrees = sums.effectiveDegrees(sums.momentVariances(task.column).cwiseMax(0));
    return pivotalIntervals(sums, pivotalFactors(degrees, task.options.intervals), task.column,
                            task.options.intervals.coverage);
}

Expected<GaugeValue> studyValue(const ValueTask& task)
{
    GaugeValue value;
    value.mean = task.sums.mean[task.column];
    if (task.method != GaugeMethod::MeanRange) {
        value.table = varianceTable(task.sums, task.column);
        value.pooled = pooledSources(value.table, task.options);
    }
    ASSIGN_OR_RETURN(const Estimates found, estimateVariances(task, value));
    addComponents(found, intervalsOf(task), task.sums.sources, value);
    return value;
}

std::optional<Error> unusable(const GaugeMeasurements& measurements)
{
    for (Eigen::Index j = 0; j < measurements.values.cols(); ++j) {
        const auto column = measurements.values.col(j).array();
        const Finding place = Words::say("Column %1").arg(measurements.names[j]);
        if (!(column.abs().maxCoeff() <= largestValue))
            return Error{ErrorCode::BadInput,
                         {place, Words::say("values beyond 1e150"), Words::say("values in another unit")}};
        if (!(column.maxCoeff() > column.minCoeff()))
            return Error{ErrorCode::BadInput,
                         {place, Words::say("all values are equal"),
                          Words::say("values with more digits: finer than the parts differ")}};
        if (column.maxCoeff() - column.minCoeff() < leastSpread)
            return Error{ErrorCode::BadInput,
                         {place, Words::say("values that differ by less than 1e-150"),
                          Words::say("values in another unit")}};
    }
    return std::nullopt;
}

GaugeMethod usedMethod(const GaugeOptions& options, GaugeLayout& layout)
{
    if (options.method == GaugeMethod::Auto)
        return layout.balanced ? GaugeMethod::Anova : GaugeMethod::Reml;
    if (options.method == GaugeMethod::Anova && !layout.balanced) {
        layout.messages.push_back(Words::say("The method of moments serves balanced tables: REML was used "
                                             "in its place."));
        return GaugeMethod::Reml;
    }
    return options.method;
}

void addJoint(const SourceSums& sums, GaugeStudy& study)
{
    study.joint = jointGauge(sums);
    study.jointMessages = jointGaugeMessages(study);
}

} // namespace

GaugeComponent componentOf(GaugeSource source)
{
    switch (source) {
    case GaugeSource::Part:
        return GaugeComponent::Part;
    case GaugeSource::Operator:
        return GaugeComponent::Operator;
    case GaugeSource::Station:
        return GaugeComponent::Station;
    case GaugeSource::PartOperator:
        return GaugeComponent::PartOperator;
    case GaugeSource::PartStation:
        return GaugeComponent::PartStation;
    case GaugeSource::Repeatability:
        break;
    }
    return GaugeComponent::Repeatability;
}

QString toString(GaugeMethod method)
{
    switch (method) {
    case GaugeMethod::Anova:
        return u"anova"_s;
    case GaugeMethod::Reml:
        return u"reml"_s;
    case GaugeMethod::MeanRange:
        return u"range"_s;
    case GaugeMethod::Auto:
        break;
    }
    return u"auto"_s;
}

QString toString(GaugeComponent component)
{
    static const QStringList names{u"repeatability"_s, u"operator"_s,     u"part_operator"_s,
                                   u"station"_s,       u"part_station"_s, u"reproducibility"_s,
                                   u"gauge"_s,         u"part"_s,         u"total"_s};
    return names[int(component)];
}

const VarianceComponent* GaugeValue::find(GaugeComponent component) const
{
    const auto found = std::ranges::find(components, component, &VarianceComponent::component);
    return found == components.end() ? nullptr : &*found;
}

Expected<GaugeStudy> studyGauge(const GaugeMeasurements& measurements, const GaugeOptions& options)
{
    if (const std::optional<Error> problem = unusable(measurements))
        return tl::make_unexpected(*problem);
    ASSIGN_OR_RETURN(GaugeLayout layout, gaugeLayout(measurements.factors, options.design, options.inside));
    ASSIGN_OR_RETURN(const SourceSums sums, sourceSums(layout, measurements.values));
    GaugeStudy study;
    study.design = layout.design;
    study.balanced = layout.balanced;
    study.method = usedMethod(options, layout);
    study.rows = layout.rows();
    study.parts = layout.terms.front().cells;
    for (Eigen::Index j = 0; j < measurements.values.cols(); ++j) {
        const Eigen::VectorXd column = measurements.values.col(j);
        Expected<SourceSums> ranges;
        if (study.method == GaugeMethod::MeanRange) {
            ranges = rangeSums(layout, column);
            if (!ranges)
                return tl::make_unexpected(ranges.error());
        }
        const bool byRange = study.method == GaugeMethod::MeanRange;
        ASSIGN_OR_RETURN(GaugeValue value, studyValue({layout, byRange ? *ranges : sums, byRange ? 0 : j,
                                                       column, study.method, options}));
        value.name = measurements.names[j];
        value.mean += measurements.origins.size() > 0 ? measurements.origins[j] : 0;
        addShares(options.studyVariation, toleranceOf(options, std::size_t(j)), value);
        if (measurements.standardUncertainties.size() > 0) {
            ASSIGN_OR_RETURN(value.consistency,
                             repeatConsistency(layout, column, measurements.standardUncertainties.col(j)));
        }
        value.messages = gaugeMessages(value, layout, options);
        study.values.push_back(std::move(value));
    }
    if (measurements.values.cols() > 1 && study.method != GaugeMethod::MeanRange)
        addJoint(sums, study);
    return study;
}

} // namespace gripscope
