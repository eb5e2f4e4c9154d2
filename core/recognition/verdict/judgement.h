// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/predictive.h"
#include "core/recognition/verdict/verdict.h"

#include <optional>
#include <vector>

namespace gripscope {

// How sure it is that a squeeze is of one type and not of another.

struct SeparationOptions {
    double wrongType = 0.001; ///< share of squeezes of a known part that may be named another type
    bool robust = false;      ///< tails of Student's t with 5 degrees of freedom
};

/// From the other type's mean towards the named one's, in standard deviations of a squeeze:
///     s = u' (x - mu_j) / sqrt(u' S u),  D = u' (mu_i - mu_j) / sqrt(u' S u).
/// A squeeze of j gets beyond `needed` that way with a probability of `rate`; (p - 1)/(n D) of it is how much
/// the error of mu_j across turns the direction to itself (Anderson, An asymptotic expansion of the
/// distribution of the studentized classification statistic W, Annals of Statistics 1973).
///
/// Scatter of any shape: u = S^-1 (mu_i - mu_j), S with v degrees of freedom; s is sqrt((1 + 1/n) v X) t with
/// t ~ Student(v - p + 1) / sqrt(v - p + 1) and X = 1 + chi2_{p-1} / chi2_{v-p+2}, taken at its mean, since
/// the direction is taken from S too. (For p = 3: Student(v - 2), 1 + chi2_2 / chi2_{v-1}.)
///
/// Beyond three dimensions two things that are small before count as well. X has a tail, so that (E
/// X^r)^(1/r) takes the place of its mean, t falling as t^(-2 r) at the rate; and the turn is v/(v - p + 1)
/// times as large, since across the line S is only an estimate. Without them neighbours in six were mistaken
/// at 1.35 times the stated rate.
///
/// Scatter that may be alike in log m, log b and log k (TypePrediction::alikeCovariance A): u = A^-1 (mu_i -
/// mu_j), a direction that owes nothing to the shape of S. The variance along it has a conjugate prior,
/// scaled inverse chi-square about u' A u with a = min(8, v) degrees of freedom,
///     u' (a A + v S) u / (a + v),
/// and s is sqrt(1 + 1/n) Student(f), f = p v / (p - 2 (p - 1) w + (p - 1) w^2), w = a / (a + v), the degrees
/// of freedom of that sum when the scatter is alike: A is tr(S) / p, of variance 2 / (p v), and its
/// covariance with u' S u is the same. For p = 3 that is 3 v / (3 - 4 w + 2 w^2), 2 v for a = v; for p = 1,
/// v. The prior never counts for more than the squeezes do, so that the rate is kept on average over the
/// directions in which types may differ also where the deviations are as 1 : 1.5 : 2; figures in
/// resources/manual/recognition.md.
struct Separation {
    double distance = 0; ///< D
    double reached = 0;  ///< s
    double needed = 0;
    [[nodiscard]] bool enough() const { return reached > needed; }
};

/// `named` against `other`, places in `predictions`. Nothing where the two means are the same or v < p.
[[nodiscard]] std::optional<Separation> separation(const std::vector<TypePrediction>& predictions,
                                                   std::size_t named, std::size_t other, const LogVector& log,
                                                   double rate, bool robust);

/// Whether a squeeze may be called `named`, and if not, which other type forbids it most. The rate is shared
/// out evenly among those types that are near enough to be taken for it.
struct NamingTest {
    bool passed = false;
    std::optional<std::size_t> rival; ///< the one least ruled out; absent with one type
    std::vector<std::size_t> open;    ///< those not ruled out
};
[[nodiscard]] NamingTest testNaming(const std::vector<TypePrediction>& predictions, std::size_t named,
                                    const LogVector& log, const SeparationOptions& options);

/// How many times as long a squeeze would tell these two types apart in nine of ten squeezes: its own
/// covariance shrinks like 1 / T, the rest stays. 1 at the least; nothing when 100 times would not do.
[[nodiscard]] std::optional<double> timesLonger(const TypeModels& models, std::size_t one, std::size_t other,
                                                const LogMatrix& noise, const SeparationOptions& options);

/// One squeeze held against all types, step by step; what judge() does. `models` has a scatter, `log` is the
/// squeeze in models.space; `noise` is its covariance.
class Judgement {
public:
    Judgement(const TypeModels& models, LogVector log, const std::optional<LogMatrix>& noise,
              const VerdictOptions& options);
    [[nodiscard]] Verdict verdict() const;
    [[nodiscard]] std::vector<GateIntervals> gateIntervals() const; ///< see there

private:
    void findGates();
    void findNearest();
    [[nodiscard]] std::optional<double> gateOf(const TypePrediction& prediction) const;
    [[nodiscard]] bool inside(std::size_t type) const;
    void describeType(Verdict& verdict) const;
    void decide(Verdict& verdict) const;
    /// Whether the stated share of strangers forbids the nearest type; fills in what is said of strangers.
    bool heldForStranger(Verdict& verdict) const;

    const TypeModels& m_models;
    const std::optional<LogMatrix>& m_noise;
    const VerdictOptions& m_options;
    LogVector m_log;
    std::vector<TypePrediction> m_predictions;
    std::vector<double> m_gates; ///< on d' V^-1 d; empty when some type has none
    std::size_t m_nearest = 0;
};

} // namespace gripscope
