// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/enroll_live_words.h"

#include "ui/widgets/parameter_text.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

QString threeLines(const QString& k, const QString& b, const QString& m)
{
    return LiveSqueezeWords::tr("k  %1\nb  %2\nm  %3").arg(k, b, m);
}

LiveSqueezeWords liveSqueezeWords(const std::optional<RecursiveState>& state, const QString& forceUnit,
                                  const QString& positionUnit)
{
    const QString none = u"–"_s;
    if (!state || !state->parameters)
        return {threeLines(none, none, none), LiveSqueezeWords::tr("Not enough of the squeeze yet.")};
    std::optional<Eigen::Vector3d> errors;
    if (state->covariance)
        errors = state->covariance->diagonal().cwiseMax(0.0).cwiseSqrt();
    const ParameterTexts texts = parameterTexts(*state->parameters, errors, forceUnit, positionUnit);
    LiveSqueezeWords words{threeLines(texts.k.text(), texts.b.text(), texts.m.text()), {}};
    const double k = state->parameters->k;
    words.quality = errors && k > 0 ? LiveSqueezeWords::tr("Stiffness known to %1 so far.")
                                          .arg(formatPercent(100 * 1.96 * (*errors)[2] / k))
                                    : LiveSqueezeWords::tr("Still searching.");
    return words;
}

} // namespace gripscope
