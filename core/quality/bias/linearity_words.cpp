// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/p_value_words.h"
#include "core/base/words.h"
#include "core/quality/bias/linearity_study.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t usualReferences = 5, usualRepeats = 10; ///< AIAG

bool isSignificant(std::optional<double> p, const LinearityOptions& options)
{
    return p && *p < 1 - options.confidence;
}

Finding biasTold(double value, const LinearityOptions& options)
{
    return options.quantity ? Finding::quantity(*options.quantity, value) : Finding::number(value, 'g', 4);
}

Finding numbersOf(const std::vector<const ReferenceBias*>& biases, const LinearityOptions& options)
{
    std::vector<Finding> numbers;
    for (const ReferenceBias* bias : biases)
        numbers.push_back(options.quantity ? biasTold(bias->reference, options)
                                           : Finding::number(bias->reference));
    return Finding::joined(numbers, u", "_s);
}

Finding lineWords(const LinearityStudy& study, const LinearityOptions& options)
{
    if (!study.residualDeviation)
        return Words::say(
                   "The readings lie on the line bias = %1 + %2 reference without any scatter, so that "
                   "nothing can be tested. Record more digits, or repeat each reference.")
            .arg(biasTold(study.intercept, options))
            .arg(study.slope, 'g', 4);
    if (isSignificant(study.pSlope, options))
        return Words::say("Not linear: the bias changes by %1 for each unit of the reference (%2). Calibrate "
                          "the gripper at both ends of its range, then repeat the study.")
            .arg(study.slope, 'g', 4)
            .arg(pValueInWords(*study.pSlope));
    if (isSignificant(study.zeroLine ? std::optional(study.zeroLine->p) : std::nullopt, options))
        return Words::say("Linear, but biased: the zero line is not within what the readings allow (%1); the "
                          "mean bias is %2. Take it off by a calibration, then repeat the study.")
            .arg(pValueInWords(study.zeroLine->p))
            .arg(biasTold(study.average.bias, options));
    return Words::say("Linear: neither a bias nor a change of it over the range is seen.");
}

Finding biasedReferences(const LinearityStudy& study, const LinearityOptions& options)
{
    std::vector<const ReferenceBias*> biased, untested;
    for (const ReferenceBias& bias : study.references) {
        if (isSignificant(bias.p, options))
            biased.push_back(&bias);
        else if (!bias.p)
            untested.push_back(&bias);
    }
    Finding words = biased.empty()
                        ? Words::say("No single reference shows a bias.")
                        : Words::say("A bias is seen at the references %1.").arg(numbersOf(biased, options));
    if (!untested.empty())
        words +=
            u" "_s + Words::say("It cannot be tested at %1, where no scatter is seen: repeat the readings.")
                         .arg(numbersOf(untested, options));
    return words;
}

} // namespace

Findings inWords(const LinearityStudy& study, const LinearityOptions& options)
{
    Findings words{lineWords(study, options), biasedReferences(study, options)};
    if (study.lackOfFit && isSignificant(study.lackOfFit->p, options))
        words.push_back(Words::say("A straight line does not describe the bias (lack of fit, %1): go by the "
                                   "bias at each reference, and calibrate with a curve.")
                            .arg(pValueInWords(study.lackOfFit->p)));
    if (study.linearity)
        words.push_back(Words::say("Over the process variation the bias changes by %1, that is %2 % of it.")
                            .arg(biasTold(*study.linearity, options))
                            .arg(study.percentLinearity, 'f', 1));
    const auto fewest =
        std::min_element(study.references.begin(), study.references.end(),
                         [](const ReferenceBias& a, const ReferenceBias& b) { return a.count < b.count; });
    if (study.references.size() < usualReferences || fewest->count < usualRepeats)
        words.push_back(
            Words::say("There are %1 references with %2 readings at the least; usual are %3 over the "
                       "whole range with %4 each.")
                .arg(study.references.size())
                .arg(fewest->count)
                .arg(usualReferences)
                .arg(usualRepeats));
    return words;
}

} // namespace gripscope
