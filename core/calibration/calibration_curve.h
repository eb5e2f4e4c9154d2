// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// What a sensor said under a load that was known: a reference weight, a gauge block.
struct CalibrationPoint {
    double load = 0, reading = 0;
};

inline constexpr int highestCalibrationDegree = 8;

/// A load that belongs to a reading.
struct LoadEstimate {
    double load = 0;
    double standardUncertainty = 0; ///< of the load; the scatter of one reading and the curve's own
};

/// reading(load) = sum_i c_i load^i by least squares, and its inverse: not a second fit but the one root
/// within the range that was calibrated, which makes there and back the same curve.
///
/// The loads are brought to [-1, 1], the columns are Chebyshev polynomials of them, solved by Householder QR
/// in extended precision, so that loads of millions with their squares cost no digits; then taken back to
/// powers of the load. Errors of the readings are taken for independent and alike, those of the loads for
/// none.
class CalibrationCurve {
public:
    /// At least one point more than coefficients, at more different loads than the degree, all finite; and a
    /// curve that rises or falls over the whole range, since otherwise two loads have one reading.
    /// Errors: BadInput with what is missing.
    [[nodiscard]] static Expected<CalibrationCurve> fit(const std::vector<CalibrationPoint>& points,
                                                        int degree);

    [[nodiscard]] int degree() const { return static_cast<int>(m_powers.size()) - 1; }
    [[nodiscard]] Eigen::VectorXd coefficients() const;       ///< c0, c1, ... of powers of the load
    [[nodiscard]] Eigen::VectorXd standardDeviations() const; ///< of the coefficients
    /// Of powers of (load - centre of the range) / half the range: what keeps its digits.
    [[nodiscard]] std::vector<double> scaledCoefficients() const
    {
        return {m_powers.begin(), m_powers.end()};
    }
    /// sqrt(SSE / (points - degree - 1)), in units of the reading.
    [[nodiscard]] double residualDeviation() const { return m_residualDeviation; }
    [[nodiscard]] int degreesOfFreedom() const { return m_degreesOfFreedom; }
    [[nodiscard]] double leastLoad() const { return m_center - m_halfRange; }
    [[nodiscard]] double largestLoad() const { return m_center + m_halfRange; }

    [[nodiscard]] double readingAt(double load) const;
    /// Standard uncertainty of the curve itself there.
    [[nodiscard]] double curveUncertaintyAt(double load) const;
    /// Nothing for a reading outside those of the range.
    [[nodiscard]] std::optional<LoadEstimate> loadAt(double reading) const;

private:
    using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
    using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

    [[nodiscard]] long double scaled(double load) const;
    [[nodiscard]] Vector powersOf(long double z) const;

    double m_center = 0, m_halfRange = 1;
    std::vector<long double> m_powers; ///< of the scaled load z = (load - center) / half range
    Matrix m_covariance;               ///< of m_powers
    double m_residualDeviation = 0;
    int m_degreesOfFreedom = 0;
};

// Polynomials as coefficients of ascending powers, in extended precision: calibration points may lie far from
// zero and close together, and ten digits of what comes out must be right.

[[nodiscard]] long double polynomialValue(std::span<const long double> coefficients, long double x);
[[nodiscard]] std::vector<long double> polynomialDerivative(std::span<const long double> coefficients);

/// The real roots within [from, to], ascending: between two neighbouring roots of the derivative a polynomial
/// is monotonic, so that bisection finds the one root there may be. A root that only touches zero is found
/// where rounding lets it reach zero. The zero polynomial has none here.
[[nodiscard]] std::vector<long double> polynomialRoots(std::span<const long double> coefficients,
                                                       long double from, long double to);

} // namespace gripscope
