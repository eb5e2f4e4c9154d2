// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/early_verdict.h"

#include "core/recognition/quantity_text.h"
#include "core/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString answer(VerdictKind kind, const QString& type)
{
    return kind == VerdictKind::Type ? type : Words::tr("unknown");
}

} // namespace

Verdict verdictOnEarlyEnd(Verdict verdict, const EarlyEnd& end, double decided_s)
{
    const QString seconds = shortNumber(decided_s);
    if (verdict.kind == VerdictKind::Invalid) {
        verdict.reasons += Words::tr("The squeeze had ended early, after %1 s.").arg(seconds);
        return verdict;
    }
    if (verdict.kind == end.kind && verdict.type == end.type) {
        verdict.reasons += Words::tr("Decided after %1 s.").arg(seconds);
        return verdict;
    }
    const QString decided = answer(end.kind, end.type);
    if (verdict.kind == VerdictKind::Inconclusive)
        verdict.reasons.prepend(
            Words::tr("The squeeze ended after %1 s as %2, but all that was recorded by then does "
                      "not show it.")
                .arg(seconds, decided));
    else
        verdict.reasons = {
            Words::tr("The squeeze ended after %1 s as %2, but all that was recorded by then says %3.")
                .arg(seconds, decided, answer(verdict.kind, verdict.type)),
            Words::tr("Squeeze it again.")};
    verdict.kind = VerdictKind::Inconclusive;
    verdict.type.clear();
    return verdict;
}

QString inWords(const EarlyEnd& end, double decided_s)
{
    return Words::tr("%1 after %2 s, posterior %3")
        .arg(end.kind == VerdictKind::Type ? end.type : Words::tr("unknown"),
             Words::number(decided_s, 'g', 6), Words::number(end.posterior, 'g', 6));
}

} // namespace gripscope
