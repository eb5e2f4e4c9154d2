// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/distributions.h"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/non_central_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/policies/policy.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

using Policy = boost::math::policies::policy<
    boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
    boost::math::policies::evaluation_error<boost::math::policies::ignore_error>,
    boost::math::policies::promote_double<false>>;
using Normal = boost::math::normal_distribution<double, Policy>;
using Student = boost::math::students_t_distribution<double, Policy>;
using NonCentralStudent = boost::math::non_central_t_distribution<double, Policy>;
using ChiSquared = boost::math::chi_squared_distribution<double, Policy>;
using NonCentralChiSquared = boost::math::non_central_chi_squared_distribution<double, Policy>;
using Fisher = boost::math::fisher_f_distribution<double, Policy>;
using NonCentralFisher = boost::math::non_central_f_distribution<double, Policy>;
using Gamma = boost::math::gamma_distribution<double, Policy>;
using Beta = boost::math::beta_distribution<double, Policy>;

/// P(|z + d| <= r) in one and in three dimensions, `d` long. In three, the density of the length along d is
/// integrated by parts; where d is short, its difference is a hyperbolic sine.
double withinLine(double r, double d)
{
    return normalBelow(r - d) - normalBelow(-r - d);
}
double withinBall(double r, double d)
{
    constexpr double shortProduct = 1; // beyond it the difference keeps its digits, and no exp overflows
    const double difference = r * d < shortProduct
                                  ? 2 * normalDensity(r) * std::exp(-d * d / 2) * std::sinh(r * d)
                                  : normalDensity(r - d) - normalDensity(r + d);
    return std::max(0.0, withinLine(r, d) - difference / d);
}

} // namespace

double normalDensity(double x)
{
    return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
}

double normalBelow(double x)
{
    return std::erfc(-x / std::numbers::sqrt2) / 2;
}

double normalAbove(double x)
{
    return normalBelow(-x);
}

double normalQuantile(double below)
{
    return boost::math::quantile(Normal(), below);
}

double normalQuantileAbove(double above)
{
    return boost::math::quantile(boost::math::complement(Normal(), above));
}

double studentAbove(double t, double degreesOfFreedom)
{
    return boost::math::cdf(boost::math::complement(Student(degreesOfFreedom), t));
}

double studentQuantile(double below, double degreesOfFreedom)
{
    return boost::math::quantile(Student(degreesOfFreedom), below);
}

double nonCentralStudentBelow(double t, double degreesOfFreedom, double shift)
{
    return boost::math::cdf(NonCentralStudent(degreesOfFreedom, shift), t);
}

double nonCentralStudentQuantile(double below, double degreesOfFreedom, double shift)
{
    return boost::math::quantile(NonCentralStudent(degreesOfFreedom, shift), below);
}

double studentQuantileAbove(double above, double degreesOfFreedom)
{
    return boost::math::quantile(boost::math::complement(Student(degreesOfFreedom), above));
}

double chiSquaredBelow(double x, double degreesOfFreedom)
{
    return boost::math::cdf(ChiSquared(degreesOfFreedom), x);
}

double chiSquaredAbove(double x, double degreesOfFreedom)
{
    return boost::math::cdf(boost::math::complement(ChiSquared(degreesOfFreedom), x));
}

double chiSquaredQuantile(double below, double degreesOfFreedom)
{
    return boost::math::quantile(ChiSquared(degreesOfFreedom), below);
}

double chiSquaredQuantileAbove(double above, double degreesOfFreedom)
{
    return boost::math::quantile(boost::math::complement(ChiSquared(degreesOfFreedom), above));
}

double nonCentralChiSquaredBelow(double x, double degreesOfFreedom, double shift)
{
    // The charts of one quantity and of m, b and k ask for it a hundred thousand times.
    constexpr double leastShift = 1e-8; // of three: below, dividing by its root loses digits
    if (degreesOfFreedom == 1)
        return withinLine(std::sqrt(x), std::sqrt(shift));
    if (degreesOfFreedom == 3 && shift > leastShift)
        return withinBall(std::sqrt(x), std::sqrt(shift));
    return boost::math::cdf(NonCentralChiSquared(degreesOfFreedom, shift), x);
}

double fisherAbove(double f, double numerator, double denominator)
{
    return boost::math::cdf(boost::math::complement(Fisher(numerator, denominator), f));
}

double fisherQuantile(double below, double numerator, double denominator)
{
    return boost::math::quantile(Fisher(numerator, denominator), below);
}

double fisherQuantileAbove(double above, double numerator, double denominator)
{
    return boost::math::quantile(boost::math::complement(Fisher(numerator, denominator), above));
}

double nonCentralFisherBelow(double f, double numerator, double denominator, double shift)
{
    return boost::math::cdf(NonCentralFisher(numerator, denominator, shift), f);
}

double gammaAbove(double x, double shape, double scale)
{
    return boost::math::cdf(boost::math::complement(Gamma(shape, scale), x));
}

double betaQuantile(double below, double alpha, double beta)
{
    return boost::math::quantile(Beta(alpha, beta), below);
}

double logGamma(double x)
{
    return boost::math::lgamma(x, Policy());
}

} // namespace gripscope
