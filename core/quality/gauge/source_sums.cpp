// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/gauge/source_sums.h"

#include "core/base/words.h"
#include "core/math/distributions.h"
#include "core/quality/gauge/cell_means.h"

#include <Eigen/LU>

#include <algorithm>
#include <bit>

namespace gripscope {

namespace {

/// Means over the levels of a term.
Eigen::MatrixXd levelMeans(const std::vector<int>& cell, int cells, const Eigen::MatrixXd& values)
{
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(cells, values.cols());
    Eigen::VectorXd count = Eigen::VectorXd::Zero(cells);
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
        sum.row(cell[std::size_t(i)]) += values.row(i);
        count[cell[std::size_t(i)]] += 1;
    }
    return count.cwiseInverse().asDiagonal() * sum;
}

bool contains(const GaugeTerm& larger, const GaugeTerm& smaller)
{
    return (larger.factors & smaller.factors) == smaller.factors;
}

/// The table about its mean: subtracts the mean, then what rounding left of it.
Eigen::MatrixXd centredTable(const Eigen::MatrixXd& values, Eigen::VectorXd& mean)
{
    const Eigen::RowVectorXd first = values.row(0);
    Eigen::MatrixXd centred = values.rowwise() - first;
    const Eigen::RowVectorXd rest = centred.colwise().mean();
    mean = (first + rest).transpose();
    centred.rowwise() -= rest;
    centred.rowwise() -= Eigen::RowVectorXd(centred.colwise().mean());
    return centred;
}

/// Terms with fewer factors first: their effects are taken out of those that contain them.
std::vector<std::size_t> termsByOrder(const GaugeLayout& layout)
{
    std::vector<std::size_t> order(layout.terms.size());
    for (std::size_t t = 0; t < order.size(); ++t)
        order[t] = t;
    std::ranges::stable_sort(order, {},
                             [&](std::size_t t) { return std::popcount(layout.terms[t].factors); });
    return order;
}

void balancedSums(const GaugeLayout& layout, Eigen::MatrixXd rest, SourceSums& sums)
{
    const Eigen::Index terms = Eigen::Index(layout.terms.size()), rows = layout.rows();
    Eigen::VectorXd& degrees = sums.degreesOfFreedom;
    degrees[terms] = double(rows - 1);
    for (const std::size_t t : termsByOrder(layout)) {
        const GaugeTerm& term = layout.terms[t];
        // In a balanced table what simpler terms left holds this term's effect and no other's.
        const Eigen::MatrixXd effect = levelMeans(term.cell, term.cells, rest);
        double free = term.cells - 1;
        for (std::size_t u = 0; u < layout.terms.size(); ++u)
            if (u != t && contains(term, layout.terms[u]))
                free -= degrees[Eigen::Index(u)];
        degrees[Eigen::Index(t)] = free;
        degrees[terms] -= free;
        sums.products[t] = double(rows) / term.cells * effect.transpose() * effect;
        for (Eigen::Index i = 0; i < rows; ++i)
            rest.row(i) -= effect.row(term.cell[std::size_t(i)]);
        for (std::size_t l = 0; l < layout.terms.size(); ++l)
            if (contains(layout.terms[l], term))
                sums.coefficients(Eigen::Index(t), Eigen::Index(l)) =
                    free * double(rows) / layout.terms[l].cells;
    }
    sums.products.back() = rest.transpose() * rest;
    sums.coefficients.col(terms) = degrees;
}

tl::unexpected<Error> sumsError(const Finding& found, const Finding& expected)
{
    return failure(ErrorCode::BadInput, {Words::say("The table"), found, expected});
}

Finding determinedMessage(GaugeSource source)
{
    switch (source) {
    case GaugeSource::Operator:
        return Words::say("Operators cannot be told from the other columns, which determine them: left out.");
    case GaugeSource::Station:
        return Words::say("Stations cannot be told from the other columns, which determine them: left out.");
    case GaugeSource::PartOperator:
        return Words::say("The interaction of part and operator cannot be told from the other effects in "
                          "this table: left out.");
    default:
        return Words::say("The interaction of part and station cannot be told from the other effects in "
                          "this table: left out.");
    }
}

/// The source to leave out before the sums mean something.
std::optional<GaugeSource> indeterminate(const SourceSums& sums)
{
    const std::size_t last = sums.sources.size() - 1;
    for (std::size_t s = last; s-- > 0;)
        if (sums.degreesOfFreedom[Eigen::Index(s)] < 0.5)
            return sums.sources[s];
    if (sums.degreesOfFreedom[Eigen::Index(last)] < 0.5 && sums.sources[last - 1] != GaugeSource::Part)
        return sums.sources[last - 1];
    return std::nullopt;
}

/// A sum of squares that is rounding alone is 0: repeats that are equal have no scatter.
void dropRounding(SourceSums& sums)
{
    for (Eigen::MatrixXd& product : sums.products)
        for (Eigen::Index j = 0; j < product.cols(); ++j)
            if (product(j, j) < 1e-26 * sums.total(j, j)) {
                product.col(j).setZero();
                product.row(j).setZero();
            }
}

SourceSums emptySums(const GaugeLayout& layout)
{
    SourceSums sums;
    for (const GaugeTerm& term : layout.terms)
        sums.sources.push_back(term.source);
    sums.sources.push_back(GaugeSource::Repeatability);
    const Eigen::Index sources = Eigen::Index(sums.sources.size());
    sums.products.resize(sums.sources.size());
    sums.degreesOfFreedom = Eigen::VectorXd::Zero(sources);
    sums.coefficients = Eigen::MatrixXd::Zero(sources, sources);
    return sums;
}

} // namespace

Eigen::Index SourceSums::place(GaugeSource source) const
{
    const auto found = std::ranges::find(sources, source);
    return found == sources.end() ? -1 : found - sources.begin();
}

double SourceSums::meanSquare(Eigen::Index source, Eigen::Index value) const
{
    return products[std::size_t(source)](value, value) / degreesOfFreedom[source];
}

Eigen::VectorXd SourceSums::momentVariances(Eigen::Index value) const
{
    Eigen::VectorXd squares(degreesOfFreedom.size());
    for (Eigen::Index s = 0; s < squares.size(); ++s)
        squares[s] = products[std::size_t(s)](value, value);
    return coefficients.partialPivLu().solve(squares);
}

std::vector<Eigen::MatrixXd> SourceSums::momentCovariances() const
{
    const Eigen::MatrixXd inverse = coefficients.inverse();
    std::vector<Eigen::MatrixXd> covariances;
    for (Eigen::Index l = 0; l < inverse.rows(); ++l) {
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(total.rows(), total.cols());
        for (Eigen::Index s = 0; s < inverse.cols(); ++s)
            sum += inverse(l, s) * products[std::size_t(s)];
        covariances.push_back((sum + sum.transpose()) / 2);
    }
    return covariances;
}

Eigen::VectorXd SourceSums::effectiveDegrees(const Eigen::VectorXd& variances) const
{
    Eigen::VectorXd degrees = degreesOfFreedom;
    for (std::size_t s = 0; s < kernels.size(); ++s) {
        const Eigen::Index rank = Eigen::Index(degreesOfFreedom[Eigen::Index(s)]);
        Eigen::MatrixXd covariance = variances[variances.size() - 1] * Eigen::MatrixXd::Identity(rank, rank);
        for (std::size_t l = 0; l < kernels[s].size(); ++l)
            if (kernels[s][l].size() > 0)
                covariance += variances[Eigen::Index(l)] * kernels[s][l];
        const double trace = covariance.trace(), squares = covariance.squaredNorm();
        if (squares > 0)
            degrees[Eigen::Index(s)] = std::clamp(trace * trace / squares, 0.5, double(rank));
    }
    return degrees;
}

Expected<SourceSums> sourceSums(GaugeLayout& layout, const Eigen::MatrixXd& values)
{
    Eigen::VectorXd mean;
    const Eigen::MatrixXd centred = centredTable(values, mean);
    for (Eigen::Index j = 0; j < values.cols(); ++j)
        if ((values.col(j).array() == values(0, j)).all())
            return sumsError(Words::say("value column %1: all its values are equal").arg(j + 1),
                             Words::say("values with more digits: finer than the parts differ"));
    for (;;) {
        SourceSums sums = emptySums(layout);
        sums.mean = mean;
        sums.total = centred.transpose() * centred;
        if (layout.balanced)
            balancedSums(layout, centred, sums);
        else
            RETURN_IF_ERROR(projectedSums(layout, centred, sums));
        dropRounding(sums);
        const std::optional<GaugeSource> out = indeterminate(sums);
        if (out == GaugeSource::Part)
            return sumsError(Words::say("parts cannot be told from operators or stations"),
                             Words::say("several parts for each operator and station"));
        if (!out && sums.degreesOfFreedom[sums.degreesOfFreedom.size() - 1] < 0.5)
            return sumsError(Words::say("nothing was measured twice"),
                             Words::say("repeated measurements, without which repeatability is not known"));
        if (!out)
            return sums;
        layout = layout.without(*out);
        layout.messages.push_back(determinedMessage(*out));
    }
}

std::vector<VarianceRow> varianceTable(const SourceSums& sums, Eigen::Index value)
{
    const Eigen::Index sources = Eigen::Index(sums.sources.size());
    const Eigen::MatrixXd inverse = sums.coefficients.inverse();
    std::vector<VarianceRow> rows;
    for (Eigen::Index s = 0; s < sources; ++s) {
        VarianceRow row;
        row.source = sums.sources[std::size_t(s)];
        row.degreesOfFreedom = sums.degreesOfFreedom[s];
        row.sumOfSquares = sums.products[std::size_t(s)](value, value);
        row.meanSquare = sums.meanSquare(s, value);
        // What MS_s would be expected to be without its own effects, as a combination of the mean squares.
        Eigen::RowVectorXd others = sums.coefficients.row(s) / sums.degreesOfFreedom[s];
        others[s] = 0;
        const Eigen::RowVectorXd weights = others * inverse;
        double denominator = 0, variance = 0;
        for (Eigen::Index j = 0; j < sources; ++j) {
            const double part = weights[j] * sums.products[std::size_t(j)](value, value);
            denominator += part;
            variance += part * part / sums.degreesOfFreedom[j];
        }
        // A mean square that only rounding makes differ from 0 divides nothing.
        if (s + 1 < sources && denominator > 1e-14 * sums.total(value, value) && variance > 0) {
            row.f = row.meanSquare / denominator;
            row.p = fisherAbove(*row.f, row.degreesOfFreedom, denominator * denominator / variance);
        }
        rows.push_back(row);
    }
    return rows;
}

} // namespace gripscope
