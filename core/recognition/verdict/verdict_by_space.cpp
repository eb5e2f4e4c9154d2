// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/verdict_by_space.h"

#include <optional>
#include <utility>

namespace gripscope {

namespace {

VerdictOptions withShare(VerdictOptions options, double share)
{
    options.falseReject *= share;
    options.wrongType *= share;
    options.strangerAccept *= share;
    return options;
}

/// Posteriors of the verdict among some of the types go into that of the one before, which has all of them;
/// and so does what was said of the others, where there is only one type among some.
Verdict behind(const Verdict& before, Verdict verdict)
{
    double among = 0;
    for (auto it = verdict.posterior.cbegin(); it != verdict.posterior.cend(); ++it)
        among += before.posterior.value(it.key());
    const bool alone = verdict.posterior.size() == 1;
    QMap<QString, double> all = before.posterior;
    for (auto it = verdict.posterior.cbegin(); it != verdict.posterior.cend(); ++it)
        all[it.key()] = among * *it;
    verdict.posterior = std::move(all);
    if (verdict.kind != VerdictKind::Type || !alone)
        return verdict;
    // No other type was left: how far off they are was told before.
    verdict.rival = before.rival;
    if (before.kind == VerdictKind::Type)
        verdict.reasons.insert(verdict.reasons.begin(), before.reasons.front());
    return verdict;
}

} // namespace

Verdict judge(const ModelsBySpace& types, const TypeSqueeze& squeeze, const VerdictOptions& options)
{
    ModelsBySpace::Models models = types.modelsFor(squeeze);
    double left = 1;
    std::optional<Verdict> before;
    while (true) {
        const bool several = types.mayGoBeyond(models->space, squeeze);
        const double share = several ? left / 2 : left;
        Verdict verdict = judge(*models, squeeze, withShare(options, share));
        if (!verdict.gate && before) // too few squeezes here
            return *before;
        if (!verdict.gate)
            return several ? judge(*models, squeeze, options) : verdict;
        if (before)
            verdict = behind(*before, std::move(verdict));
        models = verdict.open.isEmpty() ? nullptr : types.beyond(models->space, verdict.open, squeeze);
        if (!models)
            return verdict;
        left -= share;
        before = std::move(verdict);
    }
}

Verdict judge(const ModelsBySpace& types, const Identification& identification,
              const std::optional<TypeSqueeze>& found, const VerdictOptions& options,
              const std::optional<CommonShift>& transfer)
{
    return verdictOnMeasurement(identification, found, transfer,
                                [&](const TypeSqueeze& squeeze) { return judge(types, squeeze, options); });
}

} // namespace gripscope
