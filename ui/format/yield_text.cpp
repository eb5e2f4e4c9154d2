// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/yield_text.h"

#include "core/base/words.h"
#include "core/math/binomial_evidence.h"
#include "ui/format/number_format.h"

#include <QCoreApplication>

namespace gripscope {

namespace {

struct YieldWords {
    Q_DECLARE_TR_FUNCTIONS(Yield)
};

constexpr double eachSide = 0.975; ///< two bounds at this confidence hold the rate with 95 %

} // namespace

QString yieldText(const Yield& yield)
{
    const std::optional<double> share = yield.share();
    if (!share)
        return {};
    const BinomialEvidence bounds = binomialEvidence(yield.asExpected, yield.judged, eachSide);
    const QString words = yield.unasked == 0 ? YieldWords::tr("%1 as expected (%2 to %3)")
                          : yield.unasked == yield.judged
                              ? YieldWords::tr("%1 of a known type (%2 to %3)")
                              : YieldWords::tr("%1 as expected or of a known type (%2 to %3)");
    return words.arg(formatPercent(100.0 * *share), Words::number(100 * bounds.lowest, 'f', 1),
                     formatPercent(100 * bounds.highest));
}

QString yieldText(const InspectionCounts& counts)
{
    return yieldText(yieldOf(counts));
}

QString yieldCounted(const InspectionCounts& counts)
{
    const QString words =
        counts.unasked == 0
            ? YieldWords::tr("%1 of %2 were as expected")
            : YieldWords::tr("%1 of %2 were of the expected type, or of a known one where none was expected");
    return words.arg(formatCount(counts.asExpected), formatCount(counts.judged()));
}

QString yieldExplained(const Yield& yield)
{
    if (yield.unasked > 0)
        return YieldWords::tr(
                   "%1 of %2 parts that were judged were of the expected type, or of a known one "
                   "where none was expected. In brackets: where the rate itself lies with 95 % "
                   "confidence (exact bounds). Squeezes that were not valid or inconclusive judged "
                   "nothing, and are left out.")
            .arg(formatCount(yield.asExpected), formatCount(yield.judged));
    return YieldWords::tr(
               "%1 of %2 parts that were judged were as expected. In brackets: where the rate itself "
               "lies with 95 % confidence (exact bounds). Squeezes that were not valid or inconclusive "
               "judged nothing, and are left out.")
        .arg(formatCount(yield.asExpected), formatCount(yield.judged));
}

QString yieldExplained(const InspectionCounts& counts)
{
    return yieldExplained(yieldOf(counts));
}

} // namespace gripscope
