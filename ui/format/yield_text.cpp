// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/yield_text.h"

#include "core/base/words.h"
#include "core/math/binomial_evidence.h"
#include "ui/format/number_format.h"

#include <QCoreApplication>

namespace gripscope {

namespace {

struct Yield {
    Q_DECLARE_TR_FUNCTIONS(Yield)
};

constexpr double eachSide = 0.975; ///< two bounds at this confidence hold the rate with 95 %

qint64 judged(const InspectionCounts& counts)
{
    return counts.asExpected + counts.otherType + counts.unknown;
}

} // namespace

QString yieldText(const InspectionCounts& counts)
{
    const qint64 parts = judged(counts);
    if (parts == 0)
        return {};
    const BinomialEvidence bounds = binomialEvidence(counts.asExpected, parts, eachSide);
    return Yield::tr("%1 as expected (%2 to %3)")
        .arg(formatPercent(100.0 * static_cast<double>(counts.asExpected) / static_cast<double>(parts)),
             Words::number(100 * bounds.lowest, 'f', 1), formatPercent(100 * bounds.highest));
}

QString yieldExplained(const InspectionCounts& counts)
{
    return Yield::tr("%1 of %2 parts that were judged were as expected. In brackets: where the rate itself "
                     "lies with 95 % confidence (exact bounds). Squeezes that were not valid or inconclusive "
                     "judged nothing, and are left out.")
        .arg(formatCount(counts.asExpected), formatCount(judged(counts)));
}

} // namespace gripscope
