// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/exact_step.h"
#include "core/identification/motion/motion_search.h"
#include "core/identification/output_error/filter_regression.h"
#include "core/math/least_squares.h"
#include "core/math/levenberg_marquardt.h"
#include "core/math/sequential_qr.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

namespace {

using P = MotionParameter;

/// Relaxation times worth trying, as shares of the record's length.
constexpr std::array<double, 5> relaxationShares{0.0015, 0.006, 0.025, 0.1, 0.4};
/// Fc beside the force's deviation, k1 beside k, k3 beside k over the squared size of the motion.
constexpr std::array<double, 3> frictionShares{0.01, 0.06, 0.3};
constexpr std::array<double, 3> relaxingShares{0.05, 0.3, 1.5};
constexpr std::array<double, 5> cubicShares{0, -0.25, 0.2, 0.7, 2.5};

double deviationOf(const std::vector<double>& values)
{
    double mean = 0;
    for (const double value : values)
        mean += value;
    mean /= static_cast<double>(values.size());
    double squares = 0;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return std::sqrt(squares / static_cast<double>(values.size()));
}

/// 1 / (1 + tau s) from where the signal begins.
class FirstOrderFilter {
public:
    FirstOrderFilter(double tau, double start) : m_keep(std::exp(-1 / tau)), m_state(start) {}
    [[nodiscard]] double value() const { return m_state; }
    void advance(double next) { m_state = m_keep * m_state + (1 - m_keep) * next; }

private:
    double m_keep, m_state;
};

/// What an impossible sign is replaced by, beside a size that is known: the search will see to it.
double positiveOr(double value, double fallback)
{
    return std::isfinite(value) && value > 0 ? value : fallback;
}

/// The terms of the equation at one sample, each filtered alike.
struct FilteredTerms {
    double curvature = 0, slope = 0, value = 0, sign = 0, square = 0, cube = 0, relaxed = 0, force = 0;

    [[nodiscard]] double of(P parameter) const
    {
        switch (parameter) {
        case P::Mass:
            return curvature;
        case P::Damping:
            return slope;
        case P::Stiffness:
            return value;
        case P::Relaxing:
            return value - relaxed;
        case P::Friction:
            return sign;
        case P::Cubic:
            return cube;
        case P::RelaxationTime: // tried one after the other
        case P::DampingBack:    // as forth, to begin with
        case P::FrictionBack:
        case P::ForceOffset: // the constant
            break;
        }
        return 0;
    }
};

/// Least squares of the family's own equation with every term filtered alike: a start, no estimate. Positions
/// are measured from the first one, y = x - x0: a cubic spring has a square of y there too.
class EquationRegression {
public:
    EquationRegression(const MotionProblem& problem, double bandwidth, double tau)
        : m_problem(problem), m_samples(problem), m_bandwidth(bandwidth), m_tau(tau),
          m_parameters(problem.terms.parameters()), m_first(m_samples.position(0))
    {
    }

    [[nodiscard]] std::optional<MotionPoint> solve() const
    {
        const auto own = static_cast<Eigen::Index>(m_parameters.size());
        const Eigen::Index columns = own + (m_problem.terms.cubic ? 2 : 1);
        SequentialQr qr(columns + 1);
        forEachSample([&](const FilteredTerms& terms) {
            auto row = qr.nextRow();
            for (std::size_t i = 0; i < m_parameters.size(); ++i)
                row(static_cast<Eigen::Index>(i)) = terms.of(m_parameters[i]);
            row(own) = 1;
            if (m_problem.terms.cubic)
                row(own + 1) = terms.square;
            row(columns) = terms.force;
        });
        const Eigen::MatrixXd& triangle = qr.triangle();
        if (!triangle.allFinite())
            return std::nullopt;
        const Eigen::VectorXd c =
            solvePivoted(triangle.topLeftCorner(columns, columns), triangle.col(columns).head(columns))
                .solution;
        return c.allFinite() ? pointOf(c) : std::nullopt;
    }

private:
    template <typename Use>
    void forEachSample(const Use& use) const
    {
        const double squared = m_bandwidth * m_bandwidth;
        SecondOrderFilter force(squared, 2 * m_bandwidth, m_problem.hold);
        std::array<SecondOrderFilter, 4> filters; // of y, of the sign of its slope, of y^2, of y^3
        filters.fill(SecondOrderFilter(squared, 2 * m_bandwidth, ForceHold::First));
        FirstOrderFilter relaxed(m_tau, 0);
        const std::ptrdiff_t settled =
            std::min<std::ptrdiff_t>(std::llround(6 / m_bandwidth), m_samples.count / 4);
        double signBefore = 0;
        for (std::ptrdiff_t t = 0; t < m_samples.count; ++t) {
            const double y = m_samples.position(t) - m_first;
            if (t >= settled)
                use(FilteredTerms{filters[0].curvature(y), filters[0].slope(), filters[0].value(),
                                  filters[1].value(), filters[2].value(), filters[3].value(), relaxed.value(),
                                  force.value()});
            const std::ptrdiff_t after = std::min(t + 1, m_samples.count - 1);
            const double next = m_samples.position(after) - m_first;
            const double slope = filters[0].slope();
            const double sign = slope > 0 ? 1 : slope < 0 ? -1 : 0;
            force.advance(m_samples.force(t), m_samples.force(after));
            filters[0].advance(y, next);
            filters[1].advance(signBefore, sign);
            filters[2].advance(y * y, next * next);
            filters[3].advance(y * y * y, next * next * next);
            relaxed.advance(filters[0].value());
            signBefore = sign;
        }
    }

    /// The spring's slope at y, from its terms k, k3 and that of the square.
    static double slopeAt(const MotionValues& p, double square, double y)
    {
        return p[P::Stiffness] + 2 * square * y + 3 * p[P::Cubic] * y * y;
    }
    /// Where the spring is at rest, beside the first position.
    static double restPosition(const MotionValues& p, double square, double constant)
    {
        constexpr int iterations = 20;
        double y = -constant / p[P::Stiffness];
        for (int i = 0; i < iterations && p[P::Cubic] != 0; ++i) {
            const double force = constant + y * (p[P::Stiffness] + y * (square + y * p[P::Cubic]));
            y -= force / slopeAt(p, square, y);
        }
        return y;
    }

    [[nodiscard]] std::optional<MotionPoint> pointOf(const Eigen::VectorXd& c) const
    {
        const MotionTerms& terms = m_problem.terms;
        MotionPoint point;
        MotionValues& p = point.values;
        for (std::size_t i = 0; i < m_parameters.size(); ++i)
            p[m_parameters[i]] = c(static_cast<Eigen::Index>(i));
        const auto own = static_cast<Eigen::Index>(m_parameters.size());
        const double constant = c(own);
        if (terms.spring) {
            const double square = terms.cubic ? c(own + 1) : 0;
            const double rest = m_problem.freeOffset ? restPosition(p, square, constant) : -m_first;
            p[P::Stiffness] = positiveOr(slopeAt(p, square, rest), 0);
            if (p[P::Stiffness] == 0 || !std::isfinite(rest))
                return std::nullopt;
            // Where no offset is sought there is none.
            point.offset = m_problem.freeOffset ? m_first + rest : 0;
            point.x0 = m_problem.seeksPosition() ? m_first - point.offset : 0;
        } else {
            point.offset = m_first; // the start
        }
        if (terms.forceOffset)
            p[P::ForceOffset] = -constant;
        const double stiffness = terms.spring ? p[P::Stiffness] : 0;
        if (terms.damping)
            p[P::Damping] = positiveOr(p[P::Damping], terms.mass && p[P::Mass] > 0 && terms.spring
                                                          ? 0.1 * std::sqrt(p[P::Mass] * stiffness)
                                                          : std::max(stiffness, 1e-3));
        if (terms.mass)
            p[P::Mass] = positiveOr(p[P::Mass], terms.spring ? 0.1 * p[P::Damping] * p[P::Damping] / stiffness
                                                             : p[P::Damping]);
        p[P::Friction] = positiveOr(p[P::Friction], 0.01 * deviationOf(m_problem.force));
        p[P::Relaxing] = positiveOr(p[P::Relaxing], 0.1 * stiffness);
        p[P::RelaxationTime] = m_tau;
        p[P::DampingBack] = p[P::Damping];
        p[P::FrictionBack] = p[P::Friction];
        return point;
    }

    const MotionProblem& m_problem;
    const AlignedSamples m_samples;
    const double m_bandwidth, m_tau;
    const std::vector<P> m_parameters;
    const double m_first;
};

struct MotionCandidates : StartCandidates<MotionPoint> {
    /// As many samples tell which start is better, where a spring lets the motion forget its start.
    static constexpr std::size_t enough = 1000;
    const MotionProblem& problem;
    MotionProblem part;

    explicit MotionCandidates(const MotionProblem& itsProblem) : problem(itsProblem), part(itsProblem)
    {
        if (problem.terms.spring && problem.force.size() > enough)
            static_cast<OutputErrorProblem&>(part) = firstSamples(problem, enough);
    }
    void offer(const MotionPoint& point)
    {
        if (const std::optional<MotionCost> there = costAt(part, point))
            StartCandidates::offer(point, there->cost);
    }
};

/// Moved by least squares of its start alone: the first position, which noise and the time between the
/// channels move, is a poor one for a spring that bends.
std::optional<MotionPoint> refineStart(const MotionProblem& problem, const MotionPoint& point)
{
    const MotionLinearization linear = linearize(problem, point);
    const Eigen::Index start = problem.startUnknowns();
    if (!linear.finite || start == 0)
        return std::nullopt;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(linear.triangle.cols());
    step.head(start) =
        solvePivoted(linear.triangle.topLeftCorner(start, start), linear.residual.head(start)).solution;
    return step.allFinite() ? std::optional(point.moved(problem, step)) : std::nullopt;
}

/// Its derivatives cost no more than any other point's: a motion that settles within a fraction of a sample
/// takes many short series, and no filter tells it from one that settles in a sample.
bool isQuick(const MotionProblem& problem, const MotionPoint& point)
{
    constexpr double longest = 3; // decays a sample
    return !problem.terms.mass || point.values[P::Damping] < longest * point.values[P::Mass];
}

/// Shares of the further terms beside what is known of the linear motion; 0 where a term is off.
template <std::size_t N>
std::vector<double> sharesOf(bool on, const std::array<double, N>& shares)
{
    return on ? std::vector<double>(shares.begin(), shares.end()) : std::vector<double>{0};
}

/// Not m, b and k alone.
bool hasFurther(const MotionTerms& terms, const MotionValues& values)
{
    return std::ranges::any_of(
        terms.parameters(), [&](P parameter) { return parameter > P::Stiffness && values[parameter] != 0; });
}

void offerVariants(MotionCandidates& candidates, const MotionPoint& other)
{
    const MotionProblem& problem = candidates.problem;
    const MotionTerms& terms = problem.terms;
    const double force = deviationOf(problem.force);
    const auto count = static_cast<double>(problem.position.size());
    const double squaredSize = 2 * positionEnergy(problem) / count;
    const double k = other.values[P::Stiffness];
    for (const double friction : sharesOf(terms.friction, frictionShares))
        for (const double relaxing : sharesOf(terms.relaxation, relaxingShares))
            for (const double tau : sharesOf(terms.relaxation, relaxationShares))
                for (const double cubic : sharesOf(terms.cubic, cubicShares)) {
                    MotionPoint point = other;
                    MotionValues& p = point.values;
                    p[P::Friction] = p[P::FrictionBack] = friction * force;
                    p[P::DampingBack] = p[P::Damping];
                    // A spring k that fits a motion of amplitude a is K + 3/4 K3 a^2 (Duffing 1918).
                    p[P::Stiffness] = k / (1 + 0.75 * cubic);
                    p[P::Cubic] = squaredSize > 0 ? cubic * p[P::Stiffness] / squaredSize : 0;
                    p[P::Stiffness] /= 1 + relaxing / 2;
                    p[P::Relaxing] = relaxing * p[P::Stiffness];
                    p[P::RelaxationTime] = tau * count;
                    candidates.offer(point);
                }
}

} // namespace

double startSpeed(const MotionProblem& problem)
{
    const std::size_t count = std::min<std::size_t>(problem.position.size(), 10);
    const double middle = (static_cast<double>(count) - 1) / 2;
    double sum = 0;
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) - middle;
        sum += t * problem.position[i];
        squares += t * t;
    }
    return squares > 0 ? sum / squares : 0;
}

MotionPoint startNear(const MotionProblem& problem, const MotionPoint& other)
{
    MotionPoint point = other;
    if (problem.seeksPosition())
        point.x0 = problem.position.front() - point.offset;
    if (problem.seeksSpeed())
        point.v0 = startSpeed(problem);
    point.strain0 = 0;
    return refineStart(problem, point).value_or(point);
}

std::vector<MotionPoint> motionStarts(const MotionProblem& problem, const MotionPoint& other)
{
    MotionCandidates candidates(problem);
    const auto count = static_cast<double>(problem.position.size());
    for (const double bandwidth : filterBandwidths)
        for (const double share : sharesOf(problem.terms.relaxation, relaxationShares))
            if (const auto point =
                    EquationRegression(problem, bandwidth, std::max(share * count, 1.0)).solve())
                candidates.offer(*point);
    if (problem.terms.cubic)
        for (const MotionPoint& point : candidates.best())
            if (const auto refined =
                    isQuick(problem, point) ? refineStart(candidates.part, point) : std::nullopt)
                candidates.offer(*refined);
    if (hasFurther(problem.terms, other.values))
        candidates.offer(other);
    if (other.values[P::Stiffness] > 0)
        offerVariants(candidates, other);
    return candidates.best();
}

} // namespace gripscope
