// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/determined_text.h"

#include "core/base/csv.h"

#include <QStringList>

#include <cmath>
#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString textOf(const LogVector& numbers)
{
    QStringList texts;
    for (const double number : numbers)
        texts << exactText(number);
    return texts.join(u' ');
}

LogVector upperTriangle(const LogMatrix& matrix, Eigen::Index row)
{
    return matrix.row(row).tail(matrix.cols() - row).transpose();
}

QString textOf(const LogMatrix& covariance)
{
    QStringList rows;
    for (Eigen::Index i = 0; i < covariance.rows(); ++i)
        rows << textOf(upperTriangle(covariance, i));
    return rows.join(u' ');
}

/// Nothing unless these are `count` finite numbers.
std::optional<std::vector<double>> numbersIn(const QString& text, Eigen::Index count)
{
    std::vector<double> numbers;
    for (const QString& one : text.split(u' ')) {
        bool isNumber = false;
        numbers.push_back(one.toDouble(&isNumber));
        if (!isNumber || !std::isfinite(numbers.back()))
            return {};
    }
    return static_cast<Eigen::Index>(numbers.size()) == count ? std::optional(numbers) : std::nullopt;
}

std::optional<LogMatrix> covarianceIn(const QString& text, Eigen::Index dimensions)
{
    const auto numbers = numbersIn(text, dimensions * (dimensions + 1) / 2);
    if (!numbers)
        return {};
    LogMatrix covariance(dimensions, dimensions);
    std::size_t next = 0;
    for (Eigen::Index i = 0; i < dimensions; ++i)
        for (Eigen::Index j = i; j < dimensions; ++j)
            covariance(i, j) = covariance(j, i) = (*numbers)[next++];
    return covariance;
}

} // namespace

std::optional<DeterminedText> determinedText(const DeterminedQuantities& determined)
{
    const Eigen::Index dimensions = determined.space.dimensions();
    const auto& covariance = determined.covariance;
    const bool isWhole =
        dimensions > 0 && determined.log.size() == dimensions && determined.log.allFinite() &&
        (!covariance ||
         (covariance->rows() == dimensions && covariance->cols() == dimensions && covariance->allFinite()));
    if (!isWhole)
        return {};
    return DeterminedText{toString(determined.space), textOf(determined.log),
                          covariance ? textOf(*covariance) : u""_s};
}

std::optional<DeterminedQuantities> determinedQuantities(const DeterminedText& text)
{
    const auto space = quantitySpaceFromString(text.quantities);
    const auto logarithms = space ? numbersIn(text.logarithms, space->dimensions()) : std::nullopt;
    if (!logarithms)
        return {};
    LogVector log(space->dimensions());
    std::ranges::copy(*logarithms, log.begin());
    const auto covariance =
        text.covariance.isEmpty() ? std::nullopt : covarianceIn(text.covariance, space->dimensions());
    if (!covariance && !text.covariance.isEmpty())
        return {};
    return DeterminedQuantities{*space, log, covariance};
}

} // namespace gripscope
