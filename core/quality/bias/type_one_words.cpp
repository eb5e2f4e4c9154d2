// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/quality/bias/type_one_study.h"

#include <cmath>

namespace gripscope {

namespace {

constexpr std::size_t fewestReadings = 25, usualReadings = 50; ///< Booklet 10

Finding readingTold(double value, const TypeOneOptions& options)
{
    return options.quantity ? Finding::quantity(*options.quantity, value) : Finding::number(value, 'g', 4);
}

Finding noScatter(const TypeOneStudy& study, const TypeOneOptions& options)
{
    if (2 * std::abs(study.bias) > options.sharePercent / 100 * options.tolerance)
        return Words::say(
                   "Not capable: all %1 readings are the same and lie %2 from the reference, more than "
                   "half of the share of the tolerance that is allowed. Calibrate the gripper.")
            .arg(study.count)
            .arg(readingTold(study.bias, options));
    return Words::say(
               "All %1 readings are the same, so that Cg and Cgk do not exist: the scatter is below the "
               "step of the readings. Record more digits and repeat the study.")
        .arg(study.count);
}

Finding scatterVerdict(const TypeOneStudy& study, const TypeOneOptions& options)
{
    if (!study.cg || !study.cgk)
        return Words::say(
            "The readings scatter too little for Cg and Cgk to be numbers: check their unit and "
            "that of the tolerance.");
    const auto worded = [&](const char* sentence) {
        return Words::say(sentence)
            .arg(*study.cg, 'f', 2)
            .arg(*study.cgk, 'f', 2)
            .arg(options.minimum, 'g', 4);
    };
    if (study.capable)
        return worded(QT_TRANSLATE_NOOP("Words", "Capable: Cg %1 and Cgk %2 reach %3."));
    if (*study.cg < options.minimum && study.biased)
        return worded(QT_TRANSLATE_NOOP("Words", "Not capable: Cg %1 and Cgk %2, at least %3 is needed. The "
                                                 "readings scatter too much: look at fixture, contact and "
                                                 "force first, then at the bias."));
    if (*study.cg < options.minimum)
        return worded(QT_TRANSLATE_NOOP("Words", "Not capable: Cg %1 and Cgk %2, at least %3 is needed. The "
                                                 "readings scatter too much: look at fixture, contact and "
                                                 "force."));
    if (*study.cgk < options.minimum)
        return worded(QT_TRANSLATE_NOOP("Words",
                                        "Not capable: Cg %1 is enough, Cgk %2 is not, at least %3 is "
                                        "needed. The scatter is small enough, the bias is not: "
                                        "calibrate the gripper and repeat the study."));
    return worded(QT_TRANSLATE_NOOP("Words", "Not capable: Cg %1 and Cgk %2 reach %3, but the step of the "
                                             "readings is too coarse to trust them."));
}

Finding biasWords(const TypeOneStudy& study, const TypeOneOptions& options)
{
    const double percent = 100 * options.confidence;
    if (!study.biasInterval)
        return Words::say(
                   "The mean of the readings lies %1 from the reference; how sure that is cannot be said "
                   "without scatter.")
            .arg(readingTold(study.bias, options));
    const auto worded = [&](const char* sentence) {
        return Words::say(sentence)
            .arg(readingTold(study.bias, options))
            .arg(readingTold(study.biasInterval->lower, options))
            .arg(readingTold(study.biasInterval->upper, options))
            .arg(percent, 'g', 4);
    };
    if (!study.biased)
        return worded(QT_TRANSLATE_NOOP("Words", "No bias is seen: %1, from %2 to %3 with %4 % confidence."));
    if (study.bias > 0)
        return worded(QT_TRANSLATE_NOOP("Words", "The gripper reads too much by %1, from %2 to %3 with %4 % "
                                                 "confidence."));
    return worded(QT_TRANSLATE_NOOP("Words", "The gripper reads too little: bias %1, from %2 to %3 with %4 % "
                                             "confidence."));
}

/// What more readings could change.
std::optional<Finding> doubt(const TypeOneStudy& study, const TypeOneOptions& options)
{
    if (!study.cgkInterval || !study.cgInterval)
        return {};
    const bool open =
        study.cgkInterval->lower < options.minimum && study.cgkInterval->upper >= options.minimum;
    if (!open)
        return {};
    return Words::say(
               "The verdict is not certain: with %1 readings Cgk lies between %2 and %3. More readings "
               "narrow that.")
        .arg(study.count)
        .arg(study.cgkInterval->lower, 'f', 2)
        .arg(study.cgkInterval->upper, 'f', 2);
}

std::optional<Finding> stepWords(const TypeOneStudy& study, const TypeOneOptions& options)
{
    if (!study.stepPercent || *study.stepPercent <= largestStepPercent)
        return {};
    return Words::say(
               "The smallest step between the readings is %1, that is %2 % of the tolerance; at most %3 % "
               "are allowed. Record more digits, or take a finer sensor.")
        .arg(readingTold(*study.step, options))
        .arg(*study.stepPercent, 'f', 1)
        .arg(largestStepPercent, 'g', 3);
}

} // namespace

Findings inWords(const TypeOneStudy& study, const TypeOneOptions& options)
{
    Findings words;
    words.push_back(study.repeatability > 0 ? scatterVerdict(study, options) : noScatter(study, options));
    words.push_back(biasWords(study, options));
    if (study.repeatability > 0)
        words.push_back(
            Words::say("%1 standard deviations take %2 % of the tolerance; a minimum of %3 allows "
                       "%4 %. Cg would reach it at a tolerance of %5, Cgk at one of %6.")
                .arg(options.sigmas, 'g', 4)
                .arg(study.variationPercent, 'f', 1)
                .arg(options.minimum, 'g', 4)
                .arg(study.largestVariationPercent, 'f', 1)
                .arg(readingTold(study.leastTolerance, options))
                .arg(readingTold(study.leastBiasedTolerance, options)));
    if (const std::optional<Finding> open = doubt(study, options))
        words.push_back(*open);
    if (const std::optional<Finding> coarse = stepWords(study, options))
        words.push_back(*coarse);
    if (study.count < fewestReadings)
        words.push_back(
            Words::say("%1 readings are few: Booklet 10 asks for %2, and for %3 at least. Squeeze "
                       "the reference part more often.")
                .arg(study.count)
                .arg(usualReadings)
                .arg(fewestReadings));
    return words;
}

} // namespace gripscope
