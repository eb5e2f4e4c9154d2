// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/gauge/cell_means.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

/// Of the variance of the table, which is scaled to 1: see the header.
constexpr double leastRepeatability = 1e-10;
/// Standard errors to go from which on Newton's steps are tried: near the maximum they double the digits,
/// where scoring gains few where the two informations differ.
constexpr double newtonNear = 0.5;

class RestrictedSearch {
public:
    RestrictedSearch(const GaugeLayout& layout, const Eigen::VectorXd& scaled)
        : m_cells(cellTable(layout, scaled)), m_within(m_cells.within(0, 0))
    {
        for (const GaugeTerm& term : layout.terms)
            m_levels.push_back(term.cells);
        m_count = Eigen::Index(m_levels.size()) + 1;
        m_variances = Eigen::VectorXd::Constant(m_count, 1.0 / double(m_count));
    }
    RestrictedLikelihoodResult run(const RestrictedLikelihoodOptions& options);

private:
    struct Point {
        double logLikelihood = -std::numeric_limits<double>::infinity();
        Eigen::MatrixXd projector; ///< P
        Eigen::VectorXd projected; ///< P y
    };

    [[nodiscard]] Eigen::MatrixXd covariance(const Eigen::VectorXd& variances) const;
    [[nodiscard]] Point at(const Eigen::VectorXd& variances) const;
    /// Sums over the levels of a term of the rows of a matrix.
    [[nodiscard]] Eigen::MatrixXd levelSums(std::size_t term, const Eigen::MatrixXd& rows) const;
    void differentiate(const Point& point);
    [[nodiscard]] double least(Eigen::Index l) const { return l + 1 == m_count ? leastRepeatability : 0; }
    [[nodiscard]] bool atBoundary(Eigen::Index l) const { return m_variances[l] <= least(l); }
    /// The step on the variances that are free to move, zero elsewhere; also where the information is not
    /// positive there.
    [[nodiscard]] Eigen::VectorXd step(const Eigen::MatrixXd& allInformation) const;
    /// Scoring, or near the maximum Newton.
    [[nodiscard]] Eigen::VectorXd bestStep() const;
    /// The length of a step in standard errors.
    [[nodiscard]] double lengthOf(const Eigen::VectorXd& direction) const
    {
        return std::sqrt(std::max(0.0, direction.dot(m_information * direction)));
    }
    bool improve(Point& point, const Eigen::VectorXd& direction);

    CellTable m_cells;
    double m_within;
    std::vector<int> m_levels;
    Eigen::Index m_count = 0;
    Eigen::VectorXd m_variances, m_score;
    Eigen::MatrixXd m_information; ///< expected
    Eigen::MatrixXd m_observed;    ///< minus the second derivatives
};

Eigen::MatrixXd RestrictedSearch::covariance(const Eigen::VectorXd& variances) const
{
    const Eigen::Index cells = m_cells.count.size();
    Eigen::MatrixXd v = Eigen::MatrixXd::Zero(cells, cells);
    for (std::size_t t = 0; t < m_levels.size(); ++t)
        for (Eigen::Index j = 0; j < cells; ++j)
            for (Eigen::Index i = j; i < cells; ++i)
                if (m_cells.levelOf[t][std::size_t(i)] == m_cells.levelOf[t][std::size_t(j)])
                    v(i, j) += variances[Eigen::Index(t)];
    v.diagonal() += variances[m_count - 1] * m_cells.count.cwiseInverse();
    return v;
}

RestrictedSearch::Point RestrictedSearch::at(const Eigen::VectorXd& variances) const
{
    Point point;
    const Eigen::Index cells = m_cells.count.size();
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance(variances));
    if (factor.info() != Eigen::Success)
        return point;
    point.projector = factor.solve(Eigen::MatrixXd::Identity(cells, cells));
    const Eigen::VectorXd ones = point.projector.rowwise().sum();
    const double information = ones.sum();
    const double logDeterminant = 2 * factor.matrixLLT().diagonal().array().log().sum();
    point.projector -= ones * ones.transpose() / information;
    point.projected = point.projector * m_cells.mean.col(0);
    const double repeatability = variances[m_count - 1];
    const double cost = logDeterminant + std::log(information) + m_cells.mean.col(0).dot(point.projected) +
                        m_cells.withinDegrees * std::log(repeatability) + m_within / repeatability;
    if (std::isfinite(cost))
        point.logLikelihood = -cost / 2;
    return point;
}

Eigen::MatrixXd RestrictedSearch::levelSums(std::size_t term, const Eigen::MatrixXd& rows) const
{
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(m_levels[term], rows.cols());
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
        sums.row(m_cells.levelOf[term][std::size_t(i)]) += rows.row(i);
    return sums;
}

void RestrictedSearch::differentiate(const Point& point)
{
    const Eigen::Index last = m_count - 1;
    const Eigen::VectorXd share = m_cells.count.cwiseInverse();
    const double repeatability = m_variances[last];
    m_score = Eigen::VectorXd::Zero(m_count);
    m_information = Eigen::MatrixXd::Zero(m_count, m_count);
    for (Eigen::Index k = 0; k < last; ++k) {
        const Eigen::MatrixXd half = levelSums(std::size_t(k), point.projector); // Z_k' P
        for (Eigen::Index l = k; l < last; ++l) {
            const Eigen::MatrixXd both = levelSums(std::size_t(l), half.transpose()); // Z_l' P Z_k
            m_information(k, l) = m_information(l, k) = both.squaredNorm() / 2;
            if (l == k)
                m_score[k] = -both.trace() / 2;
        }
        m_score[k] += levelSums(std::size_t(k), point.projected).squaredNorm() / 2;
        m_information(k, last) = m_information(last, k) = (half.colwise().squaredNorm() * share).value() / 2;
    }
    m_score[last] = (-point.projector.diagonal().dot(share) + point.projected.cwiseAbs2().dot(share) -
                     m_cells.withinDegrees / repeatability + m_within / (repeatability * repeatability)) /
                    2;
    Eigen::MatrixXd pulled(share.size(), m_count); // V_l P y
    for (Eigen::Index i = 0; i < share.size(); ++i)
        pulled(i, last) = share[i] * point.projected[i];
    for (Eigen::Index l = 0; l < last; ++l) {
        const std::vector<int>& levelOf = m_cells.levelOf[std::size_t(l)];
        const Eigen::MatrixXd sums = levelSums(std::size_t(l), point.projected);
        for (Eigen::Index i = 0; i < share.size(); ++i)
            pulled(i, l) = sums(levelOf[std::size_t(i)], 0);
    }
    m_information(last, last) = (share.dot(point.projector.cwiseAbs2() * share) +
                                 m_cells.withinDegrees / (repeatability * repeatability)) /
                                2;
    m_observed = pulled.transpose() * point.projector * pulled - m_information;
    m_observed(last, last) += m_within / (repeatability * repeatability * repeatability);
}

Eigen::VectorXd RestrictedSearch::step(const Eigen::MatrixXd& allInformation) const
{
    std::vector<Eigen::Index> free;
    for (Eigen::Index l = 0; l < m_count; ++l)
        if (!atBoundary(l) || m_score[l] > 0)
            free.push_back(l);
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(m_count);
    while (!free.empty()) {
        const Eigen::MatrixXd information = allInformation(free, free);
        const Eigen::VectorXd scale = information.diagonal().cwiseMax(1e-300).cwiseSqrt();
        const Eigen::LDLT<Eigen::MatrixXd> factor(scale.cwiseInverse().asDiagonal() * information *
                                                  scale.cwiseInverse().asDiagonal());
        if (!(factor.vectorD().minCoeff() > 0))
            break;
        const Eigen::VectorXd moved =
            factor.solve(Eigen::VectorXd(m_score(free)).cwiseQuotient(scale)).cwiseQuotient(scale);
        // At the boundary none may go below: it stays, and the others are solved for again.
        const auto stays = std::ranges::find_if(
            free, [&](const Eigen::Index& l) { return atBoundary(l) && moved[&l - free.data()] <= 0; });
        if (stays != free.end()) {
            free.erase(stays);
            continue;
        }
        for (std::size_t i = 0; i < free.size(); ++i)
            direction[free[i]] = moved[Eigen::Index(i)];
        break;
    }
    return direction.allFinite() ? direction : Eigen::VectorXd::Zero(m_count);
}

Eigen::VectorXd RestrictedSearch::bestStep() const
{
    const Eigen::VectorXd scoring = step(m_information);
    if (lengthOf(scoring) > newtonNear)
        return scoring;
    const Eigen::VectorXd newton = step(m_observed);
    return newton.squaredNorm() > 0 ? newton : scoring;
}

/// As far along the direction as the likelihood grows, at most to where the first variance is 0.
bool RestrictedSearch::improve(Point& point, const Eigen::VectorXd& direction)
{
    double longest = 1;
    for (Eigen::Index l = 0; l < m_count; ++l)
        if (direction[l] < 0)
            longest = std::min(longest, (m_variances[l] - least(l)) / -direction[l]);
    for (double length = longest; length > 1e-10; length /= 4) {
        Eigen::VectorXd tried = m_variances + length * direction;
        for (Eigen::Index l = 0; l < m_count; ++l)
            if (direction[l] < 0 && tried[l] < least(l) + 1e-14 * m_variances[l])
                tried[l] = least(l);
        Point better = at(tried);
        if (!(better.logLikelihood > point.logLikelihood))
            continue;
        m_variances = tried;
        point = std::move(better);
        return true;
    }
    return false;
}

RestrictedLikelihoodResult RestrictedSearch::run(const RestrictedLikelihoodOptions& options)
{
    RestrictedLikelihoodResult result;
    Point point = at(m_variances);
    for (; result.iterations < options.maxIterations && !result.converged; ++result.iterations) {
        differentiate(point);
        const Eigen::VectorXd direction = bestStep();
        const double toGo = lengthOf(direction);
        if (toGo < options.arrived) {
            result.converged = true;
        } else if (!improve(point, direction)) {
            // So near that rounding hides the growth of the likelihood: the last step is taken blindly.
            if (toGo < 1e-4)
                for (Eigen::Index l = 0; l < m_count; ++l)
                    m_variances[l] = std::max(least(l), m_variances[l] + direction[l]);
            result.converged = toGo < 1e-4;
            break;
        }
    }
    result.variances = m_variances;
    result.logLikelihood = point.logLikelihood;
    for (Eigen::Index l = 0; l < m_count; ++l) {
        result.boundary.push_back(atBoundary(l));
        if (atBoundary(l))
            result.variances[l] = 0;
    }
    return result;
}

} // namespace

RestrictedLikelihoodResult restrictedLikelihood(const GaugeLayout& layout, const Eigen::VectorXd& values,
                                                const RestrictedLikelihoodOptions& options)
{
    Eigen::VectorXd centred = values.array() - values[0];
    centred.array() -= centred.mean();
    const double size = std::sqrt(centred.squaredNorm() / double(centred.size()));
    if (!(size > 0)) { // nothing varies
        RestrictedLikelihoodResult none;
        none.variances = Eigen::VectorXd::Zero(Eigen::Index(layout.terms.size()) + 1);
        none.boundary.assign(layout.terms.size() + 1, true);
        none.converged = true;
        return none;
    }
    RestrictedLikelihoodResult result = RestrictedSearch(layout, centred / size).run(options);
    result.variances *= size * size;
    result.logLikelihood -= double(centred.size() - 1) * std::log(size);
    return result;
}

} // namespace gripscope
