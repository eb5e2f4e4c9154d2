// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error_start.h"

#include "core/identification/arx_mapping.h"
#include "core/identification/column_elimination.h"
#include "core/identification/exact_step.h"
#include "core/identification/identifiability.h"
#include "core/identification/scaled_record.h"
#include "core/identification/tall_qr.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

namespace {

/// Bandwidths of the filters in radians a sample.
constexpr std::array<double, 5> filterBandwidths{0.01, 0.03, 0.1, 0.3, 1.0};
/// Share of a column that is rounding.
constexpr double dependent = 1e-15;
/// Far below anything that counts, far above denormal numbers and their squares.
constexpr double gone = 1e-150;
/// Samples the grid is tried on: enough to rank its coarse points.
constexpr std::size_t gridSamples = 2000;

/// signal / (1 + s/lambda)^2 and its derivatives, from rest, for a signal that is held or straight between
/// samples.
class StateVariableFilter {
public:
    StateVariableFilter(double bandwidth, ForceHold hold) : m_bandwidth(bandwidth)
    {
        Eigen::Matrix2d a;
        a << 0, 1, -bandwidth * bandwidth, -2 * bandwidth;
        m_step = exactStep<2>(a, Eigen::Vector2d(0, bandwidth * bandwidth), hold);
    }
    [[nodiscard]] double value() const { return m_value; }
    [[nodiscard]] double slope() const { return m_slope; }
    [[nodiscard]] double curvature(double input) const
    {
        return m_bandwidth * m_bandwidth * (input - m_value) - 2 * m_bandwidth * m_slope;
    }
    void advance(double now, double next)
    {
        const double value = m_step.phi(0, 0) * m_value + m_step.phi(0, 1) * m_slope +
                             (m_step.gamma0(0) * now + m_step.gamma1(0) * next);
        m_slope = m_step.phi(1, 0) * m_value + m_step.phi(1, 1) * m_slope +
                  (m_step.gamma0(1) * now + m_step.gamma1(1) * next);
        m_value = value;
    }

private:
    double m_bandwidth;
    ExactStep<2> m_step;
    double m_value = 0, m_slope = 0;
};

/// Position and force at the same time index, the lag rounded to whole samples.
struct AlignedSamples {
    const OutputErrorProblem& problem;
    std::ptrdiff_t shift, count;

    explicit AlignedSamples(const OutputErrorProblem& p)
        : problem(p), shift(p.lag.samples + (p.lag.rest >= 0.5 ? 1 : 0)),
          count(static_cast<std::ptrdiff_t>(p.force.size()) - std::abs(shift))
    {
    }
    [[nodiscard]] double force(std::ptrdiff_t t) const
    {
        return at(problem.force, t + std::max<std::ptrdiff_t>(shift, 0));
    }
    [[nodiscard]] double position(std::ptrdiff_t t) const
    {
        return at(problem.position, t + std::max<std::ptrdiff_t>(-shift, 0));
    }

private:
    static double at(const std::vector<double>& values, std::ptrdiff_t i)
    {
        return values[static_cast<std::size_t>(i)];
    }
};

/// Least-squares solution of the triangle whose last column is the right-hand side.
Eigen::VectorXd solveTriangle(const Eigen::MatrixXd& triangle)
{
    const Eigen::Index n = triangle.cols() - 1;
    if (!triangle.allFinite())
        return Eigen::VectorXd::Zero(n);
    return eliminateColumns(triangle, n, dependent).solution.col(0);
}

/// ln(M, B, K), an impossible sign of M or B replaced by something small: the search will see to it.
std::optional<Eigen::Vector3d> repaired(double m, double b, double k)
{
    if (!std::isfinite(m) || !std::isfinite(b) || !(k > 0) || !std::isfinite(k))
        return std::nullopt;
    if (!(m > 0))
        m = b > 0 ? 0.1 * b * b / k : k;
    if (!(b > 0))
        b = 0.1 * std::sqrt(m * k);
    const Eigen::Vector3d theta(std::log(m), std::log(b), std::log(k));
    return theta.allFinite() ? std::optional(theta) : std::nullopt;
}

std::optional<Eigen::Vector3d> fromStateVariableFilter(const OutputErrorProblem& problem, double bandwidth)
{
    const AlignedSamples samples(problem);
    StateVariableFilter forceFilter(bandwidth, problem.hold);
    StateVariableFilter positionFilter(bandwidth, ForceHold::First);
    TallQr qr(problem.freeOffset ? 7 : 6);
    const double factor = std::exp(-bandwidth);
    double decay = 1; // exp(-bandwidth t)
    for (std::ptrdiff_t t = 0; t < samples.count; ++t) {
        auto row = qr.nextRow();
        row(0) = decay;
        row(1) = decay * bandwidth * static_cast<double>(t);
        row(2) = positionFilter.curvature(samples.position(t));
        row(3) = positionFilter.slope();
        row(4) = positionFilter.value();
        if (problem.freeOffset)
            row(5) = 1;
        row(row.size() - 1) = forceFilter.value();
        const std::ptrdiff_t next = std::min(t + 1, samples.count - 1);
        forceFilter.advance(samples.force(t), samples.force(next));
        positionFilter.advance(samples.position(t), samples.position(next));
        decay = decay > gone ? decay * factor : 0;
    }
    const Eigen::VectorXd solution = solveTriangle(qr.triangle());
    return repaired(solution(2), solution(3), solution(4));
}

std::optional<Eigen::Vector3d> fromArx(const OutputErrorProblem& problem)
{
    const AlignedSamples samples(problem);
    TallQr qr(problem.freeOffset ? 7 : 6);
    for (std::ptrdiff_t t = 2; t < samples.count; ++t) {
        auto row = qr.nextRow();
        row.head<5>() << -samples.position(t - 1), -samples.position(t - 2), samples.force(t),
            samples.force(t - 1), samples.force(t - 2);
        if (problem.freeOffset)
            row(5) = 1;
        row(row.size() - 1) = samples.position(t);
    }
    const Eigen::VectorXd c = solveTriangle(qr.triangle());
    const std::optional<MassDampingStiffness> mapped = poleMapping(c(0), c(1), c(2) + c(3) + c(4), 1.0);
    return mapped ? repaired(mapped->m, mapped->b, mapped->k) : std::nullopt;
}

/// Candidates with their compliance refitted and the cost they then have.
struct Candidates {
    struct Candidate {
        Eigen::Vector3d theta;
        double cost;
    };
    const OutputErrorProblem& problem;
    std::vector<Candidate> all;

    void offer(const std::optional<Eigen::Vector3d>& candidate)
    {
        if (!candidate)
            return;
        const ResponseFit fit = fitResponse(problem, *candidate);
        if (!fit.finite || !(fit.gain > 0) || fit.ownShare < smallestOwnShare)
            return;
        // A compliance times g is M, B and K divided by g.
        const Eigen::Vector3d refitted = candidate->array() - std::log(fit.gain);
        if (refitted.allFinite())
            all.push_back({refitted, fit.costWithGain});
    }
    [[nodiscard]] std::vector<Eigen::Vector3d> bestFirst(std::size_t most)
    {
        std::sort(all.begin(), all.end(),
                  [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
        std::vector<Eigen::Vector3d> best;
        for (std::size_t i = 0; i < std::min(most, all.size()); ++i)
            best.push_back(all[i].theta);
        return best;
    }
};

} // namespace

OutputErrorStarts outputErrorStarts(const OutputErrorProblem& problem)
{
    Candidates candidates{problem, {}};
    candidates.offer(fromArx(problem));
    for (const double bandwidth : filterBandwidths)
        candidates.offer(fromStateVariableFilter(problem, bandwidth));
    OutputErrorStarts starts;
    starts.bestFirst = candidates.bestFirst(2);
    starts.trusted =
        !candidates.all.empty() && candidates.all.front().cost <= poorShare * positionEnergy(problem);
    return starts;
}

std::vector<Eigen::Vector3d> outputErrorGrid(const OutputErrorProblem& problem)
{
    const OutputErrorProblem part = firstSamples(problem, gridSamples);
    Candidates candidates{part, {}};
    const double lowest = 0.5 / static_cast<double>(part.force.size());
    for (double frequency = lowest; frequency < 3; frequency *= 1.6) {
        for (const double damping : {0.05, 0.3, 1.0, 4.0})
            candidates.offer(Eigen::Vector3d(-2 * std::log(frequency), std::log(2 * damping / frequency), 0));
    }
    return candidates.bestFirst(4);
}

} // namespace gripscope
