// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/words.h"
#include "core/identification/uncertainty/budget_lines.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Those beyond hold 3 % of a rounding error's variance.
constexpr int mostHarmonics = 20;
/// A first harmonic that is weaker than this share of its variance is hidden by the noise.
constexpr double hiddenHarmonic = 1e-3;

/// What each harmonic of the rounding error has of variance, and how the noise beside a step is.
struct RoundingHarmonics {
    double noise = 0; ///< in steps
    std::vector<double> sizes;
};

RoundingHarmonics harmonicsOf(const Estimate& estimate, double step)
{
    RoundingHarmonics found;
    const double variance = estimate.residuals.sse / std::max(estimate.residuals.degreesOfFreedom, 1.0);
    found.noise = std::sqrt(std::max(variance - step * step / 12, 0.0)) / step;
    const auto hidden = [&](double h) {
        return std::exp(-std::pow(2 * std::numbers::pi * h * found.noise, 2));
    };
    for (int h = 1; h <= mostHarmonics && hidden(h) > hiddenHarmonic; ++h)
        found.sizes.push_back(hidden(h) * std::pow(step / (std::numbers::pi * h), 2) / 2);
    return found;
}

/// sum_h v_h (|sum_t A_t exp(2 pi i h y_t / q)|^2 - sum_t A_t A_t'), y at the samples that the rows of A are
/// of.
template <typename Samples>
Eigen::MatrixXd followingTheMotion(const Eigen::MatrixXd& influence, const Samples& sampleOf,
                                   const std::vector<double>& simulated, double step,
                                   const std::vector<double>& sizes)
{
    using Sum = Eigen::VectorXcd;
    std::vector<Sum> sums(sizes.size(), Sum::Zero(influence.cols()));
    for (Eigen::Index r = 0; r < influence.rows(); ++r) {
        const double counts = simulated[sampleOf(r)] / step;
        const auto turn = std::polar(1.0, 2 * std::numbers::pi * (counts - std::round(counts)));
        const Sum weight = influence.row(r).transpose().cast<Sum::Scalar>();
        std::complex<double> phase = 1;
        for (Sum& sum : sums) {
            phase *= turn;
            sum += phase * weight;
        }
    }
    const Eigen::MatrixXd white = influence.transpose() * influence;
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(influence.cols(), influence.cols());
    for (std::size_t i = 0; i < sums.size(); ++i)
        all += sizes[i] * ((sums[i] * sums[i].adjoint()).real() - white);
    return all;
}

/// Where next to no noise moves the counts, where a level lies within its count is not known, and the model
/// has followed the rounding: all samples of one count err alike, each count for itself,
///     q^2 / 12 sum_c (sum_{t at c} A_t)^2.
Eigen::VectorXd perCount(const Eigen::MatrixXd& influence, const std::vector<double>& simulated, double step,
                         double noise)
{
    constexpr double mostNoise = 0.25; // of a step
    Eigen::VectorXd variances = Eigen::VectorXd::Zero(influence.cols());
    if (noise > mostNoise)
        return variances;
    std::map<double, Eigen::VectorXd> sums;
    for (std::size_t i = 0; i < simulated.size(); ++i) {
        const auto [at, isNew] = sums.try_emplace(std::round((simulated[i] - simulated[0]) / step));
        if (isNew)
            at->second = Eigen::VectorXd::Zero(influence.cols());
        at->second += influence.row(static_cast<Eigen::Index>(i)).transpose();
    }
    for (const auto& [count, sum] : sums)
        variances += step * step / 12 * sum.cwiseAbs2();
    return variances;
}

} // namespace

Eigen::VectorXd roundingVariances(const Estimate& estimate, double step)
{
    const auto samples = static_cast<Eigen::Index>(estimate.simulated.size());
    if (!(step > 0) || !estimate.motion || samples == 0 || estimate.motion->influences.rows() != samples)
        return {};
    const RoundingHarmonics harmonics = harmonicsOf(estimate, step);
    if (harmonics.sizes.empty())
        return {};
    const auto sampleOf = [](Eigen::Index row) { return static_cast<std::size_t>(row); };
    const Eigen::MatrixXd covariance =
        followingTheMotion(estimate.motion->influences, sampleOf, estimate.simulated, step, harmonics.sizes);
    const Eigen::VectorXd variances = covariance.diagonal().cwiseMax(
        perCount(estimate.motion->influences, estimate.simulated, step, harmonics.noise));
    return variances.allFinite() ? variances : Eigen::VectorXd();
}

std::vector<BudgetLine> quantizationLines(const Estimate& estimate, const LinearizedRecord& record,
                                          double step)
{
    if (!(step > 0) || !record.usable() || estimate.simulated.size() != record.velocity.size())
        return {};
    const RoundingHarmonics harmonics = harmonicsOf(estimate, step);
    if (harmonics.sizes.empty())
        return {};
    const auto sampleOf = [&](Eigen::Index row) { return record.rows[static_cast<std::size_t>(row)]; };
    Eigen::Matrix3d relative =
        followingTheMotion(influences(record), sampleOf, estimate.simulated, step, harmonics.sizes);
    if (!relative.allFinite())
        return {};
    relative = positivePart(relative);
    if (!relative.allFinite() || !(relative.trace() > 0))
        return {};
    return {lineOf(u"quantization"_s,
                   Words::say("the position is counted in steps and its noise is %1 of one only: rounding "
                              "errors follow the motion")
                       .arg(harmonics.noise, 'g', 2),
                   EvaluationType::B, estimate.parameters->vector(), relative)};
}

} // namespace gripscope
