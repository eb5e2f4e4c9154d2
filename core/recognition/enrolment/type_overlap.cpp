// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/math/distributions.h"
#include "core/math/gaussian.h"
#include "core/recognition/enrolment/enrollment_guidance.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/types/squeeze_values.h"
#include "core/recognition/verdict/quantity_text.h"
#include "core/recognition/verdict/verdict_by_space.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Squeezes of a type as its predictive distribution says: mean + L z sqrt(v / chi2_{v-p+1}), L L' = V.
class PredictedSqueezes {
public:
    explicit PredictedSqueezes(const TypePrediction& type)
        : m_mean(type.meanLog), m_degrees(type.degreesOfFreedom),
          m_factor(LogMatrix((1 + 1 / type.effectiveSqueezes) * type.covariance).llt().matrixL())
    {
    }

    LogVector operator()()
    {
        LogVector z(m_mean.size());
        for (double& value : z)
            value = m_noise();
        const double chiSquared =
            chiSquaredQuantile(1 - m_noise.uniform(), m_degrees - double(m_mean.size() - 1));
        return m_mean + std::sqrt(m_degrees / chiSquared) * (m_factor * z);
    }

private:
    GaussianNoise m_noise{1};
    LogVector m_mean;
    double m_degrees;
    LogMatrix m_factor;
};

void count(const Verdict& verdict, const QString& type, double share, ExpectedVerdicts& expected)
{
    switch (verdict.kind) {
    case VerdictKind::Type:
        (verdict.type == type ? expected.named : expected.wrong[verdict.type]) += share;
        break;
    case VerdictKind::Inconclusive: {
        const QString other = verdict.nearest != type   ? verdict.nearest
                              : verdict.heldForStranger ? QString()
                                                        : verdict.rival;
        (other.isEmpty() ? expected.undecidedAlone : expected.undecided[other]) += share;
        break;
    }
    case VerdictKind::Unknown:
    case VerdictKind::Invalid:
        expected.unknown += share;
        break;
    }
}

std::optional<TypePrediction> predicted(const TypeModels& models, const QString& type,
                                        const VerdictOptions& options)
{
    const TypeModel* model = models.find(type);
    if (!model || models.degreesOfFreedom < 1)
        return {};
    TypePrediction own = predictType(models, *model, model->meanLog, {}, {options.robust});
    return own.degreesOfFreedom >= models.space.dimensions() ? std::optional(std::move(own)) : std::nullopt;
}

/// "12 in 100", "3 in 1,000".
Finding oftenness(double share)
{
    if (share >= 0.01)
        return Words::say("%1 in 100").arg(shortNumber(std::round(100 * share)));
    return Words::say("%1 in 1,000").arg(shortNumber(std::ceil(1000 * share)));
}

} // namespace

std::optional<ExpectedVerdicts> expectedVerdicts(const ModelsBySpace& types, const QString& type,
                                                 const VerdictOptions& options, int draws)
{
    // What it determines by itself, or what all do where it has too few squeezes to be known in that.
    for (const ModelsBySpace::Models& models : {types.modelsAmong({type}), types.whole()}) {
        const std::optional<TypePrediction> own = predicted(*models, type, options);
        if (!own || draws < 1)
            continue;
        PredictedSqueezes next(*own);
        ExpectedVerdicts expected;
        for (int draw = 0; draw < draws; ++draw)
            count(judge(types, squeezeAt({}, models->space, next()), options), type, 1.0 / draws, expected);
        return expected;
    }
    return {};
}

std::optional<TypeOverlap> worstOverlap(const ModelsBySpace& types, const QString& type,
                                        const VerdictOptions& options)
{
    const auto expected = expectedVerdicts(types, type, options);
    if (!expected)
        return {};
    std::optional<TypeOverlap> worst;
    for (const TypeModel& other : types.whole()->types) {
        const TypeOverlap overlap{type, other.name, expected->undecided.value(other.name),
                                  expected->wrong.value(other.name), 0};
        const double taken = overlap.undecided + overlap.wrong;
        if (taken > 0 && (!worst || taken > worst->undecided + worst->wrong))
            worst = overlap;
    }
    if (!worst)
        return {};
    if (const auto others = expectedVerdicts(types, worst->other, options))
        worst->back = others->undecided.value(type) + others->wrong.value(type);
    return worst;
}

Finding inWords(const TypeOverlap& overlap)
{
    Finding text = Words::say("%1 and %2 overlap: of the squeezes of %1, about %3 cannot be told from %2")
                       .arg(overlap.type, overlap.other, oftenness(overlap.undecided + overlap.wrong));
    if (overlap.wrong > 0)
        text += Words::say(", and %1 are called %2").arg(oftenness(overlap.wrong), overlap.other);
    if (overlap.back > 0)
        text += Words::say("; of those of %2, about %3 cannot be told from %1")
                    .arg(overlap.type, overlap.other, oftenness(overlap.back));
    return text + u"."_s;
}

} // namespace gripscope
