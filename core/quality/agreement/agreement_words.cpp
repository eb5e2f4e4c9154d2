// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/quality/agreement/attribute_agreement.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// AIAG's limits: what is acceptable, and kappas that are good and poor.
constexpr double leastEffectiveness = 0.9, mostMisses = 0.02, mostFalseAlarms = 0.05, goodKappa = 0.75,
                 poorKappa = 0.4;

Finding percentOf(const AgreementShare& share)
{
    return Finding::number(100 * share.value().value_or(0), 'f', 1) + u" %"_s;
}

Finding kappaVerdict(const AttributeAgreement& study)
{
    const FleissKappa& kappa = study.fleiss;
    if (kappa.parts == 0)
        return Words::say("No part was judged twice, so that agreement among the raters cannot be seen: let "
                          "them judge the same parts.");
    if (!kappa.value)
        return Words::say(
            "All verdicts are the same, so that kappa does not exist: agreement and chance look "
            "alike. Take parts of all classes.");
    const auto worded = [&](const char* sentence) {
        return Words::say(sentence).arg(*kappa.value, 'f', 3).arg(*kappa.z, 'f', 1);
    };
    if (*kappa.value >= goodKappa)
        return worded(QT_TRANSLATE_NOOP("Words", "The verdicts agree well: Fleiss' kappa %1 (z %2)."));
    if (*kappa.value >= poorKappa)
        return worded(QT_TRANSLATE_NOOP("Words",
                                        "The verdicts agree in part only: Fleiss' kappa %1 (z %2). Look "
                                        "at the parts on which they differ, and agree on what counts."));
    return worded(QT_TRANSLATE_NOOP("Words",
                                    "The verdicts agree poorly: Fleiss' kappa %1 (z %2). The parts "
                                    "cannot be judged this way: state what counts, train, and repeat."));
}

void addRater(const RaterAgreement& rater, Findings& words)
{
    if (rater.effectiveness.of > 0 && *rater.effectiveness.value() < leastEffectiveness)
        words.push_back(Words::say("%1 judges %2 of the parts right each time; %3 % are needed.")
                            .arg(rater.name, percentOf(rater.effectiveness))
                            .arg(100 * leastEffectiveness, 'g', 3));
    if (rater.misses.of > 0 && *rater.misses.value() > mostMisses)
        words.push_back(Words::say("%1 accepts %2 of what is not good; %3 % are allowed.")
                            .arg(rater.name, percentOf(rater.misses))
                            .arg(100 * mostMisses, 'g', 3));
    if (rater.falseAlarms.of > 0 && *rater.falseAlarms.value() > mostFalseAlarms)
        words.push_back(Words::say("%1 rejects %2 of what is good; %3 % are allowed.")
                            .arg(rater.name, percentOf(rater.falseAlarms))
                            .arg(100 * mostFalseAlarms, 'g', 3));
    if (rater.repeatability.of > 0 && *rater.repeatability.value() < leastEffectiveness)
        words.push_back(Words::say("%1 judges only %2 of the parts the same way each time.")
                            .arg(rater.name, percentOf(rater.repeatability)));
    if (rater.ratings == 0)
        words.push_back(Words::say("%1 has judged no part.").arg(rater.name));
    if (rater.undecided.count > 0)
        words.push_back(
            Words::say("%1 left %2 of %3 verdicts undecided: they count as not right, but neither "
                       "as missed nor as false alarms.")
                .arg(rater.name)
                .arg(rater.undecided.count)
                .arg(rater.undecided.of));
    if (rater.reference.pairs > 0 && !rater.reference.value)
        words.push_back(
            Words::say("The kappa of %1 against the reference does not exist: both have one class "
                       "only, the same.")
                .arg(rater.name));
}

Finding undefinedPairs(const AttributeAgreement& study)
{
    std::int64_t apart = 0, alike = 0;
    for (const RaterPair& pair : study.pairs) {
        apart += pair.kappa.pairs == 0 ? 1 : 0;
        alike += pair.kappa.pairs > 0 && !pair.kappa.value ? 1 : 0;
    }
    if (apart > 0)
        return Words::say("%1 pairs of raters have no part in common, so that they have no kappa.")
            .arg(apart);
    if (alike > 0)
        return Words::say("%1 pairs of raters gave all parts the same class, so that their kappa does not "
                          "exist.")
            .arg(alike);
    return {};
}

} // namespace

Findings inWords(const AttributeAgreement& study)
{
    Findings words{kappaVerdict(study)};
    for (const RaterAgreement& rater : study.raters)
        addRater(rater, words);
    if (study.hasReference && study.accepted.isEmpty())
        words.push_back(Words::say("Which class is that of good parts is not known, so that misses and false "
                                   "alarms are not counted: name it (--accepted)."));
    if (study.hasReference && !study.accepted.isEmpty() && study.classes.size() > 2)
        words.push_back(
            Words::say("Misses and false alarms count the class %1 against all others.").arg(study.accepted));
    if (const Finding undefined = undefinedPairs(study); !undefined.isEmpty())
        words.push_back(undefined);
    if (study.incomplete > 0)
        words.push_back(Words::say("%1 parts were not judged by every rater and are left out where all are "
                                   "compared.")
                            .arg(study.incomplete));
    return words;
}

} // namespace gripscope
