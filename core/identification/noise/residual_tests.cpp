// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/noise/residual_tests.h"

#include "core/math/distributions.h"
#include "core/math/fit.h"
#include "core/math/least_squares.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr std::size_t largestLag = 20;
constexpr std::size_t inflationLags = 50;
/// Share of a column's norm below which what is left of it after the projection is rounding.
constexpr double projectionRounding = 1e-8;
/// With more residuals than this, what the parameters take out of the autocorrelations is far below their
/// scatter.
constexpr std::size_t largestCorrectedRecord = 20000;

/// Forty residuals a lag: with fewer the tail of Q is heavier than the chi-square's (with ten, 0.5 %
/// becomes 1.1 %).
std::size_t ljungBoxLags(std::size_t residuals)
{
    return std::clamp<std::size_t>(residuals / 40, std::min<std::size_t>(3, residuals / 5), largestLag);
}

/// r_k for k = 0..lags, freed of what the regression took out; empty when the residuals do not vary. Without
/// a regression the mean is taken out.
std::vector<double> autocorrelations(std::span<const double> residuals, std::size_t lags,
                                     const Eigen::MatrixXd& basis)
{
    const auto count = static_cast<Eigen::Index>(residuals.size());
    const double scale = powerOfTwoScale(residuals);
    Eigen::VectorXd e = Eigen::Map<const Eigen::VectorXd>(residuals.data(), count) / scale;
    const bool regression = basis.cols() == count && count > basis.rows();
    if (!regression)
        e.array() -= e.mean();
    const double power = e.squaredNorm();
    if (!(power > 0) || !std::isfinite(power))
        return {};
    const bool corrected = regression && residuals.size() <= largestCorrectedRecord;
    const double share =
        static_cast<double>(count - (regression ? basis.rows() : 0)) / static_cast<double>(count);
    std::vector<double> r;
    for (std::size_t lag = 0; lag <= lags; ++lag) {
        const Eigen::Index rest = count - static_cast<Eigen::Index>(lag);
        double value = e.head(rest).dot(e.tail(rest)) / power * (corrected ? share : 1);
        if (corrected) {
            // Columns stand side by side, so that both parts are one row of numbers.
            const Eigen::Index size = basis.rows() * rest;
            const Eigen::Map<const Eigen::VectorXd> later(basis.data() + basis.size() - size, size);
            value +=
                Eigen::Map<const Eigen::VectorXd>(basis.data(), size).dot(later) / static_cast<double>(count);
        }
        r.push_back(value);
    }
    return r;
}

} // namespace

std::optional<double> ljungBoxP(std::span<const double> residuals, int fittedLags,
                                const Eigen::MatrixXd& basis)
{
    const std::size_t tested = ljungBoxLags(residuals.size());
    const std::size_t lags = tested + static_cast<std::size_t>(std::max(fittedLags, 0));
    if (tested < 1 || lags + 5 > residuals.size())
        return std::nullopt;
    const std::vector<double> r = autocorrelations(residuals, lags, basis);
    if (r.empty())
        return std::nullopt;
    const auto count = static_cast<double>(residuals.size());
    double q = 0;
    for (std::size_t lag = 1; lag <= lags; ++lag)
        q += r[lag] * r[lag] / (count - static_cast<double>(lag));
    q *= count * (count + 2);
    return chiSquaredAbove(q, static_cast<double>(tested));
}

std::optional<double> noiseScore(std::span<const double> residuals, const Eigen::MatrixXd& basis,
                                 const std::vector<double>& shape)
{
    if (shape.size() < 2 || residuals.size() < 4 * shape.size())
        return std::nullopt;
    const std::vector<double> r = autocorrelations(residuals, shape.size() - 1, basis);
    if (r.empty())
        return std::nullopt;
    double sum = 0;
    double power = 0;
    for (std::size_t lag = 1; lag < shape.size(); ++lag) {
        sum += shape[lag] * r[lag];
        power += shape[lag] * shape[lag];
    }
    const double score = sum * std::sqrt(static_cast<double>(residuals.size()) / power);
    return std::isfinite(score) ? std::optional(score) : std::nullopt;
}

Eigen::MatrixXd pastInputs(std::span<const double> input, std::ptrdiff_t first, std::ptrdiff_t count)
{
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(inputLags.size()), count);
    const auto last = static_cast<std::ptrdiff_t>(input.size()) - 1;
    for (std::ptrdiff_t t = 0; t < count; ++t) {
        for (std::size_t i = 0; i < inputLags.size(); ++i) {
            const std::ptrdiff_t at = first + t - static_cast<std::ptrdiff_t>(inputLags[i]);
            rows(static_cast<Eigen::Index>(i), t) =
                input[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 0, last))];
        }
    }
    return rows;
}

Eigen::MatrixXd futureInputs(std::span<const double> input, std::ptrdiff_t first, std::ptrdiff_t count)
{
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(inputLeads.size()), count);
    const auto last = static_cast<std::ptrdiff_t>(input.size()) - 1;
    for (std::ptrdiff_t t = 0; t < count; ++t) {
        for (std::size_t i = 0; i < inputLeads.size(); ++i) {
            const std::ptrdiff_t at = first + t + static_cast<std::ptrdiff_t>(inputLeads[i]);
            rows(static_cast<Eigen::Index>(i), t) =
                input[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 0, last))];
        }
    }
    return rows;
}

std::optional<ExplainedTest> testExplained(double power, Eigen::Index count, const Eigen::VectorXd& fitted,
                                           const Eigen::VectorXd& explained)
{
    const Eigen::Index rank = explained.size();
    const auto free = static_cast<double>(count - fitted.size() - rank);
    if (rank < 1 || free < 1)
        return std::nullopt;
    const double square = explained.squaredNorm();
    const double rest = power - fitted.squaredNorm() - square;
    const double f = (square / static_cast<double>(rank)) / (rest / free);
    if (!(rest > 0) || !std::isfinite(f))
        return std::nullopt;
    return ExplainedTest{fisherAbove(f, static_cast<double>(rank), free), f};
}

std::optional<ExplainedTest> testExplained(const Eigen::RowVectorXd& residuals, const Eigen::MatrixXd& model,
                                           const Eigen::MatrixXd& extra)
{
    Eigen::VectorXd fitted;
    if (model.rows() > 0)
        fitted = model * residuals.transpose();
    return testExplained(residuals.squaredNorm(), residuals.size(), fitted, extra * residuals.transpose());
}

Eigen::RowVector<double, inputLags.size()> laggedInputs(std::span<const double> input, std::size_t t)
{
    Eigen::RowVector<double, inputLags.size()> row;
    for (std::size_t i = 0; i < inputLags.size(); ++i)
        row(static_cast<Eigen::Index>(i)) = input[t > inputLags[i] ? t - inputLags[i] : 0];
    return row;
}

std::optional<double> extraColumnsP(const Eigen::MatrixXd& triangle, Eigen::Index extraColumns, double rows)
{
    const Eigen::Index n = triangle.cols();
    const Eigen::Index model = n - 1 - extraColumns;
    // What the model leaves of the extra columns and of the right-hand side stands below its own rows.
    Eigen::MatrixXd left = triangle.block(model, model, n - model, extraColumns);
    const Eigen::VectorXd right = triangle.col(n - 1).tail(n - model);
    for (Eigen::Index i = 0; i < extraColumns; ++i) {
        const double norm = triangle.col(model + i).norm();
        left.col(i) /= norm > 0 ? norm : 1;
    }
    const PivotedSolution solved = solvePivoted(left, right, {.absolute = projectionRounding});
    const Eigen::Index rank = solved.rank;
    const double explained = solved.explained(0);
    const double rest = solved.rest(0);
    const double degreesOfFreedom = rows - static_cast<double>(model + rank);
    if (rank < 1 || degreesOfFreedom < 1 || !(rest > 0) || !std::isfinite(explained / rest))
        return std::nullopt;
    const double f = (explained / static_cast<double>(rank)) / (rest / degreesOfFreedom);
    return fisherAbove(f, static_cast<double>(rank), degreesOfFreedom);
}

std::optional<double> errorInflation(const Eigen::MatrixXd& sensitivities, std::span<const double> residuals)
{
    const Eigen::Index rows = sensitivities.rows();
    const std::size_t lags = std::min(inflationLags, residuals.size() / 10);
    if (lags < 1 || rows != static_cast<Eigen::Index>(residuals.size()))
        return std::nullopt;
    const std::vector<double> r = autocorrelations(residuals, lags, {});
    if (r.empty())
        return std::nullopt;
    const Eigen::MatrixXd information = sensitivities.transpose() * sensitivities;
    Eigen::MatrixXd spread = information;
    for (std::size_t lag = 1; lag <= lags; ++lag) {
        const auto shift = static_cast<Eigen::Index>(lag);
        const double taper = 1 - static_cast<double>(lag) / static_cast<double>(lags + 1);
        const Eigen::MatrixXd product =
            sensitivities.bottomRows(rows - shift).transpose() * sensitivities.topRows(rows - shift);
        spread += taper * r[lag] * (product + product.transpose());
    }
    const Eigen::MatrixXd inverse = information.inverse();
    const Eigen::VectorXd ratio =
        (inverse * spread * inverse).diagonal().cwiseQuotient(inverse.diagonal()).cwiseMax(0.0).cwiseSqrt();
    const double worst = ratio.maxCoeff();
    return std::isfinite(worst) ? std::optional(worst) : std::nullopt;
}

} // namespace gripscope
