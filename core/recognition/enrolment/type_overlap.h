// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/recognition/verdict/verdict_by_space.h"

#include <QMap>

#include <optional>

namespace gripscope {

/// What verdicts the next squeezes of a type would get, as shares of them.
struct ExpectedVerdicts {
    double named = 0;   ///< as itself
    double unknown = 0; ///< the false rejects
    /// Not told from this other type: the verdict stays inconclusive, or it is named that type.
    QMap<QString, double> undecided, wrong;
    double undecidedAlone = 0; ///< inconclusive with no other type in it: strangers are as likely there
};

/// By simulation with a fixed seed: squeezes drawn from the type's predictive distribution (Student t, with
/// what is not known of its mean and scatter) in all that it determines, each judged by judge(). 2,000 draws
/// know a share p to sqrt(p (1 - p) / 2000). Nothing when there is no such type or no gate yet.
[[nodiscard]] std::optional<ExpectedVerdicts> expectedVerdicts(const ModelsBySpace& types,
                                                               const QString& type,
                                                               const VerdictOptions& options,
                                                               int draws = 2000);

/// The other type that takes most squeezes from a type.
struct TypeOverlap {
    QString type, other;
    double undecided = 0; ///< share of the type's squeezes that are not told from the other
    double wrong = 0;     ///< share that is named the other
    double back = 0;      ///< share of the other's squeezes that are not told from the type, or named it
};
/// Nothing where no squeeze of either is expected to be mistaken, or there is no gate.
[[nodiscard]] std::optional<TypeOverlap> worstOverlap(const ModelsBySpace& types, const QString& type,
                                                      const VerdictOptions& options);
[[nodiscard]] Finding inWords(const TypeOverlap& overlap);

} // namespace gripscope
