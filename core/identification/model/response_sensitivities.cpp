// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/response_sensitivities.h"

#include "core/identification/model/exact_step.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// Time in samples: K/M and B/M. The state is (x, x'/speed, w speed^2, w' speed), which keeps the matrix
/// balanced where the natural frequency is above one radian a sample.
struct SensitivityCascade {
    double stiffness, damping, compliance, speed;
    ExactStep<4> step;

    SensitivityCascade(const MassDampingStiffness& p, const SensitivityOptions& options)
        : stiffness(p.k / p.m * options.sampleTime_s * options.sampleTime_s),
          damping(p.b / p.m * options.sampleTime_s),
          compliance(options.sampleTime_s * options.sampleTime_s / p.m),
          speed(std::max(1.0, std::sqrt(stiffness)))
    {
        if (!usable())
            return;
        Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
        a(0, 1) = a(2, 3) = speed;
        a(1, 0) = a(3, 2) = -stiffness / speed;
        a(1, 1) = a(3, 3) = -damping;
        a(3, 0) = speed;
        step = exactStep<4>(a, Eigen::Vector4d(0, 1 / speed, 0, 0), options.hold);
    }
    /// Beyond these the exponential itself leaves the range of numbers.
    [[nodiscard]] bool usable() const
    {
        constexpr double largest = 1e6;
        return std::isfinite(compliance) && compliance > 0 && stiffness >= 0 &&
               stiffness < largest * largest && damping >= 0 && damping < largest;
    }
};

/// Modified Gram-Schmidt, twice; a column that the others explain adds nothing.
class Basis {
public:
    Basis(Eigen::Index rows, Eigen::Index most) : m_columns(rows, most) {}
    void add(Eigen::VectorXd column)
    {
        constexpr double dependent = 1e-12;
        const double size = column.norm();
        for (int pass = 0; pass < 2; ++pass) {
            for (Eigen::Index i = 0; i < m_count; ++i)
                column -= m_columns.col(i) * m_columns.col(i).dot(column);
        }
        const double left = column.norm();
        if (left > dependent * size)
            m_columns.col(m_count++) = column / left;
    }
    [[nodiscard]] Eigen::MatrixXd columns() const { return m_columns.leftCols(m_count); }

private:
    Eigen::MatrixXd m_columns;
    Eigen::Index m_count = 0;
};

Eigen::MatrixXd nuisanceBasis(const Eigen::Matrix2d& phi, Eigen::Index rows,
                              const SensitivityOptions& options)
{
    Basis basis(rows, 3);
    if (options.freeInitialState) {
        Eigen::MatrixX2d free(rows, 2);
        Eigen::RowVector2d response(1, 0);
        for (Eigen::Index t = 0; t < rows; ++t) {
            free.row(t) = response;
            response = (response * phi).eval();
            if (response.cwiseAbs().maxCoeff() < 1e-150) // before the slow denormal numbers
                response.setZero();
        }
        basis.add(free.col(0));
        basis.add(free.col(1));
    }
    if (options.freeOffset)
        basis.add(Eigen::VectorXd::Ones(rows));
    return basis.columns();
}

} // namespace

ResponseSensitivities responseSensitivities(const MassDampingStiffness& parameters,
                                            std::span<const double> force, const SensitivityOptions& options)
{
    ResponseSensitivities result;
    const auto rows = static_cast<Eigen::Index>(force.size());
    result.position.setZero(rows);
    result.parameters.setZero(rows, 3);
    const SensitivityCascade cascade(parameters, options);
    if (!cascade.usable())
        return result;
    Eigen::Vector4d state = Eigen::Vector4d::Zero();
    for (Eigen::Index t = 0; t < rows; ++t) {
        const double byStiffness = -cascade.stiffness * state(2) / (cascade.speed * cascade.speed);
        const double byDamping = -cascade.damping * state(3) / cascade.speed;
        result.position(t) = cascade.compliance * state(0);
        result.parameters.row(t) =
            cascade.compliance *
            Eigen::RowVector3d(-state(0) - byDamping - byStiffness, byDamping, byStiffness);
        const double now = force[static_cast<std::size_t>(t)];
        const double next = force[static_cast<std::size_t>(std::min(t + 1, rows - 1))];
        state = (cascade.step.phi * state + cascade.step.gamma0 * now + cascade.step.gamma1 * next).eval();
        if (state.cwiseAbs().maxCoeff() < 1e-150)
            state.setZero();
    }
    result.nuisances = nuisanceBasis(cascade.step.phi.topLeftCorner<2, 2>(), rows, options);
    result.finite = result.position.allFinite() && result.parameters.allFinite();
    return result;
}

Eigen::Matrix3d fisherInformation(const ResponseSensitivities& sensitivities)
{
    Eigen::MatrixX3d rest = sensitivities.parameters;
    if (sensitivities.nuisances.cols() > 0)
        rest -= sensitivities.nuisances * (sensitivities.nuisances.transpose() * rest);
    return rest.transpose() * rest;
}

std::optional<Eigen::Matrix3d> inverseInformation(const Eigen::Matrix3d& information)
{
    const Eigen::Vector3d diagonal = information.diagonal();
    if (!information.allFinite() || !(diagonal.minCoeff() > 0))
        return std::nullopt;
    const Eigen::Vector3d scale = diagonal.cwiseSqrt().cwiseInverse();
    const Eigen::Matrix3d scaled = scale.asDiagonal() * information * scale.asDiagonal();
    const Eigen::LLT<Eigen::Matrix3d> factors(scaled);
    constexpr double singular = 1e-7; // its square is the reciprocal condition number
    if (!scaled.allFinite() || factors.info() != Eigen::Success ||
        !(Eigen::Matrix3d(factors.matrixL()).diagonal().minCoeff() > singular))
        return std::nullopt;
    const Eigen::Matrix3d inverse =
        scale.asDiagonal() * factors.solve(Eigen::Matrix3d::Identity()).eval() * scale.asDiagonal();
    return inverse.allFinite() ? std::optional(inverse) : std::nullopt;
}

std::optional<Eigen::Vector3d> cramerRaoBound(const MassDampingStiffness& parameters,
                                              std::span<const double> force,
                                              const SensitivityOptions& options, double noiseDeviation)
{
    const ResponseSensitivities sensitivities = responseSensitivities(parameters, force, options);
    if (!sensitivities.finite)
        return std::nullopt;
    const std::optional<Eigen::Matrix3d> inverse = inverseInformation(fisherInformation(sensitivities));
    if (!inverse)
        return std::nullopt;
    const Eigen::Vector3d relative = noiseDeviation * inverse->diagonal().cwiseSqrt();
    return relative.cwiseProduct(parameters.vector());
}

} // namespace gripscope
