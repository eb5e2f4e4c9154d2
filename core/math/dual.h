// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace gripscope {

/// A number with its derivatives along N directions (forward-mode differentiation; Griewank and Walther 2008,
/// ch. 3): what is computed with such numbers has the exact derivatives of what is computed.
template <int N>
struct Dual {
    double value = 0;
    Eigen::Array<double, N, 1> slope = Eigen::Array<double, N, 1>::Zero();

    Dual() = default;
    Dual(double constant) : value(constant) {} // NOLINT(google-explicit-constructor): constants are numbers
    Dual(double at, int direction, double rate = 1) : value(at) { slope(direction) = rate; }

    Dual& operator+=(const Dual& other)
    {
        value += other.value;
        slope += other.slope;
        return *this;
    }
    Dual& operator-=(const Dual& other)
    {
        value -= other.value;
        slope -= other.slope;
        return *this;
    }
    Dual& operator*=(double factor)
    {
        value *= factor;
        slope *= factor;
        return *this;
    }
    friend Dual operator-(Dual a) { return a *= -1; }
    friend Dual operator+(Dual a, const Dual& b) { return a += b; }
    friend Dual operator-(Dual a, const Dual& b) { return a -= b; }
    friend Dual operator*(Dual a, double factor) { return a *= factor; }
    friend Dual operator*(double factor, Dual a) { return a *= factor; }
    friend Dual operator*(const Dual& a, const Dual& b)
    {
        Dual product(a.value * b.value);
        product.slope = a.value * b.slope + b.value * a.slope;
        return product;
    }
    friend Dual operator/(const Dual& a, const Dual& b)
    {
        Dual quotient(a.value / b.value);
        quotient.slope = (a.slope - quotient.value * b.slope) / b.value;
        return quotient;
    }
};

/// What a number's derivatives are held in; a plain number has none.
template <typename Number>
struct SlopesOf {
    using Type = double;
};
template <int N>
struct SlopesOf<Dual<N>> {
    using Type = Eigen::Array<double, N, 1>;
};

/// With its derivatives multiplied: for what is computed with one of several equal factors' derivatives.
[[nodiscard]] inline double withSlopesTimes(double /*factor*/, double number)
{
    return number;
}
template <int N>
[[nodiscard]] Dual<N> withSlopesTimes(double factor, Dual<N> number)
{
    number.slope *= factor;
    return number;
}

/// sum += a b, in one pass over the derivatives.
inline void addProduct(double& sum, double a, double b)
{
    sum += a * b;
}
template <int N>
void addProduct(Dual<N>& sum, const Dual<N>& a, const Dual<N>& b)
{
    sum.value += a.value * b.value;
    sum.slope += a.value * b.slope + b.value * a.slope;
}
template <int N>
void addProduct(Dual<N>& sum, const Dual<N>& a, double factor)
{
    sum.value += a.value * factor;
    sum.slope += a.slope * factor;
}

[[nodiscard]] inline double valuePart(double number)
{
    return number;
}
template <int N>
[[nodiscard]] double valuePart(const Dual<N>& number)
{
    return number.value;
}

} // namespace gripscope
