// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/validity.h"

namespace gripscope {

QString toString(ValidityVerdict verdict)
{
    switch (verdict) {
    case ValidityVerdict::Valid:
        return QStringLiteral("valid");
    case ValidityVerdict::Suspect:
        return QStringLiteral("suspect");
    case ValidityVerdict::Invalid:
        return QStringLiteral("invalid");
    }
    return {};
}

ValidityVerdict overallVerdict(const std::vector<ValidityCheck>& checks)
{
    ValidityVerdict verdict = ValidityVerdict::Valid;
    for (const ValidityCheck& check : checks) {
        if (check.ok)
            continue;
        if (check.decisive)
            return ValidityVerdict::Invalid;
        verdict = ValidityVerdict::Suspect;
    }
    return verdict;
}

} // namespace gripscope
