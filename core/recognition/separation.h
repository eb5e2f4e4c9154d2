// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/predictive.h"

#include <optional>
#include <vector>

namespace gripscope {

// How sure it is that a squeeze is of one type and not of another.

struct SeparationOptions {
    double wrongType = 0.001; ///< share of squeezes of a known part that may be named another type
    bool robust = false;      ///< tails of Student's t with 5 degrees of freedom
};

/// From the other type's mean towards the named one's, in standard deviations of a squeeze:
///     s = (x - mu_j)' S^-1 (mu_i - mu_j) / D,  D^2 = (mu_i - mu_j)' S^-1 (mu_i - mu_j).
/// A squeeze of j gets beyond `needed` that way with a probability of `rate`. With S estimated, v degrees of
/// freedom, and the direction taken from it, s is sqrt((1 + 1/n) v X) t with t ~ Student(v - 2) / sqrt(v - 2)
/// and X = 1 + chi2_2 / chi2_{v-1}, taken at its mean; 2/(n D) is how much the error of mu_j turns the
/// direction to itself (Anderson, An asymptotic expansion of the distribution of the studentized
/// classification statistic W, Annals of Statistics 1973).
struct Separation {
    double distance = 0; ///< D
    double reached = 0;  ///< s
    double needed = 0;
    [[nodiscard]] bool enough() const { return reached > needed; }
};

/// `named` against `other`, places in `predictions`. Nothing where the two means are the same or v < 3.
[[nodiscard]] std::optional<Separation> separation(const std::vector<TypePrediction>& predictions,
                                                   std::size_t named, std::size_t other,
                                                   const Eigen::Vector3d& log, double rate, bool robust);

/// Whether a squeeze may be called `named`, and if not, which other type forbids it most. The rate is shared
/// out evenly among those types that are near enough to be taken for it.
struct NamingTest {
    bool passed = false;
    std::optional<std::size_t> rival; ///< the one least ruled out; absent with one type
};
[[nodiscard]] NamingTest testNaming(const std::vector<TypePrediction>& predictions, std::size_t named,
                                    const Eigen::Vector3d& log, const SeparationOptions& options);

/// How many times as long a squeeze would tell these two types apart in nine of ten squeezes: its own
/// covariance shrinks like 1 / T, the rest stays. 1 at the least; nothing when 100 times would not do.
[[nodiscard]] std::optional<double> timesLonger(const TypeModels& models, std::size_t one, std::size_t other,
                                                const Eigen::Matrix3d& noise,
                                                const SeparationOptions& options);

} // namespace gripscope
