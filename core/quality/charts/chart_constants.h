// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

/// The constants of Shewhart charts for subgroups of n independent normal values, computed, not tabulated:
///     c4 = sqrt(2/(n-1)) Gamma(n/2) / Gamma((n-1)/2),  E[s] = c4 sigma
///     d2 = int [1 - Phi(x)^n - (1 - Phi(x))^n] dx,     E[R] = d2 sigma
///     d3 = sqrt(2 int w P(R > w) dw - d2^2),           standard deviation of R over sigma (sigma = 1)
/// Good to 1e-10. Source: Tippett, On the extreme individuals and the range of samples, Biometrika 1925; the
/// factors are those of ASTM MNL 7 and Montgomery, Introduction to Statistical Quality Control, App. VI.
///
/// Tables round d2(5) = 2.3259289 to 2.326, which makes sigma from ranges of five 3e-5 too small.
struct ChartConstants {
    int size = 2; ///< n, at least 2
    double d2 = 0, d3 = 0, c4 = 0;

    // Limits of the mean at 3 sigma: about sigma, the mean range, the mean deviation.
    [[nodiscard]] double A() const;
    [[nodiscard]] double A2() const { return A() / d2; }
    [[nodiscard]] double A3() const { return A() / c4; }
    // Limits of s: of its mean (B3, B4) and of sigma (B5, B6); lower ones not below 0.
    [[nodiscard]] double B3() const { return B5() / c4; }
    [[nodiscard]] double B4() const { return B6() / c4; }
    [[nodiscard]] double B5() const;
    [[nodiscard]] double B6() const;
    // Limits of R: of sigma (D1, D2) and of its mean (D3, D4); lower ones not below 0.
    [[nodiscard]] double D1() const;
    [[nodiscard]] double D2() const;
    [[nodiscard]] double D3() const { return D1() / d2; }
    [[nodiscard]] double D4() const { return D2() / d2; }
};

/// `size` from 2 on; less counts as 2. About a millisecond: the double integral of d3.
[[nodiscard]] ChartConstants chartConstants(int size);

} // namespace gripscope
