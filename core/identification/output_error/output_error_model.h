// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error/output_error_cascade.h"
#include "core/identification/output_error/output_error_problem.h"
#include "core/math/decompositions.h"
#include "core/math/sequential_qr.h"

#include <Eigen/Core>

#include <functional>
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
    SequentialQr m_qr;
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

/// The best x0, v0, offset and lost forces for given m, b, k: they enter linearly, so that they are one
/// linear least-squares solution away (variable projection, Golub and Pereyra 1973). Here the forces of lost
/// samples are those of the problem, and the lost rows do not count.
struct ResponseFit {
    bool finite = false;
    /// The factor on the forced response (the compliance) that would fit best, and the sum of squared
    /// residuals with it.
    double gain = 1, costWithGain = 0;
    /// The share of the forced response that x0, v0 and offset cannot imitate: at rounding level for a
    /// constant force.
    double ownShare = 0;
};
[[nodiscard]] ResponseFit fitResponse(const OutputErrorProblem& problem, const Eigen::Vector3d& theta);

/// The problem linearised at theta in everything that is unknown, with all that enters linearly (x0, v0,
/// offset, lost forces) solved for.
struct Linearization {
    bool finite = false;
    double cost = 0;         ///< sum of squared residuals with the best linear unknowns
    ScaledNuisance nuisance; ///< those
    int nuisanceRank = 0;    ///< how many of them the data determines
    Eigen::Matrix3d triangle =
        Eigen::Matrix3d::Zero();                     ///< R of d x / d theta, the linear unknowns' share out
    Eigen::Vector3d right = Eigen::Vector3d::Zero(); ///< min |triangle d theta - right| is the step to go
    /// The share of the response that the linear unknowns cannot imitate: at rounding level for a constant
    /// force.
    double ownShare = 0;
    /// The sensitivities are those at the linear unknowns that were assumed: how much the best ones differ in
    /// what they add to the response, as a share of the sensitivities.
    double stale = 0;
    /// d (x0, v0, offset, lost forces) / d theta.
    Eigen::MatrixX3d nuisanceSlope;

    /// The linear unknowns to be expected after a step in theta.
    [[nodiscard]] ScaledNuisance nuisanceAfter(const Eigen::Vector3d& step) const;
};

/// One pass over the record for each theta gives cost and sensitivities together; the memory for it is kept
/// between the passes.
class ResponseLinearizer {
public:
    explicit ResponseLinearizer(const OutputErrorProblem& problem);

    /// At theta, with sensitivities for the linear unknowns `assumed`.
    [[nodiscard]] Linearization at(const Eigen::Vector3d& theta, const ScaledNuisance& assumed);

private:
    [[nodiscard]] Linearization withoutLosses(const CascadeDynamics& dynamics, const ScaledNuisance& assumed);
    [[nodiscard]] Linearization withLosses(const CascadeDynamics& dynamics, const ScaledNuisance& assumed);
    void finish(double explained, double raw, Linearization& out) const;

    const OutputErrorProblem& m_problem;
    SequentialQr m_qr;
    LostForceColumns m_lost;
    std::vector<double> m_force;
};

/// What to assume of the linear unknowns where nothing is known: rest, no offset, the problem's own forces.
[[nodiscard]] ScaledNuisance unknownNuisance(const OutputErrorProblem& problem);

/// Calls `use(row, columns)` for every row of the linearised problem, columns being x0, v0, offset (those
/// that are free), ln M, ln B, ln K and the residual. Lost rows do not appear, and lost forces are no
/// columns: response_sensitivities.h takes their share out.
void forEachLinearizedRow(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                          const ScaledNuisance& nuisance,
                          const std::function<void(std::ptrdiff_t, const Eigen::RowVectorXd&)>& use);

} // namespace gripscope
