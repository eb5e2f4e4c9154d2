// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/bias/linearity_study.h"

#include "core/base/words.h"
#include "core/math/distributions.h"
#include "core/math/sample_moments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// The readings of a reference, less the reference.
using BiasesByReference = std::map<double, std::vector<double>>;

tl::unexpected<Error> unusableLinearity(const Finding& found, const Finding& expected)
{
    return failure(ErrorCode::BadInput, {Words::say("readings of the reference parts"), found, expected});
}

/// The sums that least squares needs, about the means.
struct CentredSums {
    std::size_t count = 0;
    double meanX = 0, meanY = 0;
    double xx = 0, xy = 0, yy = 0;
    double zeroSquares = 0; ///< sum y^2
    double rounding = 0;    ///< of one bias: what is left of two numbers that nearly cancel
};

CentredSums centredSums(std::span<const double> references, const std::vector<double>& biases)
{
    const SampleMoments x = sampleMoments(references), y = sampleMoments(biases);
    CentredSums sums{x.count, x.mean, y.mean, x.sumOfSquares, 0, y.sumOfSquares};
    double largest = 0;
    for (std::size_t i = 0; i < biases.size(); ++i) {
        sums.xy += (references[i] - x.mean) * (biases[i] - y.mean);
        sums.zeroSquares += biases[i] * biases[i];
        largest = std::max({largest, std::abs(references[i]), std::abs(references[i] + biases[i])});
    }
    sums.rounding = 8 * std::numeric_limits<double>::epsilon() * largest;
    return sums;
}

/// Squares that are not just the rounding of the numbers they come from.
bool isSeen(double squares, const CentredSums& sums)
{
    return squares > double(sums.count) * sums.rounding * sums.rounding;
}

struct TestOfMean {
    std::optional<double> t, p;
    std::optional<TwoSidedInterval> interval;
};

TestOfMean testOfEstimate(double estimate, double error, double degrees, double confidence)
{
    TestOfMean test;
    if (!(error > 0) || !(degrees > 0) || !std::isfinite(estimate / error))
        return test;
    const double half = studentQuantileAbove((1 - confidence) / 2, degrees) * error;
    test.t = estimate / error;
    test.p = 2 * studentAbove(std::abs(*test.t), degrees);
    test.interval = TwoSidedInterval{estimate - half, estimate + half};
    return test;
}

void testBias(ReferenceBias& bias, std::optional<double> deviation, double degrees, double confidence)
{
    if (!deviation || !(*deviation > 0) || !(degrees > 0))
        return;
    bias.deviation = deviation;
    const TestOfMean test =
        testOfEstimate(bias.bias, *deviation / std::sqrt(double(bias.count)), degrees, confidence);
    bias.t = test.t;
    bias.p = test.p;
    bias.interval = test.interval;
}

std::optional<LinearityTest> fisherTest(double numeratorSquares, double numerator, double denominatorSquares,
                                        double denominator)
{
    if (!(numerator > 0) || !(denominator > 0) || !(denominatorSquares > 0))
        return {};
    const double f = std::max(0.0, numeratorSquares) / numerator / (denominatorSquares / denominator);
    if (!std::isfinite(f))
        return {};
    return LinearityTest{f, numerator, denominator, fisherAbove(f, numerator, denominator)};
}

/// Sums of squares: about the line, and within the references.
struct ResidualSquares {
    double residual = 0, pure = 0;
};

ResidualSquares residualSquares(const LinearityStudy& study, const BiasesByReference& groups)
{
    ResidualSquares squares;
    for (const auto& [reference, biases] : groups) {
        const SampleMoments moments = sampleMoments(biases);
        const double off = moments.mean - study.lineAt(reference);
        squares.pure += moments.sumOfSquares;
        squares.residual += moments.sumOfSquares + double(moments.count) * off * off;
    }
    return squares;
}

void addLine(const CentredSums& sums, const ResidualSquares& squares, LinearityStudy& study)
{
    const double degrees = double(sums.count) - 2;
    if (isSeen(sums.yy, sums))
        study.rSquared = std::clamp(1 - squares.residual / sums.yy, 0.0, 1.0);
    if (!(degrees > 0) || !isSeen(squares.residual, sums))
        return;
    const double s = std::sqrt(squares.residual / degrees);
    study.residualDeviation = s;
    const double mean = sums.meanX;
    const TestOfMean slope = testOfEstimate(study.slope, s / std::sqrt(sums.xx), degrees, study.confidence);
    const TestOfMean intercept =
        testOfEstimate(study.intercept, s * std::sqrt(1 / double(sums.count) + mean * mean / sums.xx),
                       degrees, study.confidence);
    study.tSlope = slope.t;
    study.pSlope = slope.p;
    study.tIntercept = intercept.t;
    study.pIntercept = intercept.p;
    study.zeroLine = fisherTest(sums.zeroSquares - squares.residual, 2, squares.residual, degrees);
}

void addReferences(const BiasesByReference& groups, const CentredSums& sums, const LinearityOptions& options,
                   LinearityStudy& study)
{
    const auto biasAt = [&](double reference, std::size_t count, double mean) {
        ReferenceBias bias;
        bias.reference = reference;
        bias.count = count;
        bias.bias = mean;
        bias.line = study.lineAt(reference);
        bias.band = study.bandAt(reference);
        if (options.processVariation)
            bias.percentBias = 100 * std::abs(mean) / *options.processVariation;
        return bias;
    };
    for (const auto& [reference, biases] : groups) {
        const SampleMoments moments = sampleMoments(biases);
        ReferenceBias bias = biasAt(reference, moments.count, moments.mean);
        if (options.deviation == BiasDeviation::Pooled)
            testBias(bias, study.pooledDeviation, study.pooledDegrees, options.confidence);
        else if (isSeen(moments.sumOfSquares, sums))
            testBias(bias, moments.standardDeviation, double(moments.count) - 1, options.confidence);
        study.references.push_back(bias);
    }
    study.average = biasAt(sums.meanX, sums.count, sums.meanY);
    testBias(study.average, study.pooledDeviation, study.pooledDegrees, options.confidence);
}

bool allNumbers(const CentredSums& sums, const LinearityStudy& study)
{
    const auto finite = [](double number) { return std::isfinite(number); };
    return finite(sums.xx) && sums.xx > 0 && finite(sums.xy) && finite(sums.yy) && finite(sums.zeroSquares) &&
           finite(study.slope) && finite(study.intercept) && finite(sums.meanX * sums.meanX / sums.xx) &&
           finite(study.linearity.value_or(0)) && finite(study.average.percentBias.value_or(0));
}

} // namespace

std::optional<Error> LinearityOptions::validate() const
{
    if (processVariation && !(std::isfinite(*processVariation) && *processVariation > 0))
        return Error{ErrorCode::Usage, {Words::say("The process variation must be a number above zero.")}};
    if (!(confidence > 0 && confidence < 1))
        return Error{ErrorCode::Usage, {Words::say("The confidence must lie between 0 and 1.")}};
    return {};
}

double LinearityStudy::lineAt(double reference) const
{
    return average.bias + slope * (reference - meanReference);
}

std::optional<TwoSidedInterval> LinearityStudy::bandAt(double reference) const
{
    if (!residualDeviation)
        return {};
    const double off = reference - meanReference;
    const double half = studentQuantileAbove((1 - confidence) / 2, double(count) - 2) * *residualDeviation *
                        std::sqrt(1 / double(count) + off * off / spreadOfReferences);
    return TwoSidedInterval{lineAt(reference) - half, lineAt(reference) + half};
}

Expected<LinearityStudy> studyLinearity(std::span<const double> references, std::span<const double> values,
                                        const LinearityOptions& options)
{
    RETURN_IF_ERROR(options.validate());
    if (references.size() != values.size())
        return unusableLinearity(
            Words::say("found %1 references and %2 values").arg(references.size()).arg(values.size()),
            Words::say("expected a reference for each value"));
    std::vector<double> biases;
    BiasesByReference groups;
    for (std::size_t i = 0; i < values.size(); ++i) {
        biases.push_back(values[i] - references[i]);
        if (!std::isfinite(biases.back()))
            return unusableLinearity(Words::say("found a number that is not finite or too large"),
                                     Words::say("expected finite numbers"));
        groups[references[i]].push_back(biases.back());
    }
    if (groups.size() < 2)
        return unusableLinearity(Words::say("found %1 different references").arg(groups.size()),
                                 Words::say("expected 2 at least, better 5 over the whole range; for one "
                                            "reference there is the type-1 study"));
    const CentredSums sums = centredSums(references, biases);
    LinearityStudy study;
    study.count = sums.count;
    study.confidence = options.confidence;
    study.meanReference = sums.meanX;
    study.spreadOfReferences = sums.xx;
    study.average.bias = sums.meanY;
    study.slope = sums.xy / sums.xx;
    study.intercept = study.lineAt(0);
    study.percentLinearity = 100 * std::abs(study.slope);
    if (options.processVariation)
        study.linearity = std::abs(study.slope) * *options.processVariation;
    const ResidualSquares squares = residualSquares(study, groups);
    study.pooledDegrees = double(sums.count - groups.size());
    if (study.pooledDegrees > 0 && isSeen(squares.pure, sums))
        study.pooledDeviation = std::sqrt(squares.pure / study.pooledDegrees);
    addLine(sums, squares, study);
    if (study.pooledDeviation)
        study.lackOfFit = fisherTest(squares.residual - squares.pure, double(groups.size()) - 2, squares.pure,
                                     study.pooledDegrees);
    addReferences(groups, sums, options, study);
    if (!allNumbers(sums, study))
        return unusableLinearity(Words::say("found numbers too large or too small to calculate with"),
                                 Words::say("expected another unit"));
    study.messages = inWords(study, options);
    return study;
}

} // namespace gripscope
