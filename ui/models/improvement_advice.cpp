// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/normal_interval.h"
#include "ui/format/derived_quantities.h"
#include "ui/format/shown_budget.h"
#include "ui/models/budget_table_model.h"

#include <QCoreApplication>
#include <QHash>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Intervals narrower than this, as a share of the value, need no advice.
constexpr double goodEnough = 0.005;
/// An effect with this share of a variance dominates it.
constexpr double dominantShare = 0.5;
/// From this share on, what is left of the error without the effect is not worth a word.
constexpr double almostAll = 0.9;
/// A parameter known this much worse than another one says that the force moves in the wrong band.
constexpr double lopsided = 4;
constexpr qsizetype mostSentences = 3;

QString adviceWord(const char* text)
{
    return QCoreApplication::translate("gripscope::ImprovementAdvice", text);
}

/// "m", "m and k", "m, b and k".
QString listed(const std::vector<int>& parameters)
{
    QStringList names;
    for (const int parameter : parameters)
        names << QString(u"mbk"_s[parameter]);
    if (names.size() < 2)
        return names.join(QString());
    const QString last = names.takeLast();
    return adviceWord(QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice", "%1 and %2"))
        .arg(names.join(u", "_s), last);
}

bool isNoise(const QString& effect)
{
    return effect.endsWith(u"noise");
}

/// What dominates (%1: the parameters), and what to do about it.
QString sentenceFor(const QString& effect)
{
    static const QHash<QString, const char*> sentences{
        {u"lag"_s, QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                     "The lag between the channels dominates the error of %1: measure the "
                                     "lag.")},
        {u"quantization"_s, QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                              "The steps of the position dominate the error of %1: squeeze "
                                              "with more force, or measure the position in finer steps.")},
        {u"hold"_s,
         QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                           "How the force runs between samples dominates the error of %1: sample faster, or "
                           "name the force hold of the device.")},
        {u"friction"_s, QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                          "Friction that may hide in this squeeze dominates the error of %1: "
                                          "four levels of force tell it (the recipe on Enroll; "
                                          "gripscope-cli record --excitation four-level).")},
        {u"jitter"_s, QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                        "Samples beside their times dominate the error of %1: steady the "
                                        "gripper's clock.")},
        {u"calibration"_s, QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                             "The calibration dominates the error of %1: calibrate force "
                                             "and position anew.")},
        {u"force_scale"_s, QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                             "The force calibration dominates the error of %1: calibrate "
                                             "the force with better weights.")},
        {u"position_scale"_s, QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                                "The position calibration dominates the error of %1: "
                                                "calibrate the position with better gauge blocks.")},
        {u"frame_compliance"_s, QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                                  "The give of the frame dominates the error of %1: measure "
                                                  "it with a rigid block.")},
        {u"baseline"_s, QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                          "The empty gripper dominates the error of %1: measure it again, "
                                          "for longer.")},
        {u"model_discrepancy"_s,
         QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                           "Parts of this squeeze disagree about %1: squeeze with the amplitude that "
                           "matters to you, or look at the models.")},
    };
    const char* sentence = sentences.value(effect, nullptr);
    return sentence ? adviceWord(sentence) : QString();
}

QString noiseSentence(const QString& parameters, double share)
{
    return (share >= almostAll ? adviceWord(QT_TRANSLATE_NOOP(
                                     "gripscope::ImprovementAdvice",
                                     "Noise dominates the error of %1: squeeze 4 times longer to halve "
                                     "it."))
                               : adviceWord(QT_TRANSLATE_NOOP(
                                     "gripscope::ImprovementAdvice",
                                     "Noise makes most of the error of %1: squeeze 4 times longer to "
                                     "halve that part.")))
        .arg(parameters);
}

/// Which band of the force says most about the parameter that is known worst.
QString bandSentence(const ImprovementFacts& facts, int worst)
{
    const auto& widths = facts.relativeHalfWidths;
    const auto best = int(std::min_element(widths.begin(), widths.end()) - widths.begin());
    const double ratio = widths[std::size_t(worst)] / widths[std::size_t(best)];
    if (!(ratio >= lopsided))
        return {};
    const QString head =
        adviceWord(QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice", "%1 is known %2 times worse than %3"))
            .arg(u"mbk"_s[worst])
            .arg(ratio, 0, 'f', 0)
            .arg(u"mbk"_s[best]);
    switch (worst) {
    case 0:
        return adviceWord(
                   QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                     "%1: a force that changes faster (shorter bits) says more about m."))
            .arg(head);
    case 1:
        return adviceWord(QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                            "%1: a force that is stronger around %2 Hz says more about b."))
            .arg(head)
            .arg(facts.naturalFrequency_Hz, 0, 'g', 2);
    default:
        return adviceWord(
                   QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                     "%1: a force that changes more slowly (longer bits) says more about k."))
            .arg(head);
    }
}

struct Group {
    QString effect; ///< "noise" for every kind of it
    std::vector<int> parameters;
    double worstWidth = 0, leastShare = 1;
};

/// The effects that dominate, with the parameters that they dominate; the worst known parameter first.
std::vector<Group> dominantEffects(const ImprovementFacts& facts)
{
    std::vector<Group> groups;
    for (int parameter = 0; parameter < 3; ++parameter) {
        const auto at = std::size_t(parameter);
        double noise = facts.shares.empty() ? 1 : 0, largest = 0;
        QString effect;
        for (const ErrorShare& one : facts.shares) {
            if (isNoise(one.effect))
                noise += one.share[at];
            else if (one.share[at] > largest)
                largest = one.share[at], effect = one.effect;
        }
        if (noise >= largest)
            largest = noise, effect = u"noise"_s;
        if (!(largest >= dominantShare) || !(facts.relativeHalfWidths[at] >= goodEnough))
            continue;
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const Group& one) { return one.effect == effect; });
        if (group == groups.end())
            group = groups.insert(groups.end(), Group{effect, {}});
        group->parameters.push_back(parameter);
        group->worstWidth = std::max(group->worstWidth, facts.relativeHalfWidths[at]);
        group->leastShare = std::min(group->leastShare, largest);
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const Group& a, const Group& b) { return a.worstWidth > b.worstWidth; });
    return groups;
}

} // namespace

QStringList improvementAdvice(const ImprovementFacts& facts)
{
    const auto& widths = facts.relativeHalfWidths;
    if (std::any_of(widths.begin(), widths.end(), [](double width) { return !std::isfinite(width); }))
        return {};
    const auto worst = int(std::max_element(widths.begin(), widths.end()) - widths.begin());
    if (widths[std::size_t(worst)] < goodEnough)
        return {
            adviceWord(QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                         "Little is left to gain: m, b and k are known to %1 % or better."))
                .arg(100 * goodEnough, 0, 'g', 2)};
    QStringList advice;
    for (const Group& group : dominantEffects(facts)) {
        const QString parameters = listed(group.parameters);
        const bool noise = group.effect == u"noise";
        const QString sentence =
            noise ? noiseSentence(parameters, group.leastShare) : sentenceFor(group.effect).arg(parameters);
        if (!sentence.isEmpty())
            advice << sentence;
        if (noise &&
            std::find(group.parameters.begin(), group.parameters.end(), worst) != group.parameters.end())
            if (const QString band = bandSentence(facts, worst); !band.isEmpty())
                advice << band;
    }
    if (advice.isEmpty())
        advice << adviceWord(
            QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                              "No single effect dominates: the budget shows what to gain where."));
    return advice.mid(0, mostSentences);
}

QStringList improvementAdvice(const Identification& identification)
{
    const Estimate* best = identification.best();
    if (identification.validity.verdict == ValidityVerdict::Invalid || !best || !best->parameters)
        return {};
    for (const ValidityCheck& check : identification.validity.checks)
        if (!check.ok && (check.id == u"residual_whiteness" || check.id == u"input_independence" ||
                          check.id == u"linearity"))
            return {adviceWord(
                QT_TRANSLATE_NOOP("gripscope::ImprovementAdvice",
                                  "What is left is more than noise: a longer squeeze will not help "
                                  "before the model fits. Compare the models."))};
    const std::optional<Eigen::Vector3d> errors = best->standardErrors();
    const auto derived = derivedQuantities(*best);
    if (!errors || !derived)
        return {};
    ImprovementFacts facts;
    facts.naturalFrequency_Hz = derived->naturalFrequency_Hz;
    for (int i = 0; i < 3; ++i)
        facts.relativeHalfWidths[std::size_t(i)] = normal95 * (*errors)[i] / best->parameters->vector()[i];
    if (const UncertaintyBudget* budget = shownBudget(identification)) {
        for (std::size_t i = 0; i < 3; ++i)
            facts.relativeHalfWidths[i] = (budget->intervals[i].upper - budget->intervals[i].lower) / 2 /
                                          budget->parameters->vector()[Eigen::Index(i)];
        for (const BudgetLine& line : budget->lines)
            facts.shares.push_back({line.id, {line.share[0], line.share[1], line.share[2]}});
    }
    return improvementAdvice(facts);
}

} // namespace gripscope
