// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/arx/arx.h"

#include "core/base/words.h"
#include "core/identification/model/lag_alignment.h"
#include "core/identification/noise/residual_tests.h"
#include "core/math/decompositions.h"
#include "core/math/fit.h"
#include "core/math/sequential_qr.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace gripscope {

namespace {

/// Above this condition number of the scaled columns nothing is left of the numbers' 16 digits.
constexpr double largestEquationCondition = 1e13;

/// Above this one-step fit, percent, the residuals are rounding errors, which are neither white nor noise.
constexpr double roundingFit = 100 * (1 - 1e-9);

constexpr const char* fitWarning =
    QT_TRANSLATE_NOOP("Words", "noise on the position biases m, b and k of an ARX model heavily while "
                               "its fit still looks good: compare oe");

/// The regression in scaled units, so that no square overflows: y / positionScale, u / forceScale.
struct Regression {
    std::vector<double> force, position;
    double forceScale = 1, positionScale = 1;
    int numeratorTerms = 1;
    bool constant = true;

    [[nodiscard]] Eigen::Index columns() const { return 2 + numeratorTerms + (constant ? 1 : 0); }
    [[nodiscard]] std::size_t rows() const { return force.size() < 2 ? 0 : force.size() - 2; }

    /// The samples from `first` on, as a column.
    [[nodiscard]] static Eigen::Map<const Eigen::VectorXd> column(const std::vector<double>& values,
                                                                  std::size_t first, Eigen::Index count)
    {
        return {values.data() + first, count};
    }
    /// Rows t, t + 1, ... of the regressors (y with the other sign), then the right-hand side in the last
    /// column.
    template <typename Rows>
    void fill(std::size_t t, Rows&& rows) const
    {
        const Eigen::Index count = rows.rows();
        rows.col(0) = column(position, t - 1, count);
        rows.col(1) = column(position, t - 2, count);
        rows.col(2) = column(force, t - 1, count);
        if (numeratorTerms == 2)
            rows.col(3) = column(force, t - 2, count);
        if (constant)
            rows.col(columns() - 1).setOnes();
        rows.col(rows.cols() - 1) = column(position, t, count);
    }
    [[nodiscard]] double predict(std::size_t t, double y1, double y2, const Eigen::VectorXd& c) const
    {
        double y = -c(0) * y1 - c(1) * y2 + c(2) * force[t - 1];
        if (numeratorTerms == 2)
            y += c(3) * force[t - 2];
        return constant ? y + c(columns() - 1) : y;
    }
};

/// Division by a power of two, which is exact as a product too unless its inverse is out of range.
std::vector<double> scaledDown(std::span<const double> values, double scale)
{
    std::vector<double> scaled(values.size());
    const auto count = static_cast<Eigen::Index>(values.size());
    const Eigen::Map<const Eigen::VectorXd> from(values.data(), count);
    Eigen::Map<Eigen::VectorXd> to(scaled.data(), count);
    const double factor = 1 / scale;
    if (std::isfinite(factor))
        to = from * factor;
    else
        to = from / scale;
    return scaled;
}

Regression makeRegression(const std::vector<double>& force, const std::vector<double>& position,
                          const ArxOptions& options)
{
    const LagAlignment lag(options.lag_s, options.sampleTime_s);
    const std::ptrdiff_t shift = lag.samples + (lag.rest >= 0.5 ? 1 : 0);
    const auto skip = static_cast<std::size_t>(std::abs(shift));
    Regression regression;
    regression.numeratorTerms = options.estimator == Estimator::Arx221 ? 2 : 1;
    regression.constant = options.freeOffset;
    if (skip >= force.size())
        return regression;
    const std::size_t count = force.size() - skip;
    const std::span<const double> u = std::span(force).subspan(shift > 0 ? skip : 0, count);
    const std::span<const double> y = std::span(position).subspan(shift < 0 ? skip : 0, count);
    regression.forceScale = powerOfTwoScale(u);
    regression.positionScale = powerOfTwoScale(y);
    regression.force = scaledDown(u, regression.forceScale);
    regression.position = scaledDown(y, regression.positionScale);
    if (options.estimator == Estimator::ArxMeanForce) {
        for (std::size_t t = count; t-- > 0;)
            regression.force[t] = (regression.force[t] + (t > 0 ? regression.force[t - 1] : 0)) / 2;
    }
    return regression;
}

/// Coefficients and (R'R)^-1 of the scaled regression; none when its columns are dependent.
struct Solution {
    Eigen::VectorXd coefficients;
    Eigen::MatrixXd inverse;
};

/// The inverse of a triangle, whose columns are scaled first; empty when its condition is too large. The
/// Frobenius norms bound the condition number from above, by a factor of at most the number of columns.
SmallMatrix invertTriangle(const SmallMatrix& triangle)
{
    SmallMatrix scaled = triangle;
    Eigen::Array<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, largestSmallMatrix> norms =
        triangle.colwise().norm();
    if (!norms.allFinite() || !(norms.minCoeff() > 0))
        return {};
    scaled.array().rowwise() /= norms;
    const Eigen::Index n = triangle.cols();
    SmallMatrix inverse = SmallMatrix::Zero(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        for (Eigen::Index i = j; i >= 0; --i) {
            const double right =
                (i == j ? 1.0 : 0.0) -
                scaled.row(i).segment(i + 1, j - i).dot(inverse.col(j).segment(i + 1, j - i));
            inverse(i, j) = right / scaled(i, i);
        }
    }
    if (!(scaled.norm() * inverse.norm() < largestEquationCondition))
        return {};
    return (inverse.array().colwise() / norms.transpose()).matrix();
}

Solution solve(const Regression& regression)
{
    const Eigen::Index n = regression.columns();
    SequentialQr qr(n + 1);
    for (std::size_t t = 2; t < regression.position.size();) {
        auto rows = qr.nextRows(static_cast<Eigen::Index>(regression.position.size() - t));
        regression.fill(t, rows);
        t += static_cast<std::size_t>(rows.rows());
    }
    const SmallMatrix triangle = qr.triangle();
    const SmallMatrix inverse = invertTriangle(triangle.topLeftCorner(n, n));
    Solution solution;
    if (inverse.size() == 0)
        return solution;
    solution.coefficients = inverse * triangle.col(n).head(n);
    solution.coefficients.head<2>() *= -1;
    solution.inverse = inverse * inverse.transpose();
    solution.inverse.topRows<2>() *= -1;
    solution.inverse.leftCols<2>() *= -1;
    return solution;
}

/// The test of the residuals on past force.
std::optional<double> inputIndependence(const Regression& regression)
{
    const Eigen::Index n = regression.columns();
    constexpr auto extra = static_cast<Eigen::Index>(inputLags.size());
    SequentialQr qr(n + extra + 1);
    for (std::size_t t = 2; t < regression.position.size();) {
        auto rows = qr.nextRows(static_cast<Eigen::Index>(regression.position.size() - t));
        regression.fill(t, rows);
        for (Eigen::Index i = 0; i < rows.rows(); ++i)
            rows.row(i).segment<extra>(n) = laggedInputs(regression.force, t + static_cast<std::size_t>(i));
        t += static_cast<std::size_t>(rows.rows());
    }
    return extraColumnsP(qr.triangle(), extra, static_cast<double>(regression.rows()));
}

ArxCoefficients inChannelUnits(const Regression& regression, const Eigen::VectorXd& c)
{
    const double gain = regression.positionScale / regression.forceScale;
    ArxCoefficients out;
    out.a1 = c(0);
    out.a2 = c(1);
    out.b1 = c(2) * gain;
    if (regression.numeratorTerms == 2)
        out.b2 = c(3) * gain;
    if (regression.constant)
        out.constant = c(regression.columns() - 1) * regression.positionScale;
    return out;
}

bool isFinite(const ArxCoefficients& c)
{
    const std::array<double, 5> all{c.a1, c.a2, c.b1, c.b2.value_or(0), c.constant.value_or(0)};
    return allFinite(all);
}

/// One-step prediction and its residuals, free run from the measured y[0], y[1], and both fits.
void describeModel(const Regression& regression, const Eigen::VectorXd& c, Estimate& estimate)
{
    const std::vector<double>& y = regression.position;
    std::vector<double> predicted(y.size());
    std::vector<double> simulated(y.begin(), y.begin() + 2);
    simulated.resize(y.size());
    double sse = 0;
    for (std::size_t t = 2; t < y.size(); ++t) {
        predicted[t] = regression.predict(t, y[t - 1], y[t - 2], c);
        simulated[t] = regression.predict(t, simulated[t - 1], simulated[t - 2], c);
        const double e = y[t] - predicted[t];
        sse += e * e;
        estimate.residual.push_back(e * regression.positionScale);
    }
    const std::span<const double> measured = std::span(y).subspan(2);
    estimate.fit.predictionPercent = fitPercent(measured, std::span<const double>(predicted).subspan(2));
    estimate.fit.simulationPercent = fitPercent(measured, std::span<const double>(simulated).subspan(2));
    estimate.residuals.sse = std::min(sse * regression.positionScale * regression.positionScale,
                                      std::numeric_limits<double>::max());
    estimate.residuals.degreesOfFreedom =
        static_cast<double>(regression.rows()) - static_cast<double>(regression.columns());
    if (estimate.fit.predictionPercent.value_or(0) < roundingFit)
        estimate.residuals.whitenessP = ljungBoxP(estimate.residual, 2);
    for (double& value : simulated)
        value *= regression.positionScale;
    if (allFinite(simulated))
        estimate.simulated = std::move(simulated);
}

/// m, b, k and their covariance from the coefficients' by the derivative of the mapping.
void mapToParameters(const Regression& regression, const Solution& solution, const ArxOptions& options,
                     Estimate& estimate)
{
    const bool byPoles = options.estimator == Estimator::Arx221;
    const double t = options.sampleTime_s;
    const ArxCoefficients& c = *estimate.coefficients;
    const double numerator = c.b1 + c.b2.value_or(0);
    estimate.parameters =
        byPoles ? poleMapping(c.a1, c.a2, numerator, t) : centralDifferenceMapping(c.a1, c.a2, numerator, t);
    if (!estimate.parameters) {
        estimate.status = EstimateStatus::NoPhysicalMapping;
        estimate.message = Words::say(
            "the coefficients belong to no object with m, b, k > 0; noise on the position does that");
        return;
    }
    estimate.status = EstimateStatus::Converged;
    estimate.message = Words::say(fitWarning);

    const double gain = regression.positionScale / regression.forceScale;
    Eigen::MatrixXd toCoefficients = Eigen::MatrixXd::Zero(3, regression.columns());
    toCoefficients(0, 0) = 1;
    toCoefficients(1, 1) = 1;
    toCoefficients.row(2).segment(2, regression.numeratorTerms).setConstant(gain);
    const Eigen::Matrix3d jacobian = byPoles ? poleJacobian(c.a1, c.a2, numerator, t)
                                             : centralDifferenceJacobian(c.a1, c.a2, numerator, t);
    const Eigen::MatrixXd chain = jacobian * toCoefficients;
    const double scaledSse = estimate.residuals.sse / regression.positionScale / regression.positionScale;
    const double variance = scaledSse / estimate.residuals.degreesOfFreedom;
    const Eigen::Matrix3d covariance = variance * (chain * solution.inverse * chain.transpose());
    if (covariance.allFinite())
        estimate.covariance = (covariance + covariance.transpose()) / 2;
}

} // namespace

std::optional<ArxCoefficients> arxCoefficients(const std::vector<double>& force,
                                               const std::vector<double>& position, const ArxOptions& options)
{
    const Regression regression = makeRegression(force, position, options);
    if (static_cast<Eigen::Index>(regression.rows()) <= regression.columns())
        return std::nullopt;
    const Solution solution = solve(regression);
    if (solution.coefficients.size() == 0)
        return std::nullopt;
    const ArxCoefficients coefficients = inChannelUnits(regression, solution.coefficients);
    return isFinite(coefficients) ? std::optional(coefficients) : std::nullopt;
}

Estimate estimateArx(const std::vector<double>& force, const std::vector<double>& position,
                     const ArxOptions& options)
{
    Estimate estimate;
    estimate.estimator = options.estimator;
    const Regression regression = makeRegression(force, position, options);
    if (static_cast<Eigen::Index>(regression.rows()) <= regression.columns()) {
        estimate.status = EstimateStatus::TooFewSamples;
        estimate.message =
            Words::say("there are fewer samples than the model has coefficients; record for longer");
        return estimate;
    }
    const Solution solution = solve(regression);
    if (solution.coefficients.size() == 0 || !solution.coefficients.allFinite()) {
        estimate.status = EstimateStatus::NotIdentifiable;
        estimate.message = Words::say(
            "force and position do not determine the coefficients; squeeze with a force that varies");
        return estimate;
    }
    estimate.coefficients = inChannelUnits(regression, solution.coefficients);
    if (!isFinite(*estimate.coefficients)) {
        estimate.coefficients.reset();
        estimate.status = EstimateStatus::NotIdentifiable;
        estimate.message = Words::say("the coefficients are outside the range of numbers");
        return estimate;
    }
    describeModel(regression, solution.coefficients, estimate);
    if (estimate.residuals.whitenessP)
        estimate.residuals.inputIndependenceP = inputIndependence(regression);
    mapToParameters(regression, solution, options, estimate);
    return estimate;
}

} // namespace gripscope
