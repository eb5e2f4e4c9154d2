// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/quality/gauge/cell_means.h"

#include <Eigen/QR>

#include <algorithm>

namespace gripscope {

namespace {

/// Less than this share of a column that the others leave is rounding.
constexpr double newDirection = 1e-9;

/// sqrt(count) times the indicator of each level: what a level adds to the weighted means.
Eigen::MatrixXd weightedIndicators(const CellTable& cells, std::size_t term, int levels)
{
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(cells.count.size(), levels);
    for (Eigen::Index c = 0; c < cells.count.size(); ++c)
        columns(c, cells.levelOf[term][std::size_t(c)]) = std::sqrt(cells.count[c]);
    return columns;
}

/// Orthonormal basis of the space of `columns`, and of what is orthogonal to it.
struct Split {
    Eigen::MatrixXd inside, outside;
};

Split split(const Eigen::MatrixXd& columns, bool wantOutside)
{
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
    qr.setThreshold(newDirection);
    qr.compute(columns);
    const Eigen::Index rows = columns.rows(), rank = qr.rank();
    Split result;
    const Eigen::Index wanted = wantOutside ? rows : rank;
    const Eigen::MatrixXd basis = qr.householderQ() * Eigen::MatrixXd::Identity(rows, wanted);
    result.inside = basis.leftCols(rank);
    if (wantOutside)
        result.outside = basis.rightCols(rows - rank);
    return result;
}

/// What `columns` add to the space of `known`.
Eigen::MatrixXd added(const Eigen::MatrixXd& known, const Eigen::MatrixXd& columns)
{
    Eigen::MatrixXd rest = columns;
    for (int pass = 0; pass < 2; ++pass) // the second takes out what rounding left
        rest -= known * (known.transpose() * rest);
    const double size = columns.colwise().norm().maxCoeff();
    std::vector<Eigen::Index> kept;
    for (Eigen::Index j = 0; j < rest.cols(); ++j)
        if (rest.col(j).norm() > newDirection * size)
            kept.push_back(j);
    if (kept.empty())
        return Eigen::MatrixXd(columns.rows(), 0);
    return split(rest(Eigen::all, kept), false).inside;
}

Eigen::MatrixXd withoutContaining(const GaugeLayout& layout, const CellTable& cells, std::size_t term)
{
    Eigen::MatrixXd columns = cells.count.cwiseSqrt();
    for (std::size_t u = 0; u < layout.terms.size(); ++u) {
        const bool contains =
            (layout.terms[u].factors & layout.terms[term].factors) == layout.terms[term].factors;
        if (contains)
            continue;
        const Eigen::MatrixXd more = weightedIndicators(cells, u, layout.terms[u].cells);
        columns.conservativeResize(Eigen::NoChange, columns.cols() + more.cols());
        columns.rightCols(more.cols()) = more;
    }
    return columns;
}

void sumOfTerm(const GaugeLayout& layout, const CellTable& cells, const Eigen::MatrixXd& weighted,
               std::size_t term, SourceSums& sums)
{
    const bool saturates = layout.terms[term].cells == int(cells.count.size());
    const Split known = split(withoutContaining(layout, cells, term), saturates);
    const Eigen::MatrixXd basis =
        saturates ? known.outside
                  : added(known.inside, weightedIndicators(cells, term, layout.terms[term].cells));
    const Eigen::MatrixXd part = basis.transpose() * weighted;
    const Eigen::Index at = Eigen::Index(term), last = Eigen::Index(layout.terms.size());
    sums.products[term] = part.transpose() * part;
    sums.degreesOfFreedom[at] = double(basis.cols());
    sums.coefficients(at, last) = double(basis.cols());
    std::vector<Eigen::MatrixXd> kernels(layout.terms.size());
    for (std::size_t l = 0; l < layout.terms.size(); ++l) {
        if ((layout.terms[l].factors & layout.terms[term].factors) != layout.terms[term].factors)
            continue; // taken out by the projection
        const Eigen::MatrixXd reach = basis.transpose() * weightedIndicators(cells, l, layout.terms[l].cells);
        kernels[l] = reach * reach.transpose();
        sums.coefficients(at, Eigen::Index(l)) = kernels[l].trace();
    }
    sums.kernels.push_back(std::move(kernels));
}

void sumOfRest(const GaugeLayout& layout, const CellTable& cells, const Eigen::MatrixXd& weighted,
               SourceSums& sums)
{
    Eigen::MatrixXd columns = cells.count.cwiseSqrt();
    bool saturated = false;
    for (std::size_t u = 0; u < layout.terms.size(); ++u) {
        saturated = saturated || layout.terms[u].cells == int(cells.count.size());
        const Eigen::MatrixXd more = weightedIndicators(cells, u, layout.terms[u].cells);
        columns.conservativeResize(Eigen::NoChange, columns.cols() + more.cols());
        columns.rightCols(more.cols()) = more;
    }
    const Eigen::Index last = Eigen::Index(layout.terms.size());
    sums.products.back() = cells.within;
    double degrees = cells.withinDegrees;
    if (!saturated) {
        const Eigen::MatrixXd basis = split(columns, false).inside;
        Eigen::MatrixXd rest = weighted;
        for (int pass = 0; pass < 2; ++pass)
            rest -= basis * (basis.transpose() * rest);
        sums.products.back() += rest.transpose() * rest;
        degrees += double(cells.count.size() - basis.cols());
    }
    sums.degreesOfFreedom[last] = degrees;
    sums.coefficients(last, last) = degrees;
}

} // namespace

CellTable cellTable(const GaugeLayout& layout, const Eigen::MatrixXd& centred)
{
    const Eigen::Index cells = Eigen::Index(layout.count.size());
    CellTable table;
    table.count = Eigen::VectorXd::Zero(cells);
    table.mean = Eigen::MatrixXd::Zero(cells, centred.cols());
    table.levelOf.assign(layout.terms.size(), std::vector<int>(std::size_t(cells), 0));
    for (Eigen::Index i = 0; i < layout.rows(); ++i) {
        const int cell = layout.cell[std::size_t(i)];
        table.count[cell] += 1;
        table.mean.row(cell) += centred.row(i);
        for (std::size_t t = 0; t < layout.terms.size(); ++t)
            table.levelOf[t][std::size_t(cell)] = layout.terms[t].cell[std::size_t(i)];
    }
    table.mean = table.count.cwiseInverse().asDiagonal() * table.mean;
    table.within = Eigen::MatrixXd::Zero(centred.cols(), centred.cols());
    for (Eigen::Index i = 0; i < layout.rows(); ++i) {
        const Eigen::RowVectorXd rest = centred.row(i) - table.mean.row(layout.cell[std::size_t(i)]);
        table.within += rest.transpose() * rest;
    }
    table.withinDegrees = double(layout.rows() - cells);
    return table;
}

std::optional<Error> projectedSums(const GaugeLayout& layout, const Eigen::MatrixXd& centred,
                                   SourceSums& sums)
{
    if (layout.count.size() > mostUnbalancedCells)
        return Error{ErrorCode::BadInput,
                     {Words::say("The table"),
                      Words::say("%1 combinations of part, operator and station that are not balanced")
                          .arg(layout.count.size()),
                      Words::say("at most %1, or as many measurements of each; a sample of the parts will do")
                          .arg(mostUnbalancedCells)}};
    const CellTable cells = cellTable(layout, centred);
    const Eigen::MatrixXd weighted = cells.count.cwiseSqrt().asDiagonal() * cells.mean;
    for (std::size_t t = 0; t < layout.terms.size(); ++t)
        sumOfTerm(layout, cells, weighted, t, sums);
    sumOfRest(layout, cells, weighted, sums);
    return std::nullopt;
}

} // namespace gripscope
