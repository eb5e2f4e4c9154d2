// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/gauge/pivotal_intervals.h"

#include "core/base/random_stream.h"
#include "core/math/distributions.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gripscope {

namespace {

VarianceInterval centralInterval(Eigen::VectorXd draws, double coverage)
{
    const auto bound = [&draws](double below) {
        const auto at = std::clamp<std::ptrdiff_t>(
            std::ptrdiff_t(std::llround(below * double(draws.size()) - 0.5)), 0, draws.size() - 1);
        std::nth_element(draws.data(), draws.data() + at, draws.data() + draws.size());
        return std::max(0.0, draws[at]);
    };
    VarianceInterval interval{bound((1 - coverage) / 2), bound((1 + coverage) / 2)};
    if (!std::isfinite(*interval.upper))
        interval.upper.reset();
    if (!std::isfinite(interval.lower))
        interval.lower = 0;
    return interval;
}

bool isReproducibility(GaugeSource source)
{
    return source != GaugeSource::Part && source != GaugeSource::Repeatability;
}

/// sqrt(2 part / gauge) of each draw; infinite where a draw has no gauge.
Eigen::VectorXd categoriesOf(const Eigen::VectorXd& part, const Eigen::VectorXd& gauge)
{
    Eigen::VectorXd categories(part.size());
    for (Eigen::Index i = 0; i < part.size(); ++i)
        categories[i] = part[i] <= 0    ? 0
                        : gauge[i] <= 0 ? std::numeric_limits<double>::infinity()
                                        : std::sqrt(2 * part[i] / gauge[i]);
    return categories;
}

} // namespace

Eigen::MatrixXd pivotalFactors(const Eigen::VectorXd& degreesOfFreedom, const PivotalOptions& options)
{
    Eigen::MatrixXd factors(options.draws, degreesOfFreedom.size());
    for (Eigen::Index s = 0; s < factors.cols(); ++s) {
        const double degrees = degreesOfFreedom[s];
        RandomStream random(options.seed, std::uint64_t(s), 0x6A);
        for (Eigen::Index i = 0; i < factors.rows(); ++i)
            factors(i, s) = degrees / chiSquaredQuantile((double(i) + 0.5) / double(factors.rows()), degrees);
        for (Eigen::Index i = factors.rows() - 1; i > 0; --i)
            std::swap(factors(i, s), factors(Eigen::Index(random.uniform() * double(i + 1)), s));
    }
    return factors;
}

GaugeIntervals pivotalIntervals(const SourceSums& sums, const Eigen::MatrixXd& factors, Eigen::Index value,
                                double coverage)
{
    const Eigen::Index sources = Eigen::Index(sums.sources.size());
    Eigen::VectorXd squares(sources);
    for (Eigen::Index s = 0; s < sources; ++s)
        squares[s] = sums.products[std::size_t(s)](value, value);
    const Eigen::MatrixXd inverse = sums.coefficients.inverse();
    const Eigen::MatrixXd weights = (inverse * squares.asDiagonal()).transpose();
    const Eigen::MatrixXd variances = factors * weights; // draws x sources
    GaugeIntervals intervals;
    Eigen::VectorXd reproducibility = Eigen::VectorXd::Zero(factors.rows()), part = reproducibility;
    for (Eigen::Index l = 0; l < sources; ++l) {
        intervals.sources.push_back(centralInterval(variances.col(l), coverage));
        if (isReproducibility(sums.sources[std::size_t(l)]))
            reproducibility += variances.col(l);
        if (sums.sources[std::size_t(l)] == GaugeSource::Part)
            part = variances.col(l);
    }
    const Eigen::VectorXd gauge = reproducibility + variances.col(sources - 1);
    intervals.reproducibility = centralInterval(reproducibility, coverage);
    intervals.gauge = centralInterval(gauge, coverage);
    intervals.total = centralInterval(gauge + part, coverage);
    intervals.distinctCategories = centralInterval(categoriesOf(part, gauge), coverage);
    return intervals;
}

} // namespace gripscope
