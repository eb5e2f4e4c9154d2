// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/binomial_evidence.h"

#include "core/recognition/quiet_policy.h"
#include "core/words.h"

#include <QLocale>
#include <boost/math/distributions/beta.hpp>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Beta = boost::math::beta_distribution<double, QuietPolicy>;

QString percent(double share)
{
    return Words::number(100 * share, 'g', 2) + u" %"_s;
}

QString whole(std::int64_t number)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::DefaultNumberOptions); // with separators
    return locale.toString(qlonglong(number));
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
        evidence.lowest = boost::math::quantile(Beta(k, n - k + 1), 1 - confidence);
    if (failures < trials)
        evidence.highest = boost::math::quantile(Beta(k + 1, n - k), confidence);
    return evidence;
}

std::optional<std::int64_t> trialsNeeded(double rate, double confidence)
{
    if (!(rate > 0 && rate < 1) || !(confidence > 0 && confidence < 1))
        return {};
    const double trials = std::ceil(std::log1p(-confidence) / std::log1p(-rate));
    return trials <= 1e15 ? std::optional(std::int64_t(trials)) : std::nullopt;
}

QString inWords(const BinomialEvidence& evidence, double statedRate, double confidence)
{
    QString text = Words::tr("%1 wrong of %2: at most %3 with %4 confidence")
                       .arg(whole(evidence.failures), whole(evidence.trials), percent(evidence.highest),
                            percent(confidence));
    const std::optional<std::int64_t> needed = trialsNeeded(statedRate, confidence);
    if (evidence.highest > statedRate && needed)
        text += Words::tr("; %1 without one are needed to show %2").arg(whole(*needed), percent(statedRate));
    return text + u'.';
}

} // namespace gripscope
