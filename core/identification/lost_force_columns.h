// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/column_elimination.h"
#include "core/identification/output_error_cascade.h"
#include "core/identification/tall_qr.h"

#include <Eigen/Core>

#include <vector>

namespace gripscope {

/// The linear unknowns of a record with lost samples: the start and one force for every lost sample. Their
/// columns would be as many as there are losses; but at any time only q = (x, v, f, next f), the state and
/// the two forces that act on it, can reach later positions. So four coordinates c with q = Q c are enough:
/// whenever a lost force enters, the one direction of c that no longer reaches q is eliminated from the
/// triangle for good (a square-root information filter, Bierman 1977). The cost of a loss is that of some
/// rows, whatever their number. Every lost force has a row of its own that holds it to its prior.
///
/// The rows of the problem are (c, fixed columns, other columns, right-hand side): as usual the fixed and
/// coordinate columns are eliminated from the others in the end.
class LostForceColumns {
public:
    static constexpr Eigen::Index coordinates = 4;

    /// `fixed` columns are unknowns too (the offset), `others` are everything after them.
    LostForceColumns(const OutputErrorProblem& problem, Eigen::Index fixed, Eigen::Index others);

    /// To the first sample, for the dynamics of this walk; the last column is that of the residuals at the
    /// lost forces `assumed`.
    void start(const CascadeWalk& walk, double speed, const std::vector<double>& assumed, bool freeStart);
    /// A new row of the problem, its coordinate columns filled in.
    [[nodiscard]] auto nextRow()
    {
        auto row = m_qr.nextRow();
        row.head<coordinates>() = m_position * m_reach;
        return row;
    }
    void advance();
    /// Instead of leaving the row to solve(): what all that was taken out, as far as the rows before tell it,
    /// leaves of the row's other columns.
    [[nodiscard]] auto takeOut() { return m_qr.takeOut(coordinates + m_fixed); }
    /// Folds the rows of the priors, which must not wait for the next row when that is to be taken out.
    void foldPriors() { (void)m_qr.triangle(); }

    /// What start, lost forces and fixed columns explain of the other columns.
    struct Solution {
        bool finite = false;
        Eigen::Index rank = 0;
        SmallMatrix rest;               ///< as of ColumnElimination
        Eigen::Matrix2Xd start;         ///< of x0 and v0 on each other column
        SmallMatrix fixed;              ///< of the fixed columns
        Eigen::MatrixXd lostForces;     ///< of each lost force
        Eigen::VectorXd explainedPower; ///< of each other column: squares taken out
    };
    [[nodiscard]] Solution solve();

private:
    /// One direction that was eliminated: `row` is pivot * z + the other columns.
    struct Eliminated {
        Eigen::Matrix4d turn; ///< columns: new coordinates (three) and z in the old ones
        Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, largestSmallMatrix> row;
        bool observed = false;
        std::size_t lost = 0; ///< which lost force entered
    };
    void enter(std::size_t lost);
    void addPrior(std::size_t lost, Eigen::Index coordinate, double unit);
    [[nodiscard]] double unitOf(std::size_t lost) const;
    void eliminate(Eliminated& event);
    void substituteBack(Solution& solution, SmallMatrix coordinatesSolution) const;

    const OutputErrorProblem& m_problem;
    Eigen::Index m_fixed, m_others;
    TallQr m_qr;
    Eigen::Matrix4d m_reach = Eigen::Matrix4d::Zero(); ///< Q
    Eigen::RowVector4d m_position = Eigen::RowVector4d::Zero();
    Eigen::Matrix<double, 2, 4> m_step = Eigen::Matrix<double, 2, 4>::Zero();
    double m_speed = 1, m_moved = 1; ///< m_moved: the state's answer to a unit of force for one sample
    const std::vector<double>* m_assumed = nullptr;
    std::ptrdiff_t m_time = 0;
    std::size_t m_next = 0; ///< index in problem.lost of the next lost sample to enter
    std::vector<Eliminated> m_eliminated;
};

/// What the measured samples of `series` keep when the lost forces are taken out of them, sample by sample,
/// as far as their priors and the samples before tell them. A row a regressor (at most 16), the last one the
/// residual at the lost forces `assumed`; a column a sample from firstRow() to endRow() there, a measured one
/// in the result. This is an orthogonal change of the rows: the least-squares problem that is left is the
/// same, and noise that was white stays so, however many forces were lost.
[[nodiscard]] Eigen::MatrixXd withoutLostForces(const OutputErrorProblem& problem,
                                                const Eigen::Vector3d& theta,
                                                const std::vector<double>& assumed,
                                                const Eigen::MatrixXd& series);

} // namespace gripscope
