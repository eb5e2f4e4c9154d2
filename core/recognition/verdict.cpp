// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict.h"

#include "core/recognition/verdict_reasons.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double leastRate = 1e-6; ///< beyond it tails of a distribution are only belief
constexpr double mostRate = 0.5;

double spread(const TypeModel& type)
{
    return 1 + 1.0 / type.squeezes;
}

/// Logarithm of a type's predictive density, up to what all types share.
double logPredictive(const TypeModels& models, const TypeModel& type, double squaredDistance)
{
    if (models.degreesOfFreedom == 0)
        return 0;
    const double v = std::max(3, models.degreesOfFreedom);
    return -1.5 * std::log(spread(type)) - (v + 1) / 2 * std::log1p(squaredDistance / (v * spread(type)));
}

/// exp(log weight) over their sum, the largest taken out first so that nothing underflows to 0/0.
QMap<QString, double> normalised(const std::vector<TypeModel>& types, const std::vector<double>& logWeights)
{
    const double largest = *std::max_element(logWeights.begin(), logWeights.end());
    double total = 0;
    for (double weight : logWeights)
        total += std::exp(weight - largest);
    QMap<QString, double> posterior;
    for (std::size_t i = 0; i < types.size(); ++i)
        posterior.insert(types[i].name, std::exp(logWeights[i] - largest) / total);
    return posterior;
}

/// Places of the types in TypeModels, the nearest first.
std::vector<std::size_t> byDistance(const TypeModels& models, const std::vector<double>& distances)
{
    std::vector<std::size_t> order(models.types.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return distances[a] / spread(models.types[a]) < distances[b] / spread(models.types[b]);
    });
    return order;
}

/// Without a covariance the nearest is the nearest in plain logarithms.
double distanceOrPlain(const TypeModels& models, const TypeModel& type,
                       const MassDampingStiffness& parameters)
{
    const Eigen::Vector3d difference = parameters.vector().array().log().matrix() - type.meanLog;
    return squaredDistance(models, type, parameters).value_or(difference.squaredNorm());
}

QString mostProbable(const QMap<QString, double>& posterior)
{
    auto best = posterior.cbegin();
    for (auto it = posterior.cbegin(); it != posterior.cend(); ++it)
        if (it.value() > best.value())
            best = it;
    return best.key();
}

} // namespace

QString toString(VerdictKind kind)
{
    switch (kind) {
    case VerdictKind::Type:
        return u"type"_s;
    case VerdictKind::Unknown:
        return u"unknown"_s;
    case VerdictKind::Inconclusive:
        return u"inconclusive"_s;
    case VerdictKind::Invalid:
        return u"invalid"_s;
    }
    return {};
}

std::optional<VerdictKind> verdictKindFromString(const QString& text)
{
    for (VerdictKind kind :
         {VerdictKind::Type, VerdictKind::Unknown, VerdictKind::Inconclusive, VerdictKind::Invalid})
        if (toString(kind) == text)
            return kind;
    return {};
}

std::optional<Error> VerdictOptions::validate() const
{
    const auto check = [](const QString& name, double rate) -> std::optional<Error> {
        if (rate >= leastRate && rate <= mostRate)
            return {};
        return Error{
            ErrorCode::Usage,
            {u"The rate %1 must be between %2 and %3, not %4."_s.arg(name).arg(leastRate).arg(mostRate).arg(
                rate)}};
    };
    if (auto problem = check(u"false-reject"_s, falseReject))
        return problem;
    return check(u"wrong-type"_s, wrongType);
}

Verdict judge(const TypeModels& models, const MassDampingStiffness& parameters, const VerdictOptions& options)
{
    Verdict verdict;
    const Eigen::Vector3d p = parameters.vector();
    if (!p.allFinite() || p.minCoeff() <= 0) {
        verdict.reasons = {
            QCoreApplication::translate("Verdict", "Mass, damping and stiffness are not all above zero.")};
        return verdict;
    }
    verdict.kind = VerdictKind::Inconclusive;
    if (models.types.empty()) {
        verdict.reasons = noGateReasons(models);
        return verdict;
    }
    std::vector<double> distances, logWeights;
    for (const TypeModel& type : models.types) {
        distances.push_back(distanceOrPlain(models, type, parameters));
        logWeights.push_back(logPredictive(models, type, distances.back()));
    }
    const std::vector<std::size_t> order = byDistance(models, distances);
    const TypeModel& nearest = models.types[order.front()];
    verdict.nearest = nearest.name;
    verdict.posterior = normalised(models.types, logWeights);
    verdict.distance = squaredDistance(models, nearest, parameters);
    verdict.gate = falseRejectGate(nearest.squeezes, models.degreesOfFreedom, options.falseReject);
    if (!verdict.gate || !verdict.distance) {
        verdict.reasons = noGateReasons(models);
    } else if (*verdict.distance > *verdict.gate) {
        verdict.kind = VerdictKind::Unknown;
        verdict.reasons = unknownReasons(models, nearest, parameters, options);
    } else if (mostProbable(verdict.posterior) == nearest.name &&
               verdict.posterior[nearest.name] >= 1 - options.wrongType) {
        verdict.kind = VerdictKind::Type;
        verdict.type = nearest.name;
        const TypeModel* next = order.size() > 1 ? &models.types[order[1]] : nullptr;
        verdict.reasons = typeReasons(models, nearest, next, parameters, options);
    } else {
        verdict.reasons = betweenTypesReasons(verdict);
    }
    return verdict;
}

Verdict judge(const TypeModels& models, const Identification& identification, double siScale,
              const VerdictOptions& options)
{
    const Estimate* best = identification.best();
    Verdict verdict;
    if (identification.validity.verdict == ValidityVerdict::Invalid || !best || !best->parameters) {
        verdict.reasons = invalidReasons(identification);
    } else {
        const MassDampingStiffness& p = *best->parameters;
        verdict = judge(models, MassDampingStiffness{p.m * siScale, p.b * siScale, p.k * siScale}, options);
    }
    verdict.samplesUsed = identification.choice.window.count;
    return verdict;
}

int leaveOneOutCorrect(const std::vector<TypeSqueeze>& squeezes, const VerdictOptions& options)
{
    int correct = 0;
    for (std::size_t left = 0; left < squeezes.size(); ++left) {
        std::vector<TypeSqueeze> others = squeezes;
        others.erase(others.begin() + std::ptrdiff_t(left));
        const Verdict verdict = judge(fitTypeModels(others), squeezes[left].parameters, options);
        correct += verdict.kind == VerdictKind::Type && verdict.type == squeezes[left].type;
    }
    return correct;
}

} // namespace gripscope
