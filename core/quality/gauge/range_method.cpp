// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/math/normal_spread.h"
#include "core/quality/gauge/source_sums.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr int mostInRange = 1000;

double spanOf(const Eigen::VectorXd& values)
{
    return values.maxCoeff() - values.minCoeff();
}

tl::unexpected<Error> rangeError(const Finding& reason)
{
    return failure(ErrorCode::Usage, {reason});
}

/// Means of the rows of each level.
Eigen::VectorXd meansOf(const GaugeTerm& term, const Eigen::VectorXd& values)
{
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(term.cells), count = sums;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        sums[term.cell[std::size_t(i)]] += values[i];
        count[term.cell[std::size_t(i)]] += 1;
    }
    return sums.cwiseQuotient(count);
}

double meanOfRanges(const GaugeLayout& layout, const Eigen::VectorXd& values)
{
    const Eigen::Index cells = Eigen::Index(layout.count.size());
    Eigen::VectorXd least = Eigen::VectorXd::Constant(cells, values.maxCoeff());
    Eigen::VectorXd most = Eigen::VectorXd::Constant(cells, values.minCoeff());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const int cell = layout.cell[std::size_t(i)];
        least[cell] = std::min(least[cell], values[i]);
        most[cell] = std::max(most[cell], values[i]);
    }
    return (most - least).mean();
}

void addRangeSource(SourceSums& sums, GaugeSource source, double range, const MeanRange& constants)
{
    const Eigen::Index at = Eigen::Index(sums.sources.size());
    sums.sources.push_back(source);
    sums.degreesOfFreedom[at] = constants.degreesOfFreedom;
    const double deviation = range / constants.d2Star;
    sums.products.push_back(
        Eigen::MatrixXd::Constant(1, 1, constants.degreesOfFreedom * deviation * deviation));
    sums.coefficients(at, at) = constants.degreesOfFreedom;
}

} // namespace

MeanRange meanRange(int n, int ranges)
{
    const RangeMoments of = rangeMoments(n);
    const double relative = of.d3 * of.d3 / (of.d2 * of.d2) / ranges;
    return {of.d2 * std::sqrt(1 + relative), equivalentDegrees(relative)};
}

Expected<SourceSums> rangeSums(const GaugeLayout& layout, const Eigen::VectorXd& values)
{
    if (layout.design != GaugeDesign::Crossed || !layout.balanced || layout.has(GaugeSource::Station))
        return rangeError(Words::say("The range method serves balanced tables of parts and operators "
                                     "alone, each operator measuring each part equally often. Use the "
                                     "analysis of variance or REML."));
    const int trials = layout.count.front();
    if (trials < 2)
        return rangeError(
            Words::say("The range method: nothing was measured twice, so there are no ranges of "
                       "trials. Repeat each measurement."));
    const GaugeTerm& part = layout.terms.front();
    if (part.cells > mostInRange || trials > mostInRange)
        return rangeError(Words::say("The range method: at most %1 parts and %1 trials; use the analysis of "
                                     "variance.")
                              .arg(mostInRange));
    const Eigen::VectorXd centred = values.array() - values[0];
    SourceSums sums;
    const bool operators = layout.has(GaugeSource::Operator);
    const Eigen::Index sources = operators ? 3 : 2, last = sources - 1;
    sums.degreesOfFreedom = Eigen::VectorXd::Zero(sources);
    sums.coefficients = Eigen::MatrixXd::Zero(sources, sources);
    addRangeSource(sums, GaugeSource::Part, spanOf(meansOf(part, centred)), meanRange(part.cells, 1));
    if (operators) {
        const GaugeTerm& term = layout.terms[1];
        if (term.cells > mostInRange)
            return rangeError(Words::say("The range method: too many operators; use the analysis of variance "
                                         "instead."));
        addRangeSource(sums, GaugeSource::Operator, spanOf(meansOf(term, centred)), meanRange(term.cells, 1));
        sums.coefficients(1, last) = sums.degreesOfFreedom[1] / (double(part.cells) * trials);
    }
    addRangeSource(sums, GaugeSource::Repeatability, meanOfRanges(layout, centred),
                   meanRange(trials, int(layout.count.size())));
    sums.mean = Eigen::VectorXd::Constant(1, values[0] + centred.mean());
    const double squares = (centred.array() - centred.mean()).square().sum();
    sums.total = Eigen::MatrixXd::Constant(1, 1, squares);
    return sums;
}

} // namespace gripscope
