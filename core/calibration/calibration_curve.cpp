// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_curve.h"

#include "core/base/words.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <set>

namespace gripscope {

namespace {

/// The root in [low, high], where the values at the ends differ in sign.
long double bisect(std::span<const long double> coefficients, long double low, long double high)
{
    const bool rising = polynomialValue(coefficients, low) < 0;
    for (;;) {
        const long double middle = low + (high - low) / 2;
        if (!(middle > low && middle < high))
            return middle;
        if ((polynomialValue(coefficients, middle) < 0) == rising)
            low = middle;
        else
            high = middle;
    }
}

using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

Error unusable(const Finding& found, const Finding& expected)
{
    return {ErrorCode::BadInput, {Words::say("calibration points"), found, expected}};
}

std::optional<Error> problemOf(const std::vector<CalibrationPoint>& points, int degree)
{
    if (degree < 1 || degree > highestCalibrationDegree)
        return unusable(Words::say("found degree %1").arg(degree),
                        Words::say("expected a degree from 1 to %1").arg(highestCalibrationDegree));
    std::set<double> loads;
    for (const CalibrationPoint& point : points) {
        if (!std::isfinite(point.load) || !std::isfinite(point.reading))
            return unusable(Words::say("found a number that is not finite"),
                            Words::say("expected finite loads and readings"));
        loads.insert(point.load);
    }
    if (static_cast<int>(points.size()) < degree + 2 || static_cast<int>(loads.size()) < degree + 1)
        return unusable(
            Words::say("found %1 points at %2 different loads").arg(points.size()).arg(loads.size()),
            Words::say("degree %1 needs at least %2 points at %3 loads")
                .arg(degree)
                .arg(degree + 2)
                .arg(degree + 1));
    if (!std::isfinite(*loads.rbegin() - *loads.begin()))
        return unusable(Words::say("found loads from %1 to %2").arg(*loads.begin()).arg(*loads.rbegin()),
                        Words::say("expected a range that is a number"));
    return std::nullopt;
}

/// Column i holds the coefficients of the i-th Chebyshev polynomial.
Matrix chebyshevPolynomials(Eigen::Index count)
{
    Matrix all = Matrix::Zero(count, count);
    all(0, 0) = 1;
    all(1, 1) = 1;
    for (Eigen::Index i = 2; i < count; ++i) {
        all.col(i).tail(count - 1) = 2 * all.col(i - 1).head(count - 1);
        all.col(i) -= all.col(i - 2);
    }
    return all;
}

/// Row i takes the coefficients of powers of z = (x - center) / half to that of x^i.
Matrix toUnscaledPowers(Eigen::Index count, long double center, long double half)
{
    // Powers of z as polynomials in x, one column each: the one before times (x - center) / half.
    Matrix all = Matrix::Zero(count, count);
    all(0, 0) = 1;
    for (Eigen::Index i = 1; i < count; ++i) {
        all.col(i).tail(count - 1) = all.col(i - 1).head(count - 1) / half;
        all.col(i) -= all.col(i - 1) * (center / half);
    }
    return all;
}

} // namespace

long double polynomialValue(std::span<const long double> coefficients, long double x)
{
    long double value = 0;
    for (std::size_t i = coefficients.size(); i-- > 0;)
        value = value * x + coefficients[i];
    return value;
}

std::vector<long double> polynomialDerivative(std::span<const long double> coefficients)
{
    std::vector<long double> derivative;
    derivative.reserve(coefficients.size());
    for (std::size_t i = 1; i < coefficients.size(); ++i)
        derivative.push_back(static_cast<long double>(i) * coefficients[i]);
    return derivative;
}

std::vector<long double> polynomialRoots(std::span<const long double> coefficients, long double from,
                                         long double to)
{
    std::vector<long double> roots;
    if (coefficients.size() < 2)
        return roots;
    std::vector<long double> bounds{from};
    for (const long double turn : polynomialRoots(polynomialDerivative(coefficients), from, to))
        bounds.push_back(turn);
    bounds.push_back(to);
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
        const long double first = polynomialValue(coefficients, bounds[i]);
        const long double last = polynomialValue(coefficients, bounds[i + 1]);
        if (first == 0 && (roots.empty() || roots.back() != bounds[i]))
            roots.push_back(bounds[i]);
        if (std::signbit(first) != std::signbit(last) && first != 0 && last != 0)
            roots.push_back(bisect(coefficients, bounds[i], bounds[i + 1]));
    }
    if (to > from && polynomialValue(coefficients, to) == 0)
        roots.push_back(to);
    return roots;
}

Expected<CalibrationCurve> CalibrationCurve::fit(const std::vector<CalibrationPoint>& points, int degree)
{
    RETURN_IF_ERROR(problemOf(points, degree));
    const auto [least, largest] = std::minmax_element(
        points.begin(), points.end(),
        [](const CalibrationPoint& a, const CalibrationPoint& b) { return a.load < b.load; });
    CalibrationCurve curve;
    curve.m_center = least->load + (largest->load - least->load) / 2;
    curve.m_halfRange = (largest->load - least->load) / 2;
    const auto count = static_cast<Eigen::Index>(points.size());
    const Eigen::Index unknowns = degree + 1;
    const Matrix chebyshev = chebyshevPolynomials(unknowns);
    Matrix columns(count, unknowns);
    Vector readings(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const CalibrationPoint& point = points[static_cast<std::size_t>(i)];
        const long double z = curve.scaled(point.load);
        for (Eigen::Index j = 0; j < unknowns; ++j)
            columns(i, j) = polynomialValue({chebyshev.col(j).data(), static_cast<std::size_t>(unknowns)}, z);
        readings(i) = point.reading;
    }
    const Eigen::HouseholderQR<Matrix> qr(columns);
    const Vector solution = qr.solve(readings);
    const Vector powers = chebyshev * solution;
    curve.m_powers.assign(powers.begin(), powers.end());
    curve.m_degreesOfFreedom = static_cast<int>(count - unknowns);
    const long double variance = (readings - columns * solution).squaredNorm() / curve.m_degreesOfFreedom;
    curve.m_residualDeviation = static_cast<double>(std::sqrt(variance));
    const Matrix inverse = qr.matrixQR().topRows(unknowns).triangularView<Eigen::Upper>().solve(
        Matrix::Identity(unknowns, unknowns));
    const Matrix root = chebyshev * inverse;
    curve.m_covariance = variance * (root * root.transpose());
    if (!curve.coefficients().allFinite() || !curve.standardDeviations().allFinite())
        return tl::unexpected<Error>(
            unusable(Words::say("the numbers are too large or too small"), Words::say("choose other units")));
    constexpr long double inside = 1 - 1e-9L; // a curve may be level at its very end
    const std::vector<long double> turns =
        polynomialRoots(polynomialDerivative(curve.m_powers), -inside, inside);
    if (!turns.empty() || curve.readingAt(curve.leastLoad()) == curve.readingAt(curve.largestLoad()))
        return tl::unexpected<Error>(unusable(
            Words::say("the curve does not only rise or only fall between the least and the largest load"),
            Words::say("a reading would belong to two loads: choose a lower degree or look at the points")));
    return curve;
}

long double CalibrationCurve::scaled(double load) const
{
    return (static_cast<long double>(load) - m_center) / m_halfRange;
}

CalibrationCurve::Vector CalibrationCurve::powersOf(long double z) const
{
    Vector powers(static_cast<Eigen::Index>(m_powers.size()));
    long double power = 1;
    for (long double& value : powers) {
        value = power;
        power *= z;
    }
    return powers;
}

Eigen::VectorXd CalibrationCurve::coefficients() const
{
    const auto count = static_cast<Eigen::Index>(m_powers.size());
    const Vector unscaled =
        toUnscaledPowers(count, m_center, m_halfRange) * Eigen::Map<const Vector>(m_powers.data(), count);
    return unscaled.cast<double>();
}

Eigen::VectorXd CalibrationCurve::standardDeviations() const
{
    const Matrix change = toUnscaledPowers(static_cast<Eigen::Index>(m_powers.size()), m_center, m_halfRange);
    const Vector variances = (change * m_covariance * change.transpose()).diagonal();
    return variances.cwiseMax(0.0L).cwiseSqrt().cast<double>();
}

double CalibrationCurve::readingAt(double load) const
{
    return static_cast<double>(polynomialValue(m_powers, scaled(load)));
}

double CalibrationCurve::curveUncertaintyAt(double load) const
{
    const Vector powers = powersOf(scaled(load));
    return static_cast<double>(std::sqrt(std::max(powers.dot(m_covariance * powers), 0.0L)));
}

std::optional<LoadEstimate> CalibrationCurve::loadAt(double reading) const
{
    if (!std::isfinite(reading))
        return std::nullopt;
    std::vector<long double> shifted = m_powers;
    shifted[0] -= reading;
    // A reading that was rounded may lie beyond the end by its last digit.
    constexpr long double end = 1 + 1e-12L;
    const std::vector<long double> roots = polynomialRoots(shifted, -end, end);
    if (roots.empty())
        return std::nullopt;
    const long double root = std::clamp(roots.front(), -1.0L, 1.0L);
    LoadEstimate found;
    found.load = static_cast<double>(m_center + root * m_halfRange);
    const auto slope =
        static_cast<double>(polynomialValue(polynomialDerivative(m_powers), root) / m_halfRange);
    if (slope == 0)
        return std::nullopt;
    found.standardUncertainty =
        std::hypot(m_residualDeviation, curveUncertaintyAt(found.load)) / std::abs(slope);
    return found;
}

} // namespace gripscope
