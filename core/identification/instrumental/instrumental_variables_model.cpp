// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/instrumental/instrumental_variables.h"
#include "core/identification/model/exact_step.h"
#include "core/math/decompositions.h"
#include "core/math/sequential_qr.h"

#include <cmath>

namespace gripscope {

namespace {

/// Rates in samples above which the matrix exponential has no digits left.
constexpr double fastestRate = 1e12;
/// Far below anything that counts beside positions of about 1, far above denormal numbers.
constexpr double vanishing = 1e-150;

/// M x'' + B x' + K x = F with w = x / (M s^2 + B s + K) behind it, sample by sample. The state is (x,
/// x'/speed, w M speed^2, w' M speed); speed keeps the matrices balanced.
class Cascade {
public:
    Cascade(const OutputErrorProblem& record, const Eigen::Vector3d& theta)
        : m_record(record), m_stiffness(std::exp(theta(2) - theta(0))),
          m_damping(std::exp(theta(1) - theta(0))), m_compliance(std::exp(-theta(0))),
          m_speed(std::max(1.0, std::sqrt(m_stiffness)))
    {
        m_finite = theta.allFinite() && m_stiffness < fastestRate && m_damping < fastestRate &&
                   m_compliance > 0 && std::isfinite(m_compliance);
        if (!m_finite)
            return;
        m_step = stepOver(1);
        m_part = stepOver(record.lag.rest);
    }
    [[nodiscard]] bool finite() const { return m_finite; }
    [[nodiscard]] double stiffness() const { return m_stiffness; }
    [[nodiscard]] double damping() const { return m_damping; }

    void start(double x0, double v0)
    {
        m_state << x0, v0 / m_speed, 0, 0;
        m_free.setIdentity();
    }
    void advance(std::ptrdiff_t n)
    {
        m_state = (m_step.phi * m_state + m_step.gamma0 * force(n) + m_step.gamma1 * force(n + 1)).eval();
        m_free = (m_step.phi.topLeftCorner<2, 2>() * m_free).eval();
        // Without force they decay; zero is faster than the denormal numbers they would end in.
        if (m_state.cwiseAbs().maxCoeff() < vanishing)
            m_state.setZero();
        if (m_free.cwiseAbs().maxCoeff() < vanishing)
            m_free.setZero();
    }
    /// Position, M w'', B w', K w at time n + rest.
    [[nodiscard]] Eigen::Vector4d outputs(std::ptrdiff_t n) const
    {
        Eigen::Vector4d s = m_state;
        const double rest = m_record.lag.rest;
        if (rest > 0) {
            const double end = (1 - rest) * force(n) + rest * force(n + 1);
            s = m_part.phi * m_state + m_part.gamma0 * force(n) + m_part.gamma1 * end;
        }
        const double byStiffness = m_stiffness * s(2) / (m_speed * m_speed);
        const double byDamping = m_damping * s(3) / m_speed;
        return {s(0), s(0) - byDamping - byStiffness, byDamping, byStiffness};
    }
    /// What a unit of x0 and of v0 adds to the position.
    [[nodiscard]] Eigen::RowVector2d freeResponses() const
    {
        const Eigen::RowVector2d x = m_part.phi.topLeftCorner<2, 2>().row(0) * m_free;
        return {x(0), x(1) / m_speed};
    }

private:
    [[nodiscard]] ExactStep<4> stepOver(double part) const
    {
        Eigen::Matrix2d motion;
        motion << 0, m_speed, -m_stiffness / m_speed, -m_damping;
        Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
        a.topLeftCorner<2, 2>() = motion;
        a.bottomRightCorner<2, 2>() = motion;
        a(3, 0) = m_speed;
        const Eigen::Vector4d b(0, part / m_speed, 0, 0);
        ExactStep<4> step = exactStep<4>(a * part, b, m_record.hold);
        step.gamma0 *= m_compliance;
        step.gamma1 *= m_compliance;
        return step;
    }
    [[nodiscard]] double force(std::ptrdiff_t n) const
    {
        const auto last = static_cast<std::ptrdiff_t>(m_record.force.size()) - 1;
        return m_record.force[static_cast<std::size_t>(std::min(n, last))];
    }
    const OutputErrorProblem& m_record;
    double m_stiffness, m_damping, m_compliance, m_speed;
    bool m_finite = false;
    ExactStep<4> m_step, m_part;
    Eigen::Vector4d m_state = Eigen::Vector4d::Zero();
    Eigen::Matrix2d m_free = Eigen::Matrix2d::Identity();
};

/// Calls use(index, cascade at that position's time) for every position whose time the force covers, those of
/// lost samples too.
template <typename Use>
void forEachRow(const OutputErrorProblem& record, Cascade& cascade, const Use& use)
{
    const std::ptrdiff_t begin = record.firstRow() + record.lag.samples;
    const std::ptrdiff_t end = record.endRow() + record.lag.samples;
    for (std::ptrdiff_t n = 0; n < end; ++n) {
        if (n >= begin)
            use(n - record.lag.samples, cascade.outputs(n));
        cascade.advance(n);
    }
}

template <typename Row>
void fillNuisances(const OutputErrorProblem& record, const Cascade& cascade, Row&& row)
{
    if (record.freeInitialState)
        row.template head<2>() = cascade.freeResponses();
    if (record.freeOffset)
        row(record.nuisanceCount() - 1) = 1;
}

/// M f(y''), B f(y'), K f(y) of the measured position, a straight line between its samples. The offset is
/// taken out first: without free responses in the equations its step would stay in them.
class MeasuredFilter {
public:
    MeasuredFilter(const OutputErrorProblem& record, const Cascade& cascade, double offset)
        : m_record(record), m_offset(offset), m_stiffness(cascade.stiffness()), m_damping(cascade.damping()),
          m_filter(m_stiffness, m_damping, ForceHold::First)
    {
    }
    [[nodiscard]] Eigen::RowVector3d regressors(std::ptrdiff_t index) const
    {
        return {m_filter.curvature(position(index)) / m_stiffness, m_filter.slope() * m_damping / m_stiffness,
                m_filter.value()};
    }
    void advance(std::ptrdiff_t index) { m_filter.advance(position(index), position(index + 1)); }

private:
    [[nodiscard]] double position(std::ptrdiff_t index) const
    {
        const auto last = static_cast<std::ptrdiff_t>(m_record.position.size()) - 1;
        return m_record.position[static_cast<std::size_t>(std::min(index, last))] - m_offset;
    }
    const OutputErrorProblem& m_record;
    double m_offset, m_stiffness, m_damping;
    SecondOrderFilter m_filter;
};

} // namespace

AuxiliaryModel auxiliaryModel(const OutputErrorProblem& record, const Eigen::Vector3d& theta)
{
    AuxiliaryModel model;
    model.theta = theta;
    Cascade cascade(record, theta);
    if (!cascade.finite())
        return model;
    const Eigen::Index nuisances = record.nuisanceCount();
    SequentialQr qr(nuisances + 2);
    forEachRow(record, cascade, [&](std::ptrdiff_t index, const Eigen::Vector4d& outputs) {
        if (record.isLost(index))
            return;
        auto row = qr.nextRow();
        fillNuisances(record, cascade, row);
        row(nuisances) = outputs(0);
        row(nuisances + 1) = record.position[static_cast<std::size_t>(index)];
    });
    const Eigen::MatrixXd triangle = qr.triangle();
    if (!triangle.allFinite())
        return model;
    const ColumnElimination elimination = eliminateColumns(triangle, nuisances, dependentNuisance);
    const Eigen::VectorXd forced = elimination.rest.col(0);
    const Eigen::VectorXd measured = elimination.rest.col(1);
    const double power = forced.squaredNorm();
    const double rawPower = triangle.col(nuisances).squaredNorm();
    model.gain = power > 0 ? forced.dot(measured) / power : 0;
    model.ownShare = rawPower > 0 ? std::sqrt(power / rawPower) : 0;
    model.cost = (measured - forced).squaredNorm();
    model.nuisanceRank = static_cast<int>(elimination.rank);
    if (nuisances > 0) {
        const Eigen::VectorXd best = elimination.solution.col(1) - elimination.solution.col(0);
        if (record.freeInitialState) {
            model.x0 = best(0);
            model.v0 = best(1);
        }
        if (record.freeOffset)
            model.offset = best(nuisances - 1);
    }
    model.finite = std::isfinite(model.cost) && std::isfinite(model.gain);
    return model;
}

InstrumentalEquations instrumentalEquations(const OutputErrorProblem& record, const AuxiliaryModel& model)
{
    InstrumentalEquations equations;
    Cascade cascade(record, model.theta);
    cascade.start(model.x0, model.v0);
    MeasuredFilter measured(record, cascade, model.offset);
    const Eigen::Index nuisances = record.nuisanceCount();
    SequentialQr qr(nuisances + 7);
    forEachRow(record, cascade, [&](std::ptrdiff_t index, const Eigen::Vector4d& outputs) {
        if (!record.isLost(index)) {
            auto row = qr.nextRow();
            fillNuisances(record, cascade, row);
            row.segment<3>(nuisances) = outputs.tail<3>().transpose();
            row.segment<3>(nuisances + 3) = measured.regressors(index);
            row(nuisances + 6) = record.position[static_cast<std::size_t>(index)] - outputs(0) - model.offset;
        }
        measured.advance(index);
    });
    const Eigen::MatrixXd triangle = qr.triangle();
    if (!triangle.allFinite())
        return equations;
    const ColumnElimination elimination = eliminateColumns(triangle, nuisances, dependentNuisance);
    equations.instruments = elimination.rest.leftCols(3);
    equations.regressors = elimination.rest.middleCols(3, 3);
    equations.residual = elimination.rest.col(6);
    equations.finite = true;
    return equations;
}

InstrumentRows instrumentRows(const OutputErrorProblem& record, const AuxiliaryModel& model)
{
    InstrumentRows rows;
    const Eigen::Index nuisances = record.nuisanceCount();
    rows.columns.resize(record.measuredRows(), nuisances + 3);
    rows.residuals.reserve(static_cast<std::size_t>(record.measuredRows()));
    Cascade cascade(record, model.theta);
    cascade.start(model.x0, model.v0);
    forEachRow(record, cascade, [&](std::ptrdiff_t index, const Eigen::Vector4d& outputs) {
        if (record.isLost(index))
            return;
        auto row = rows.columns.row(static_cast<Eigen::Index>(rows.residuals.size()));
        fillNuisances(record, cascade, row);
        row.segment<3>(nuisances) = outputs.tail<3>().transpose();
        rows.residuals.push_back(record.position[static_cast<std::size_t>(index)] - outputs(0) -
                                 model.offset);
    });
    return rows;
}

} // namespace gripscope
