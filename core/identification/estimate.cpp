// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/estimate.h"

#include <array>
#include <cmath>
#include <utility>

namespace gripscope {

namespace {

constexpr std::array<std::pair<Estimator, const char*>, 7> estimatorNames{
    {{Estimator::Arx, "arx"},
     {Estimator::ArxMeanForce, "arx-mean-force"},
     {Estimator::Arx221, "arx221"},
     {Estimator::InstrumentalVariables, "iv"},
     {Estimator::OutputError, "oe"},
     {Estimator::Duffing, "duffing"},
     {Estimator::Periodic, "periodic"}}};

} // namespace

QString toString(Estimator estimator)
{
    for (const auto& entry : estimatorNames) {
        if (entry.first == estimator)
            return QString::fromLatin1(entry.second);
    }
    return {};
}

std::optional<Estimator> estimatorFromString(const QString& text)
{
    for (const auto& entry : estimatorNames) {
        if (text == QLatin1String(entry.second))
            return entry.first;
    }
    return std::nullopt;
}

QString toString(EstimateStatus status)
{
    switch (status) {
    case EstimateStatus::Converged:
        return QStringLiteral("converged");
    case EstimateStatus::NotConverged:
        return QStringLiteral("not_converged");
    case EstimateStatus::NotIdentifiable:
        return QStringLiteral("not_identifiable");
    case EstimateStatus::NoPhysicalMapping:
        return QStringLiteral("no_physical_mapping");
    case EstimateStatus::TooFewSamples:
        return QStringLiteral("too_few_samples");
    case EstimateStatus::NotApplicable:
        return QStringLiteral("not_applicable");
    }
    return {};
}

std::optional<Eigen::Vector3d> Estimate::standardErrors() const
{
    if (!covariance)
        return std::nullopt;
    return covariance->diagonal().cwiseMax(0.0).cwiseSqrt();
}

} // namespace gripscope
