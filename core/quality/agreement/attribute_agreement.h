// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/table/study_table.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

class QJsonObject;

namespace gripscope {

/// One verdict on a part; places in the lists of AttributeRatings.
struct Rating {
    int part = 0, rater = 0, verdict = 0;
};

/// Verdicts of raters on parts, in the order in which they were given; any number of each rater on each part.
struct AttributeRatings {
    QStringList parts, raters;
    QStringList classes; ///< of verdicts and of references; NotDecidable is a class like any other
    std::vector<Rating> ratings;
    std::vector<int> reference; ///< the class of each part; empty: none is known
};

/// Which columns of a table hold what.
struct RatingColumns {
    QString part;    ///< empty, with `raters`: each row is a part of its own
    QString rater;   ///< a verdict a row: who gave it
    QString verdict; ///< and which
    QStringList
        raters; ///< or in place of those two: a column a rater, verdicts in it, empty where none was given
    QString reference; ///< empty: none
};

/// More are a wrong column.
inline constexpr int mostRaters = 100, mostClasses = 1000;

/// BadInput as StudyTable::labels(), for a part with two references, and for more raters or classes than
/// anybody has. Usage for columns that do not go together.
[[nodiscard]] Expected<AttributeRatings> readRatings(const StudyTable& table, const RatingColumns& columns);

/// Two verdicts on one part: classes by number.
struct VerdictPair {
    int part = 0, first = 0, second = 0;
};

struct CohenKappa {
    std::size_t pairs = 0;
    std::optional<double> agreement; ///< p_o; nothing without pairs
    /// Nothing where both gave all parts the same class: then there is no agreement beyond chance to see.
    std::optional<double> value;
    /// Nothing for a single part, and for full agreement, where the formula knows no error.
    std::optional<double> standardError;
};

/// Chance-corrected agreement of two raters, unweighted:
///     kappa = (p_o - p_e) / (1 - p_e)
/// p_o the share of pairs with the same class, p_e = sum_c p_c q_c by the shares of each rater (Cohen, A
/// coefficient of agreement for nominal scales, Educational and Psychological Measurement 20, 1960).
/// Standard error by the delta method, for large samples,
///     sqrt(sum over parts of (sum over the part's pairs of u)^2) / N
///     u_ij = ((1[i = j] - p_o) (1 - p_e) - (1 - p_o) (q_i + p_j - 2 p_e)) / (1 - p_e)^2
/// which with one pair a part is that of Fleiss, Cohen and Everitt (Psychological Bulletin 72, 1969), and
/// with several counts the parts, not the pairs, which are alike within a part. Pairs of a part stand
/// together; classes are 0 to `classes` - 1.
[[nodiscard]] CohenKappa cohenKappa(std::span<const VerdictPair> pairs, int classes);

/// One class against all others.
struct ClassKappa {
    int verdict = 0;  ///< the class
    double share = 0; ///< of the verdicts, p
    std::optional<double> value, z;
};

struct FleissKappa {
    std::size_t parts = 0;   ///< with two verdicts at least; the others say nothing
    std::size_t ratings = 0; ///< on those
    /// Nothing where all verdicts are of one class: then there is no agreement beyond chance to see.
    std::optional<double> value;
    std::optional<double> standardError; ///< where there is no agreement beyond chance
    std::optional<double> z, p;          ///< of none, the upper tail: more than chance
    std::vector<ClassKappa> classes;     ///< those that occur
};

/// Chance-corrected agreement of any number of verdicts m_i on each of N parts:
///     kappa = (P - P_e) / (1 - P_e)
///     P = mean over parts of sum_c n_ic (n_ic - 1) / (m_i (m_i - 1))
///     P_e = sum_c p_c^2, p_c the mean over parts of n_ic / m_i
/// (Fleiss, Measuring nominal scale agreement among many raters, Psychological Bulletin 76, 1971; for unequal
/// m_i Gwet, Handbook of Inter-Rater Reliability, 2014). z = kappa / se, with the error under no agreement
///     se^2 = 2 (sum p^2 + (sum p^2)^2 - 2 sum p^3) / (1 - P_e)^2 sum_i 1 / (m_i (m_i - 1)) / N^2
/// of Fleiss, Nee and Landis (Psychological Bulletin 86, 1979), who have all m_i alike; 1971's own was wrong.
/// Verdicts of one rater on the same part count as those of different raters do.
[[nodiscard]] FleissKappa fleissKappa(const std::vector<Rating>& ratings, int classes);

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

/// As `gripscope-cli study attributes` prints it: raters by name, pairs as a list; what does not exist is
/// null.
[[nodiscard]] QJsonObject toJson(const AttributeAgreement& study);

} // namespace gripscope
