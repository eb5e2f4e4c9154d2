// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/math/binomial_evidence.h"
#include "core/recognition/types/models_by_space.h"
#include "core/recognition/types/type_model.h"
#include "core/recognition/verdict/verdict.h"

#include <Eigen/Core>
#include <QMap>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <optional>
#include <vector>

class QJsonObject;

namespace gripscope {

// Advice while a type is enrolled.

/// How far an enrolment is from what more squeezes can give.
struct EnrollmentProgress {
    QString type;
    int squeezes = 0;
    double falseReject = 0; ///< the rate that the gate is for
    /// Of strangers anywhere in the instrument's range, the share that may be named a type; absent where
    /// nothing is said of them.
    std::optional<double> strangerAccept;
    /// Squeezes that are missing until there is a gate; 0: there is one.
    int moreForGate = 0;
    /// Where a squeeze is called unknown, in standard deviations; and where it would be if everything were
    /// known: sqrt of the chi-square quantile.
    std::optional<double> gate;
    double gateLimit = 0;
    /// Share of the squeezes of a part that lies 6 standard deviations away that pass the gate, on average
    /// over enrolments (noncentral F); and if everything were known (noncentral chi-square).
    std::optional<double> strangersPassing;
    double strangersLimit = 0;
    /// Squeezes until the gate is within a quarter of its limit; 0: it is. Absent: over 100.
    std::optional<int> moreForMost;
    /// How far the type's stiffness may lie from what was found (95 %, a share of it); absent where nothing
    /// is known of how squeezes differ, or in a space without stiffness.
    std::optional<double> stiffnessUncertainty;
};

/// `models`: of all types, with this one in it or not yet. The gate is the predictive one at the false-reject
/// rate, or the tolerance gate where a confidence is asked for.
[[nodiscard]] EnrollmentProgress enrollmentProgress(const TypeModels& models, const QString& type,
                                                    const VerdictOptions& options);
/// What a technician should know and do next, in sentences.
[[nodiscard]] Findings inWords(const EnrollmentProgress& progress);

struct OutlierOptions {
    /// Share of enrolments without any outlier in which one is found all the same.
    double falseAlarm = 0.05;
};

/// A squeeze that lies away from the others of its type.
struct SqueezeOutlier {
    std::size_t index = 0; ///< among all squeezes
    double deviations = 0; ///< distance from the others in their standard deviations
    double chance = 1;     ///< share of enrolments without outliers that have a squeeze as far out
    int parameter =
        -1;         ///< the TypeQuantity (0, 1, 2: m, b, k) that stands out alone; -1: only all together do
    Finding reason; ///< "Stiffness is 8 % above the others, 5.2 of their standard deviations."
};

/// The squeezes of `type` that do not go with the others of it, the farthest first.
///
/// In spaceOf(squeezes). Each squeeze is held against the type without it: D^2 by the F distribution of the
/// predictive gate, and each quantity (m, b and k) by Student's t, which needs fewer squeezes; the
/// probability is 2 min(p_D, p min(p_m, p_b, p_k)). The least probable is taken out, and so on for up to a
/// third of the squeezes (5 at most). Outliers are all that were taken out up to the last whose probability
/// was below `falseAlarm` / (squeezes left * steps), so that two that hide each other are found; by
/// Bonferroni's inequality the false alarms of the whole enrolment stay at or below `falseAlarm`. (Caroni and
/// Prescott, Sequential application of Wilks's multivariate outlier test, Applied Statistics 1992.) Other
/// types only lend their scatter, up to 30 squeezes of each. Nothing is found among fewer than 3 squeezes,
/// nor where nothing is known of how squeezes differ.
[[nodiscard]] std::vector<SqueezeOutlier> findOutliers(const std::vector<TypeSqueeze>& squeezes,
                                                       const QString& type,
                                                       const OutlierOptions& options = {});

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

/// What the enrolled squeezes are called when each is judged by models that do not know it, in
/// spaceOf(squeezes).
///
/// Squeezes of one part are left out together, and a part counts once in the bounds, wrong when any of its
/// squeezes is: squeezes of one part are not independent. Up to 400 parts are left out one at a time; of a
/// larger library one part of every type at a time, 50 at the most of each. A type with a single part is not
/// tested.
struct HeldOutConfusion {
    QStringList types; ///< sorted
    /// Squeezes of type i that were called type j; then two columns: unknown, and inconclusive.
    Eigen::MatrixXi counts;
    int squeezes = 0, parts = 0, untested = 0;
    BinomialEvidence wrongType;                ///< parts that were called another type
    BinomialEvidence unknown;                  ///< parts that were called unknown: false rejects
    std::vector<BinomialEvidence> wrongTypeOf; ///< the same for each type
};
[[nodiscard]] HeldOutConfusion heldOutConfusion(const std::vector<TypeSqueeze>& squeezes,
                                                const VerdictOptions& options = {});

// What `gripscope-cli types guide --json` and `types confusion --json` say.

/// squeezes, more_for_gate, gate, gate_limit, strangers_passing, strangers_limit, more_for_most (null: over
/// 100), stiffness_uncertainty, words.
[[nodiscard]] QJsonObject toJson(const EnrollmentProgress& progress);
/// deviations, chance, parameter ("m", "b", "k", "k1/k", "tau", "Fc" or null), reason.
[[nodiscard]] QJsonObject toJson(const SqueezeOutlier& outlier);
/// other, undecided, wrong, undecided_of_other, words.
[[nodiscard]] QJsonObject toJson(const TypeOverlap& overlap);
/// confusion (by true type: by verdict), squeezes, parts, untested, wrong_type and unknown with their bounds.
[[nodiscard]] QJsonObject toJson(const HeldOutConfusion& confusion);

} // namespace gripscope
