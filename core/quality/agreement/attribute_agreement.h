// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/agreement/cohen_kappa.h"
#include "core/quality/agreement/fleiss_kappa.h"

#include <cstdint>

namespace gripscope {

struct AgreementOptions {
    /// The class of good parts; empty: the one that is called OK, good, pass, accept, accepted, conforms,
    /// conforming, or 1 beside 0, if there is one such class and not several.
    QString accepted;
    /// The class of verdicts that decide nothing; empty: NotDecidable, undecidable, undecided, inconclusive.
    QString undecided;
    double confidence = 0.95;
};

/// So many of so many, with exact limits (Clopper and Pearson, Biometrika 26, 1934) where each counted thing
/// is independent of the others.
struct AgreementShare {
    std::int64_t count = 0, of = 0;
    double lower = 0, upper = 1;
    [[nodiscard]] std::optional<double> value() const
    {
        return of > 0 ? std::optional(double(count) / double(of)) : std::nullopt;
    }
};

struct RaterAgreement {
    QString name;
    std::int64_t ratings = 0;
    AgreementShare repeatability; ///< parts judged twice or more, all alike
    FleissKappa within;           ///< of those verdicts among themselves
    /// Against the reference; all counts are 0 where there is none.
    AgreementShare effectiveness; ///< parts, all verdicts on which are right
    AgreementShare correct;       ///< verdicts that are right
    /// Verdicts, without limits, since those on one part are alike: accepted of parts that are not of the
    /// accepted class; of that class and judged as another one; and undecided, which is neither.
    AgreementShare misses, falseAlarms, undecided;
    CohenKappa reference; ///< each verdict with the part's class
};

struct RaterPair {
    int first = 0, second = 0; ///< places of the raters
    CohenKappa kappa;
};

struct AttributeAgreement {
    std::vector<RaterAgreement> raters;
    std::vector<RaterPair> pairs;
    FleissKappa fleiss;          ///< of all verdicts
    AgreementShare all;          ///< parts that every rater judged, all verdicts on which are the same
    AgreementShare allRight;     ///< and right
    std::int64_t incomplete = 0; ///< parts that some rater did not judge
    QStringList classes;
    QString accepted;  ///< empty: not known, so that nothing is a miss or a false alarm
    QString undecided; ///< empty: no such class
    bool hasReference = false;
    Findings messages; ///< a verdict first
};

/// Attribute agreement (AIAG, Measurement Systems Analysis, 4th edition 2010, chapter III C; effectiveness by
/// part and errors by decision as in its table of 50 parts). Kappas of pairs and against the reference by
/// cohenKappa(): the first verdict of one rater on a part with the first of the other, the second with the
/// second, and so on as far as both have some. A reference of more than two classes: a verdict is right if it
/// names the part's class; misses and false alarms count the accepted class against all others. Usage for
/// `accepted` or `undecided` classes that do not occur, and a confidence that is none.
[[nodiscard]] Expected<AttributeAgreement> studyAgreement(const AttributeRatings& ratings,
                                                          const AgreementOptions& options = {});

/// What studyAgreement() puts into `messages`.
[[nodiscard]] Findings inWords(const AttributeAgreement& study);

} // namespace gripscope
