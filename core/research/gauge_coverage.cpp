// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/gauge_coverage.h"

#include "core/base/parallel_runs.h"
#include "core/base/random_stream.h"
#include "core/quality/gauge/pivotal_intervals.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Variances, the gauge's being 1.
struct CoverageTruth {
    double part = 1, operators = 0, interaction = 0, repeatability = 1;
    [[nodiscard]] std::array<double, coveredQuantities> quantities() const
    {
        const double gauge = operators + interaction + repeatability;
        return {
            repeatability, operators, interaction, part, gauge, gauge + part, std::sqrt(2 * part / gauge)};
    }
};

GaugeLayout simulatedLayout(const GaugeCoverageOptions& options)
{
    std::vector<std::array<int, 2>> rows;
    for (int p = 0; p < options.parts; ++p)
        for (int o = 0; o < options.operators; ++o)
            for (int t = 0; t < options.trials; ++t)
                rows.push_back({p, o});
    RandomStream random(options.seed, 0, 0x61);
    for (int i = 0; i < options.missing && rows.size() > 4; ++i)
        rows.erase(rows.begin() + std::ptrdiff_t(random.uniform() * double(rows.size())));
    GaugeFactors factors;
    factors.operators.emplace();
    for (int p = 0; p < options.parts; ++p)
        factors.part.names << QString::number(p);
    for (int o = 0; o < options.operators; ++o)
        factors.operators->names << QString::number(o);
    for (const auto& [p, o] : rows) {
        factors.part.index.push_back(p);
        factors.operators->index.push_back(o);
    }
    return gaugeLayout(factors, GaugeDesign::Crossed).value();
}

Eigen::VectorXd drawnTable(const GaugeLayout& layout, const CoverageTruth& truth, std::uint64_t seed)
{
    RandomStream random(seed, 0, 0x62);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(layout.rows());
    for (const GaugeTerm& term : layout.terms) {
        const double deviation = std::sqrt(term.source == GaugeSource::Part       ? truth.part
                                           : term.source == GaugeSource::Operator ? truth.operators
                                                                                  : truth.interaction);
        std::vector<double> effect(std::size_t(term.cells));
        for (double& one : effect)
            one = deviation * random.normal();
        for (Eigen::Index i = 0; i < values.size(); ++i)
            values[i] += effect[std::size_t(term.cell[std::size_t(i)])];
    }
    for (double& value : values)
        value += std::sqrt(truth.repeatability) * random.normal();
    return values;
}

/// Intervals in the order of CoveredQuantity.
std::array<VarianceInterval, coveredQuantities> statedIntervals(GaugeLayout layout,
                                                                const Eigen::VectorXd& values,
                                                                const PivotalOptions& options,
                                                                const Eigen::MatrixXd& balancedFactors)
{
    const SourceSums sums = sourceSums(layout, values).value();
    const bool balanced = sums.kernels.empty();
    const GaugeIntervals found = pivotalIntervals(
        sums, balanced ? balancedFactors
                       : pivotalFactors(sums.effectiveDegrees(sums.momentVariances().cwiseMax(0)), options));
    const auto of = [&](GaugeSource source) { return found.sources[std::size_t(sums.place(source))]; };
    return {of(GaugeSource::Repeatability),
            of(GaugeSource::Operator),
            of(GaugeSource::PartOperator),
            of(GaugeSource::Part),
            found.gauge,
            found.total,
            found.distinctCategories};
}

GaugeCoverageRow coverageRow(const GaugeCoverageOptions& options, const GaugeLayout& layout,
                             const Eigen::MatrixXd& factors, double ratio)
{
    CoverageTruth truth;
    truth.part = 1 / (ratio * ratio);
    truth.operators = options.operatorShare;
    truth.interaction = options.interactionShare;
    truth.repeatability = 1 - options.operatorShare - options.interactionShare;
    const std::array<double, coveredQuantities> quantities = truth.quantities();
    using Intervals = std::array<VarianceInterval, coveredQuantities>;
    std::vector<Intervals> stated(std::size_t(options.runs));
    PivotalOptions pivotal;
    pivotal.draws = options.draws;
    performRuns(options.runs, options.threads, options.progress, [&](std::int64_t run) {
        const std::uint64_t seed = runSeed(options.seed, u"gauge %1"_s.arg(ratio), std::uint64_t(run));
        stated[std::size_t(run)] = statedIntervals(layout, drawnTable(layout, truth, seed), pivotal, factors);
    });
    GaugeCoverageRow row;
    row.ratio = ratio;
    row.runs = options.runs;
    for (std::size_t q = 0; q < coveredQuantities; ++q) {
        int ended = 0;
        for (const Intervals& one : stated) {
            row.covered[q] +=
                one[q].lower <= quantities[q] && (!one[q].upper || quantities[q] <= *one[q].upper);
            ended += one[q].upper.has_value();
            row.meanWidth[q] += one[q].upper ? *one[q].upper - one[q].lower : 0;
        }
        row.meanWidth[q] /= std::max(ended, 1) * std::max(quantities[q], 1e-300);
    }
    return row;
}

} // namespace

std::vector<GaugeCoverageRow> studyGaugeCoverage(const GaugeCoverageOptions& options)
{
    const GaugeLayout layout = simulatedLayout(options);
    Eigen::MatrixXd factors;
    if (layout.balanced) {
        GaugeLayout copy = layout;
        CoverageTruth any;
        const SourceSums sums = sourceSums(copy, drawnTable(layout, any, options.seed)).value();
        PivotalOptions pivotal;
        pivotal.draws = options.draws;
        factors = pivotalFactors(sums.degreesOfFreedom, pivotal);
    }
    std::vector<GaugeCoverageRow> rows;
    for (const double ratio : options.ratios)
        rows.push_back(coverageRow(options, layout, factors, ratio));
    return rows;
}

} // namespace gripscope
