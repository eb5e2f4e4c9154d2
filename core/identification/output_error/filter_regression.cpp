// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/filter_regression.h"

#include "core/identification/model/exact_step.h"
#include "core/math/decompositions.h"
#include "core/math/sequential_qr.h"

#include <cmath>

namespace gripscope {

namespace {

/// A column of which less than this is left beside the others is dependent on them.
constexpr double dependentFilterColumn = 1e-14;
/// Far below anything that counts, far above denormal numbers and their squares.
constexpr double gone = 1e-150;

/// Which column holds which power of y; negative: none.
struct PowerColumns {
    std::array<Eigen::Index, 4> column{-1, 2, -1, -1};
    Eigen::Index count = 5;

    PowerColumns(bool constant, bool cubic)
    {
        if (constant)
            column[0] = count++;
        if (cubic)
            column[3] = count++;
        if (constant && cubic)
            column[2] = count++;
    }
};

} // namespace

std::optional<FilterRegression> filterRegression(const OutputErrorProblem& record, double bandwidth,
                                                 bool cubic)
{
    const AlignedSamples samples(record);
    const double squared = bandwidth * bandwidth;
    SecondOrderFilter force(squared, 2 * bandwidth, record.hold);
    std::array<SecondOrderFilter, 3> powers;
    powers.fill(SecondOrderFilter(squared, 2 * bandwidth, ForceHold::First));
    const PowerColumns columns(record.freeOffset, cubic);
    SequentialQr qr(columns.count + 1);
    const double factor = std::exp(-bandwidth);
    double decay = 1; // exp(-bandwidth t)
    for (std::ptrdiff_t t = 0; t < samples.count; ++t) {
        const double y = samples.position(t);
        auto row = qr.nextRow();
        row.head<5>() << powers[0].curvature(y), powers[0].slope(), powers[0].value(), decay,
            decay * bandwidth * static_cast<double>(t);
        if (columns.column[0] >= 0)
            row(columns.column[0]) = 1;
        for (std::size_t power = 2; power < 4; ++power) {
            if (columns.column[power] >= 0)
                row(columns.column[power]) = powers[power - 1].value();
        }
        row(columns.count) = force.value();
        const std::ptrdiff_t after = std::min(t + 1, samples.count - 1);
        const double next = samples.position(after);
        force.advance(samples.force(t), samples.force(after));
        powers[0].advance(y, next);
        if (cubic) {
            powers[1].advance(y * y, next * next);
            powers[2].advance(y * y * y, next * next * next);
        }
        decay = decay > gone ? decay * factor : 0;
    }
    const Eigen::MatrixXd& triangle = qr.triangle();
    if (!triangle.allFinite())
        return std::nullopt;
    const Eigen::VectorXd c =
        eliminateColumns(triangle, columns.count, dependentFilterColumn).solution.col(0);
    if (!c.allFinite())
        return std::nullopt;
    FilterRegression regression{c(0), c(1), {}};
    for (std::size_t power = 0; power < 4; ++power) {
        if (columns.column[power] >= 0)
            regression.spring[power] = c(columns.column[power]);
    }
    return regression;
}

} // namespace gripscope
