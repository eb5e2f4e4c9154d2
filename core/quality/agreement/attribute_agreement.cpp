// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/agreement/attribute_agreement.h"

#include "core/base/words.h"
#include "core/math/binomial_evidence.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Verdicts of one rater on one part.
struct PartVerdicts {
    int part = 0;
    std::vector<int> verdicts;
    [[nodiscard]] bool allAre(int verdict) const
    {
        return std::all_of(verdicts.begin(), verdicts.end(), [&](int one) { return one == verdict; });
    }
};
using RaterVerdicts = std::vector<PartVerdicts>; ///< by part

std::vector<RaterVerdicts> byRater(const AttributeRatings& ratings)
{
    std::vector<Rating> sorted = ratings.ratings;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Rating& a, const Rating& b) { return a.part < b.part; });
    std::vector<RaterVerdicts> raters(std::size_t(ratings.raters.size()));
    for (const Rating& rating : sorted) {
        RaterVerdicts& own = raters[rating.rater];
        if (own.empty() || own.back().part != rating.part)
            own.push_back({rating.part, {}});
        own.back().verdicts.push_back(rating.verdict);
    }
    return raters;
}

void count(AgreementShare& share, bool counts)
{
    ++share.of;
    share.count += counts ? 1 : 0;
}

void addLimits(AgreementShare& share, double confidence)
{
    const BinomialEvidence evidence = binomialEvidence(share.count, share.of, (1 + confidence) / 2);
    share.lower = evidence.lowest;
    share.upper = evidence.highest;
}

std::vector<VerdictPair> pairsOf(const RaterVerdicts& first, const RaterVerdicts& second)
{
    std::vector<VerdictPair> pairs;
    auto other = second.begin();
    for (const PartVerdicts& part : first) {
        while (other != second.end() && other->part < part.part)
            ++other;
        if (other == second.end() || other->part != part.part)
            continue;
        const std::size_t both = std::min(part.verdicts.size(), other->verdicts.size());
        for (std::size_t i = 0; i < both; ++i)
            pairs.push_back({part.part, part.verdicts[i], other->verdicts[i]});
    }
    return pairs;
}

/// What a class is called, whatever its spelling.
QString plainName(const QString& name)
{
    QString plain;
    for (const QChar letter : name)
        if (letter.isLetterOrNumber())
            plain += letter.toLower();
    return plain;
}

/// The only class with one of the names.
QString classCalled(const QStringList& classes, const QStringList& names)
{
    QStringList found;
    for (const QString& name : classes)
        if (names.contains(plainName(name)))
            found << name;
    return found.size() == 1 ? found.front() : QString();
}

QString acceptedOf(const QStringList& classes)
{
    QStringList names{u"ok"_s,       u"good"_s,     u"pass"_s,      u"accept"_s,
                      u"accepted"_s, u"conforms"_s, u"conforming"_s};
    if (classes.contains(u"0"_s))
        names << u"1"_s;
    return classCalled(classes, names);
}

std::optional<Error> nameClasses(const AttributeRatings& ratings, const AgreementOptions& options,
                                 AttributeAgreement& study)
{
    for (const QString& name : {options.accepted, options.undecided})
        if (!name.isEmpty() && !ratings.classes.contains(name))
            return Error{ErrorCode::Usage,
                         {Words::say("No verdict is called %1; there are: %2.")
                              .arg(name, ratings.classes.mid(0, 20).join(u", "_s))}};
    study.classes = ratings.classes;
    study.accepted = options.accepted.isEmpty() ? acceptedOf(ratings.classes) : options.accepted;
    study.undecided = options.undecided.isEmpty()
                          ? classCalled(ratings.classes, {u"notdecidable"_s, u"undecidable"_s, u"undecided"_s,
                                                          u"inconclusive"_s})
                          : options.undecided;
    if (!study.accepted.isEmpty() && study.accepted == study.undecided)
        return Error{ErrorCode::Usage,
                     {Words::say("The class %1 cannot be both accepted and undecided.").arg(study.accepted)}};
    return {};
}

/// The numbers of the classes that have a meaning; -1: none.
struct NamedClasses {
    int accepted = -1, undecided = -1;
};

void againstReference(const RaterVerdicts& verdicts, const std::vector<int>& reference, NamedClasses named,
                      RaterAgreement& rater)
{
    for (const PartVerdicts& part : verdicts) {
        const int truth = reference[part.part];
        count(rater.effectiveness, part.allAre(truth));
        for (const int verdict : part.verdicts) {
            count(rater.correct, verdict == truth);
            count(rater.undecided, named.undecided >= 0 && verdict == named.undecided);
            if (named.accepted < 0)
                continue;
            if (truth == named.accepted)
                count(rater.falseAlarms, verdict != named.accepted && verdict != named.undecided);
            else
                count(rater.misses, verdict == named.accepted);
        }
    }
}

RaterAgreement agreementOf(const RaterVerdicts& verdicts, const AttributeRatings& ratings, NamedClasses named,
                           double confidence)
{
    RaterAgreement rater;
    std::vector<Rating> own;
    std::vector<VerdictPair> withReference;
    for (const PartVerdicts& part : verdicts) {
        rater.ratings += std::int64_t(part.verdicts.size());
        if (part.verdicts.size() > 1)
            count(rater.repeatability, part.allAre(part.verdicts.front()));
        for (const int verdict : part.verdicts) {
            own.push_back({part.part, 0, verdict});
            if (!ratings.reference.empty())
                withReference.push_back({part.part, verdict, ratings.reference[part.part]});
        }
    }
    const auto classes = int(ratings.classes.size());
    rater.within = fleissKappa(own, classes);
    rater.reference = cohenKappa(withReference, classes);
    if (!ratings.reference.empty())
        againstReference(verdicts, ratings.reference, named, rater);
    addLimits(rater.repeatability, confidence);
    addLimits(rater.effectiveness, confidence);
    return rater;
}

void addAll(const AttributeRatings& ratings, double confidence, AttributeAgreement& study)
{
    struct Part {
        std::vector<bool> judges;
        int verdict = -1;
        bool same = true;
    };
    std::vector<Part> parts(std::size_t(ratings.parts.size()));
    for (const Rating& rating : ratings.ratings) {
        Part& part = parts[rating.part];
        part.judges.resize(std::size_t(ratings.raters.size()));
        part.judges[rating.rater] = true;
        part.same = part.same && (part.verdict < 0 || part.verdict == rating.verdict);
        part.verdict = rating.verdict;
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& part = parts[i];
        if (part.judges.empty() || std::count(part.judges.begin(), part.judges.end(), false) > 0) {
            ++study.incomplete;
            continue;
        }
        count(study.all, part.same);
        if (!ratings.reference.empty())
            count(study.allRight, part.same && part.verdict == ratings.reference[i]);
    }
    addLimits(study.all, confidence);
    addLimits(study.allRight, confidence);
}

} // namespace

Expected<AttributeAgreement> studyAgreement(const AttributeRatings& ratings, const AgreementOptions& options)
{
    if (!(options.confidence > 0 && options.confidence < 1))
        return failure(ErrorCode::Usage, {Words::say("The confidence must lie between 0 and 1.")});
    AttributeAgreement study;
    RETURN_IF_ERROR(nameClasses(ratings, options, study));
    study.hasReference = !ratings.reference.empty();
    const auto place = [&](const QString& name) {
        return name.isEmpty() ? -1 : int(ratings.classes.indexOf(name));
    };
    const NamedClasses named{place(study.accepted), place(study.undecided)};
    const std::vector<RaterVerdicts> raters = byRater(ratings);
    for (std::size_t i = 0; i < raters.size(); ++i) {
        study.raters.push_back(agreementOf(raters[i], ratings, named, options.confidence));
        study.raters.back().name = ratings.raters[qsizetype(i)];
        for (std::size_t j = i + 1; j < raters.size(); ++j)
            study.pairs.push_back(
                {int(i), int(j), cohenKappa(pairsOf(raters[i], raters[j]), int(ratings.classes.size()))});
    }
    study.fleiss = fleissKappa(ratings.ratings, int(ratings.classes.size()));
    addAll(ratings, options.confidence, study);
    study.messages = inWords(study);
    return study;
}

} // namespace gripscope
