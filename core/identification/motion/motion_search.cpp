// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion/motion_search.h"

#include "core/identification/model/identifiability.h"
#include "core/math/least_squares.h"
#include "core/math/sequential_qr.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gripscope {

namespace {

using P = MotionParameter;

/// Steps in cubic springs and friction are cut to so many springs, or forces, of the problem.
constexpr double longestOtherStep = 3;
/// What a step off a kink must lower the cost by, in variances of the residuals: a hundredth of what one
/// standard error changes.
constexpr double worthwhileGain = 0.01;
constexpr int mostKinks = 6;
/// A step that would be better this much shorter is tried shorter too: another cost is cheap beside another
/// step.
constexpr double longestShare = 0.8;

class MotionSearch : LevenbergMarquardt {
public:
    MotionSearch(const MotionProblem& problem, const MotionPoint& start, const MotionSearchOptions& options)
        : LevenbergMarquardt(squaredSize(problem), options.arrived), m_problem(problem),
          m_parameters(problem.terms.parameters()), m_first(problem.startUnknowns()), m_options(options),
          m_scales(Eigen::VectorXd::Zero(problem.unknowns()))
    {
        m_result.point = start;
        m_result.linear = linearize(problem, start);
    }

    MotionSearchResult run()
    {
        if (finite())
            static_cast<SearchEnd&>(m_result) = minimise(m_options.maxIterations);
        else
            m_result.outcome = SearchOutcome::Lost;
        return m_result;
    }

private:
    /// Leaves out the friction that would go below zero, and the speed of a part that sticks at the start.
    bool prepare() override
    {
        const MotionLinearization& linear = m_result.linear;
        m_scales = m_scales.cwiseMax(linear.triangle.colwise().norm().transpose());
        const Eigen::VectorXd downhill = linear.triangle.transpose() * linear.residual;
        m_active.clear();
        for (Eigen::Index i = 0; i < linear.triangle.cols(); ++i)
            if (!(isHeld(i) && downhill(i) <= 0) && linear.triangle.col(i).norm() > 0)
                m_active.push_back(i);
        m_triangle = linear.triangle;
        m_residual = linear.residual;
        if (m_active.size() < static_cast<std::size_t>(linear.triangle.cols())) {
            const Triangularized qr = triangularize(linear.triangle(Eigen::all, m_active), linear.residual);
            m_triangle = qr.triangle;
            m_residual = qr.right;
        }
        return !isBeaten() && !creepsNowhere();
    }
    /// Close to where it will end, which is not below what is known.
    [[nodiscard]] bool isBeaten() const
    {
        if (!m_options.lowest)
            return false;
        const double close = m_problem.terms.friction ? 0.3 : 1; // standard errors; kinks mislead
        const double variance = cost() / degreesOfFreedom();
        const double gain = m_residual.squaredNorm();
        if (gain <= close * close * variance &&
            cost() - gain >= *m_options.lowest - worthwhileGain * variance)
            return true;
        // What it leads to is no answer, and no better one than is known.
        return !m_problem.terms.friction && promisesLittle() && isUndetermined() &&
               cost() >= *m_options.lowest;
    }
    /// What the slope promises would move no likelihood.
    [[nodiscard]] bool promisesLittle() const
    {
        constexpr double little = 4; // variances
        return toGo() * toGo() <= little * cost() / degreesOfFreedom();
    }
    /// One of the parameters is not told from zero.
    [[nodiscard]] bool isUndetermined() const
    {
        return std::sqrt(cost() / degreesOfFreedom()) * logarithmDeviations().maxCoeff() >
               search::undetermined;
    }
    /// In a valley without an end: neither what a step gains nor what the next promises is worth it, and a
    /// parameter is not told from zero.
    bool creepsNowhere()
    {
        constexpr double hardly = 0.03; // variances
        constexpr int stepsInARow = 3;
        const double gain = m_costBefore - cost();
        const bool creeps =
            gain <= hardly * cost() / degreesOfFreedom() && promisesLittle() && isUndetermined();
        m_creeping = creeps ? m_creeping + 1 : 0;
        m_costBefore = cost();
        return m_creeping >= stepsInARow;
    }
    [[nodiscard]] bool isHeld(Eigen::Index column) const
    {
        if (column < m_first)
            return false;
        const P parameter = m_parameters[static_cast<std::size_t>(column - m_first)];
        return isFriction(parameter) && m_result.point.values[parameter] == 0;
    }
    [[nodiscard]] bool finite() const override { return m_result.linear.finite; }
    [[nodiscard]] double cost() const override { return m_result.linear.cost; }
    [[nodiscard]] double degreesOfFreedom() const override
    {
        return MotionSearchResult::degreesOfFreedom(m_problem);
    }
    [[nodiscard]] double toGo() const override { return m_residual.norm(); }
    [[nodiscard]] Step dampedStep(double damping) const override
    {
        const Eigen::VectorXd scales = m_scales(m_active);
        const Eigen::VectorXd some = dampedLeastSquares(m_triangle, m_residual, scales, damping);
        Step step = Step::Zero(m_scales.size());
        for (std::size_t i = 0; i < m_active.size(); ++i)
            step(m_active[i]) = some(static_cast<Eigen::Index>(i));
        return step;
    }
    [[nodiscard]] Logarithms logarithmsOf(const Step& step) const override
    {
        Logarithms all = Logarithms::Zero(static_cast<Eigen::Index>(m_parameters.size()));
        for (std::size_t i = 0; i < m_parameters.size(); ++i)
            if (isPositive(m_parameters[i]))
                all(static_cast<Eigen::Index>(i)) = step(m_first + static_cast<Eigen::Index>(i));
        return all;
    }
    [[nodiscard]] Logarithms logarithmDeviations() const override
    {
        const Eigen::MatrixXd inverse = m_triangle.triangularView<Eigen::Upper>().solve(
            Eigen::MatrixXd::Identity(m_triangle.rows(), m_triangle.cols()));
        Step deviations = Step::Zero(m_scales.size());
        for (std::size_t i = 0; i < m_active.size(); ++i)
            deviations(m_active[i]) = inverse.row(static_cast<Eigen::Index>(i)).norm();
        return logarithmsOf(deviations);
    }

    /// Where turning points come and go the cost has kinks, on which steps along its slope end, above or at a
    /// lowest point: then each unknown is tried by itself.
    bool improve() override
    {
        const double before = cost();
        const double promised = toGo() * toGo();
        if (LevenbergMarquardt::improve() && !creeps(before - cost(), promised))
            return true;
        return m_problem.terms.friction && m_kinks++ < mostKinks && improveByUnknown();
    }
    /// Along a kink steps go on and on for next to nothing of what the slope promises.
    [[nodiscard]] bool creeps(double gain, double promised) const
    {
        constexpr double hardly = 1e-3;
        return m_problem.terms.friction && gain < hardly * promised &&
               gain < worthwhileGain * cost() / degreesOfFreedom();
    }
    bool improveByUnknown()
    {
        constexpr std::array<double, 2> shares{0.5, 0.05};
        const double variance = cost() / degreesOfFreedom();
        const Eigen::MatrixXd inverse = m_triangle.triangularView<Eigen::Upper>().solve(
            Eigen::MatrixXd::Identity(m_triangle.rows(), m_triangle.cols()));
        double lowest = cost() - worthwhileGain * variance;
        std::optional<Step> best;
        for (std::size_t i = 0; i < m_active.size(); ++i)
            for (const double share : shares)
                for (const double way : {-1.0, 1.0}) {
                    // Along the valley: as far as the others follow.
                    const auto column = static_cast<Eigen::Index>(i);
                    const Eigen::VectorXd direction = inverse * inverse.row(column).transpose();
                    Step step = Step::Zero(m_scales.size());
                    for (std::size_t j = 0; j < m_active.size(); ++j)
                        step(m_active[j]) = way * share * std::sqrt(variance) *
                                            direction(static_cast<Eigen::Index>(j)) /
                                            inverse.row(column).norm();
                    const auto there = costAt(m_problem, m_result.point.moved(m_problem, step));
                    if (there && there->cost < lowest) {
                        lowest = there->cost;
                        best = step;
                    }
                }
        m_atKink = !best;
        return best && accept(*best);
    }
    /// At a kink no slope tells how far the search still has to go: nowhere is lower.
    [[nodiscard]] double nearEnough() const override
    {
        return m_atKink ? std::numeric_limits<double>::infinity() : LevenbergMarquardt::nearEnough();
    }

    bool accept(const Step& step) override
    {
        const std::optional<MotionPoint> point = lowerPoint(step);
        if (!point)
            return false;
        MotionLinearization trial = linearize(m_problem, *point);
        if (!trial.finite || !(trial.cost < m_result.linear.cost))
            return false;
        m_result.point = *point;
        m_result.linear = std::move(trial);
        return true;
    }
    /// Where the step leads, if the cost is lower there; costs are several times cheaper than derivatives. A
    /// stiffness moves the whole position with its inverse, the offset follows in a straight line: it is put
    /// right where that is seen, and the start stays where it is measured. (Without this the search creeps
    /// along the bend between the two.)
    [[nodiscard]] std::optional<MotionPoint> lowerPoint(const Step& step) const
    {
        const Step whole = shortening(step) * step;
        MotionPoint point = m_result.point.moved(m_problem, whole);
        std::optional<MotionCost> there = costAt(m_problem, point);
        if (!there)
            return std::nullopt;
        if (const double share = shareToLowest(whole, there->cost); share < longestShare) {
            const MotionPoint before = m_result.point.moved(m_problem, share * whole);
            const std::optional<MotionCost> lower = costAt(m_problem, before);
            if (lower && lower->cost < there->cost) {
                point = before;
                there = lower;
            }
        }
        const auto rows = static_cast<double>(m_problem.measuredRows());
        const double seen = worthwhileGain * cost() / degreesOfFreedom();
        double lowest = there->cost;
        if (m_problem.seeksOffset() && m_problem.terms.spring && there->mean * there->mean * rows > seen) {
            MotionPoint right = point;
            right.offset += there->mean;
            if (m_problem.seeksPosition())
                right.x0 -= there->mean;
            const std::optional<MotionCost> better = costAt(m_problem, right);
            if (better && better->cost < lowest) {
                lowest = better->cost;
                point = right;
            }
        }
        return lowest < cost() ? std::optional(point) : std::nullopt;
    }

    /// Where a parabola through the cost here, its slope and the cost after the step is lowest. A model that
    /// leaves much unexplained bends the cost more than its sensitivities tell: whole steps overshoot, to and
    /// fro. At kinks a slope tells nothing; where the step leads up, its direction is at fault, which damping
    /// turns.
    [[nodiscard]] double shareToLowest(const Step& step, double costAfter) const
    {
        if (m_problem.terms.friction || !(costAfter < cost()))
            return 1;
        const MotionLinearization& linear = m_result.linear;
        const double slope = -2 * (linear.triangle * step).dot(linear.residual);
        const double curvature = costAfter - cost() - slope;
        return curvature > 0 && slope < 0 ? -slope / (2 * curvature) : 1; // above a half
    }
    [[nodiscard]] double shortening(const Step& step) const
    {
        double shortest = search::longestStep / std::max(logarithmsOf(step).cwiseAbs().maxCoeff(), 1e-300);
        for (std::size_t i = 0; i < m_parameters.size(); ++i) {
            const P parameter = m_parameters[i];
            if (isPositive(parameter))
                continue;
            const double by = std::abs(step(m_first + static_cast<Eigen::Index>(i)));
            const double stiffness = m_problem.terms.spring ? m_result.point.values[P::Stiffness] : 1;
            const double size =
                parameter == P::Cubic ? std::max(stiffness, std::abs(m_result.point.values[P::Cubic])) : 1;
            shortest = std::min(shortest, longestOtherStep * size / std::max(by, 1e-300));
        }
        return std::min(1.0, shortest);
    }

    const MotionProblem& m_problem;
    const std::vector<P> m_parameters;
    const Eigen::Index m_first;
    const MotionSearchOptions m_options;
    MotionSearchResult m_result;
    Eigen::VectorXd m_scales;
    std::vector<Eigen::Index> m_active; ///< columns that the search moves
    Eigen::MatrixXd m_triangle;         ///< of those
    Eigen::VectorXd m_residual;
    double m_costBefore = std::numeric_limits<double>::infinity();
    int m_creeping = 0; ///< steps in a row
    bool m_atKink = false;
    int m_kinks = 0; ///< left so far
};

} // namespace

bool MotionSearchResult::isDetermined() const
{
    return linear.finite && linear.movesEveryParameter() &&
           scaledConditionNumber(linear.triangle(Eigen::all, linear.moving())) <= largestCondition;
}

MotionSearchResult searchMotion(const MotionProblem& problem, const MotionPoint& start,
                                const MotionSearchOptions& options)
{
    return MotionSearch(problem, start, options).run();
}

} // namespace gripscope
