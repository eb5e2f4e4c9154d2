// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace gripscope {

/// What searches in the logarithms of positive parameters have in common.
namespace search {

/// Share of the measured series' own size below which residuals are rounding errors.
inline constexpr double rounding = 1e-13;
/// A step in a logarithm is cut to a factor of ten.
inline constexpr double longestStep = 2.302585;
/// A parameter that wants to change by more than this factor (e) where the cost no longer changes has run
/// away.
inline constexpr double runaway = 1.0;
/// Standard error of a logarithm (a factor of 20) above which a parameter cannot be told from zero.
inline constexpr double undetermined = 3.0;
/// The damping stays between these.
inline constexpr double smallestDamping = 1e-12, largestDamping = 1e16;

} // namespace search

enum class SearchOutcome {
    Converged,
    NotConverged,
    Boundary, ///< the best value of one of the positive parameters is zero or infinite
    Lost,     ///< the model has no finite response at the start
};

struct SearchEnd {
    SearchOutcome outcome = SearchOutcome::NotConverged;
    int iterations = 0;
    int boundaryIndex = 0; ///< of the logarithm at the boundary
    bool boundaryAtZero = true;
};

/// Levenberg-Marquardt (More 1978, with Marquardt's scaling) for positive parameters, searched in their
/// logarithms, and other unknowns: a step d solves
///     min |R d - c|^2 + damping |D d|^2,
/// R the triangle of the sensitivities, c the residuals in its coordinates, D the largest norms that R's
/// columns have had. The damping falls tenfold after a step that lowers the cost (the sum of squared
/// residuals) and grows tenfold after one that does not. What is linearised, and how a step is taken, is the
/// strategy: a subclass.
///
/// Ends when the step still to go is `arrived` standard errors (relative offset criterion, Bates and Watts
/// 1981), when it is lost in rounding, when the logarithm of a parameter runs away, or after so many
/// iterations; where the standard error of a logarithm is then above search::undetermined, for want of data
/// (Boundary).
class LevenbergMarquardt {
public:
    virtual ~LevenbergMarquardt() = default;

protected:
    using Step = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 14, 1>;
    using Logarithms = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 10, 1>;

    /// `size`: the sum of squares of what is measured.
    LevenbergMarquardt(double size, double arrived) : m_size(size), m_arrived(arrived) {}
    [[nodiscard]] SearchEnd minimise(int maxIterations);
    [[nodiscard]] int iterations() const { return m_end.iterations; } ///< begun so far

    /// Brings R, c and D up to date; false where the model has no finite response.
    virtual bool prepare() = 0;
    [[nodiscard]] virtual bool finite() const = 0;
    [[nodiscard]] virtual double cost() const = 0;
    [[nodiscard]] virtual double degreesOfFreedom() const = 0;
    [[nodiscard]] virtual double toGo() const = 0; ///< |c|: the step to go, in units of the residuals
    [[nodiscard]] virtual Step dampedStep(double damping) const = 0;
    [[nodiscard]] virtual Logarithms logarithmsOf(const Step& step) const { return step; }
    /// Standard errors of the logarithms for residuals of deviation 1.
    [[nodiscard]] virtual Logarithms logarithmDeviations() const = 0;
    /// The step still to go, in standard errors, that is good enough where the search comes no nearer.
    [[nodiscard]] virtual double nearEnough() const { return 1e-4; }
    /// Takes the step, cut where it is too long, if that lowers the cost.
    virtual bool accept(const Step& step) = 0;
    /// A better linearisation at the same point; false where there is none.
    virtual bool refresh() { return false; }
    /// The step lowers the cost by less than the cost is rounded, which can't be seen any more.
    virtual bool isLostInRounding() { return false; }
    /// Takes that step; false where it leads nowhere.
    virtual bool polish() { return false; }
    /// One iteration; false where no step helps any more.
    virtual bool improve();
    /// Takes the first damped step that lowers the cost; false when none does.
    bool improveByDamping();

    const double m_size;

private:
    [[nodiscard]] double residualDeviation() const;
    [[nodiscard]] bool hasArrived() const;
    bool runsAway();
    void stall();
    void markUndetermined();

    const double m_arrived;
    SearchEnd m_end;
    double m_damping = 1e-3, m_gain = 0;
    int m_idle = 0;
};

/// Where a search may start, with what each costs: the cheapest few are worth a search.
template <typename Point>
class StartCandidates {
public:
    static constexpr std::size_t most = 3;

    void offer(Point point, double cost) { m_all.push_back({std::move(point), cost}); }
    /// At most `most` of them, the cheapest first; of equals the first offered.
    [[nodiscard]] std::vector<Point> best()
    {
        std::stable_sort(m_all.begin(), m_all.end(),
                         [](const auto& a, const auto& b) { return a.cost < b.cost; });
        std::vector<Point> first;
        for (std::size_t i = 0; i < std::min(most, m_all.size()); ++i)
            first.push_back(m_all[i].point);
        return first;
    }

private:
    struct Candidate {
        Point point;
        double cost;
    };
    std::vector<Candidate> m_all;
};

/// Searches from one start after the other; keeps the best that settled, or else the first answer. A Result
/// has cost() and isSettled(): it ended at an optimum that the data determines.
template <typename Result>
class MultiStart {
public:
    /// A settled search of at most this cost is good enough to look no further.
    explicit MultiStart(double goodCost = std::numeric_limits<double>::infinity()) : m_goodCost(goodCost) {}

    /// `search(start)` gives an optional Result, nothing for a start that is none.
    template <typename Starts, typename Search>
    void run(const Starts& starts, const Search& search)
    {
        for (const auto& start : starts) {
            const std::optional<Result> result = search(start);
            if (!result)
                continue;
            const bool better =
                m_best && result->isSettled() && (!m_best->isSettled() || result->cost() < m_best->cost());
            if (!m_best || better)
                m_best = result;
            if (isGood())
                return;
        }
    }
    [[nodiscard]] bool isGood() const
    {
        return m_best && m_best->isSettled() && m_best->cost() <= m_goodCost;
    }
    [[nodiscard]] const std::optional<Result>& best() const { return m_best; }

private:
    double m_goodCost;
    std::optional<Result> m_best;
};

} // namespace gripscope
