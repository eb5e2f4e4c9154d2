// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/binomial_evidence.h"

#include "core/base/words.h"
#include "core/math/distributions.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Finding percentText(double share)
{
    return Finding::number(100 * share, 'g', 2) + u" %"_s;
}

} // namespace

BinomialEvidence binomialEvidence(std::int64_t failures, std::int64_t trials, double confidence)
{
    BinomialEvidence evidence{failures, trials};
    if (trials <= 0 || failures < 0 || failures > trials || !(confidence > 0 && confidence < 1))
        return {};
    const auto k = double(failures);
    const auto n = double(trials);
    if (failures > 0)
        evidence.lowest = betaQuantile(1 - confidence, k, n - k + 1);
    if (failures < trials)
        evidence.highest = betaQuantile(confidence, k + 1, n - k);
    return evidence;
}

std::optional<std::int64_t> trialsNeeded(double rate, double confidence)
{
    if (!(rate > 0 && rate < 1) || !(confidence > 0 && confidence < 1))
        return {};
    const double trials = std::ceil(std::log1p(-confidence) / std::log1p(-rate));
    return trials <= 1e15 ? std::optional(std::int64_t(trials)) : std::nullopt;
}

Finding inWords(const BinomialEvidence& evidence, double statedRate, double confidence)
{
    Finding text = Words::say("%1 wrong of %2: at most %3 with %4 confidence")
                       .arg(evidence.failures)
                       .arg(evidence.trials)
                       .arg(percentText(evidence.highest), percentText(confidence));
    const std::optional<std::int64_t> needed = trialsNeeded(statedRate, confidence);
    if (evidence.highest > statedRate && needed)
        text +=
            Words::say("; %1 without one are needed to show %2").arg(*needed).arg(percentText(statedRate));
    return text + u"."_s;
}

} // namespace gripscope
