// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/words.h"
#include "core/identification/uncertainty/budget_lines.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Those beyond hold 3 % of a rounding error's variance.
constexpr int mostHarmonics = 20;
/// A first harmonic that is weaker than this share of its variance is hidden by the noise.
constexpr double hiddenHarmonic = 1e-3;

/// |sum_t A_t exp(2 pi i h y_t / q)|^2 - sum_t A_t A_t' for h = 1, 2, ...
std::vector<Eigen::Matrix3d> followingTheMotion(const Eigen::MatrixXd& influence,
                                                const std::vector<std::size_t>& rows,
                                                const std::vector<double>& simulated, double step,
                                                std::size_t harmonics)
{
    using Sum = Eigen::Vector3cd;
    std::vector<Sum> sums(harmonics, Sum::Zero());
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const double counts = simulated[rows[r]] / step;
        const auto turn = std::polar(1.0, 2 * std::numbers::pi * (counts - std::round(counts)));
        const Sum weight = influence.row(static_cast<Eigen::Index>(r)).transpose().cast<Sum::Scalar>();
        std::complex<double> phase = 1;
        for (Sum& sum : sums) {
            phase *= turn;
            sum += phase * weight;
        }
    }
    const Eigen::Matrix3d white = influence.transpose() * influence;
    std::vector<Eigen::Matrix3d> out;
    out.reserve(sums.size());
    for (const Sum& sum : sums)
        out.emplace_back((sum * sum.adjoint()).real() - white);
    return out;
}

} // namespace

std::vector<BudgetLine> quantizationLines(const Estimate& estimate, const LinearizedRecord& record,
                                          double step)
{
    if (!(step > 0) || !record.usable() || estimate.simulated.size() != record.velocity.size())
        return {};
    const double variance = estimate.residuals.sse / std::max(estimate.residuals.degreesOfFreedom, 1.0);
    const double noise = std::sqrt(std::max(variance - step * step / 12, 0.0)) / step;
    const auto hidden = [&](double h) { return std::exp(-std::pow(2 * std::numbers::pi * h * noise, 2)); };
    std::vector<double> sizes;
    for (int h = 1; h <= mostHarmonics && hidden(h) > hiddenHarmonic; ++h)
        sizes.push_back(hidden(h) * std::pow(step / (std::numbers::pi * h), 2) / 2);
    if (sizes.empty())
        return {};
    const std::vector<Eigen::Matrix3d> parts =
        followingTheMotion(influences(record), record.rows, estimate.simulated, step, sizes.size());
    Eigen::Matrix3d relative = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < sizes.size(); ++i)
        relative += sizes[i] * parts[i];
    if (!relative.allFinite())
        return {};
    relative = positivePart(relative);
    if (!relative.allFinite() || !(relative.trace() > 0))
        return {};
    return {lineOf(u"quantization"_s,
                   Words::say("the position is counted in steps and its noise is %1 of one only: rounding "
                              "errors follow the motion")
                       .arg(noise, 'g', 2),
                   EvaluationType::B, estimate.parameters->vector(), relative)};
}

} // namespace gripscope
