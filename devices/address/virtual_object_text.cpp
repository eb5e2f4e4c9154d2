// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/recognition/types/paper_appendix.h"
#include "core/recognition/types/simulated_parts.h"
#include "devices/address/virtual_object.h"

#include <Eigen/Eigenvalues>
#include <QStringList>

#include <cmath>

namespace gripscope {

namespace {

struct LogMoments {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

LogMoments logMoments(const QString& type)
{
    std::vector<Eigen::Vector3d> logs;
    for (const TypeSqueeze& squeeze : paperSqueezesInSi())
        if (squeeze.type == type)
            logs.push_back(squeeze.parameters.vector().array().log().matrix());
    LogMoments moments;
    for (const Eigen::Vector3d& log : logs)
        moments.mean += log / static_cast<double>(logs.size());
    for (const Eigen::Vector3d& log : logs)
        moments.covariance +=
            (log - moments.mean) * (log - moments.mean).transpose() / static_cast<double>(logs.size() - 1);
    return moments;
}

Eigen::Matrix3d squareRoot(const Eigen::Matrix3d& covariance)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    const Eigen::Vector3d roots = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    return solver.eigenvectors() * roots.asDiagonal() * solver.eigenvectors().transpose();
}

const QStringList& paperTypes()
{
    static const QStringList types{QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C"),
                                   QStringLiteral("D")};
    return types;
}

Eigen::Matrix3d pooledCovariance()
{
    Eigen::Matrix3d pooled = Eigen::Matrix3d::Zero();
    for (const QString& type : paperTypes())
        pooled += logMoments(type).covariance / static_cast<double>(paperTypes().size());
    return pooled;
}

QString simulatedKeys()
{
    QStringList keys;
    for (const SimulatedPart& part : simulatedParts())
        keys << part.key;
    return keys.join(QStringLiteral(", "));
}

std::optional<MassDampingStiffness> parseParameters(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char(','));
    if (parts.size() != 3)
        return std::nullopt;
    std::array<double, 3> values{};
    for (int i = 0; i < 3; ++i) {
        bool isNumber = false;
        values[static_cast<std::size_t>(i)] = parts[i].trimmed().toDouble(&isNumber);
        if (!isNumber || !std::isfinite(values[static_cast<std::size_t>(i)]))
            return std::nullopt;
    }
    const bool sensible = values[0] >= 1e-6 && values[0] <= 1e3 && values[1] >= 0 && values[1] <= 1e6 &&
                          values[2] >= 1 && values[2] <= 1e9;
    if (!sensible)
        return std::nullopt;
    return MassDampingStiffness{values[0], values[1], values[2]};
}

} // namespace

Expected<VirtualObject> VirtualObject::fromText(const QString& text)
{
    VirtualObject object;
    if (paperTypes().contains(text)) {
        const LogMoments moments = logMoments(text);
        const Eigen::Vector3d centre = moments.mean.array().exp().matrix();
        object.m_centre = {centre[0], centre[1], centre[2]};
        object.m_scatter = squareRoot(pooledCovariance());
        return object;
    }
    const SimulatedPart* const simulated = simulatedPart(text);
    const std::optional<MassDampingStiffness> parameters =
        simulated != nullptr ? simulated->centre : parseParameters(text);
    if (!parameters)
        return failure(
            ErrorCode::Usage,
            {Words::tr("object=%1 is not an object: A, B, C or D, %2, or m,b,k as m in kg (1e-6 to 1e3), b "
                       "in N s/m (0 to 1e6) and k in N/m (1 to 1e9), such as 0.04,43,9990")
                 .arg(text, simulatedKeys())});
    object.m_centre = *parameters;
    object.m_scatter = squareRoot(pooledCovariance());
    return object;
}

} // namespace gripscope
