// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/early_decision_study.h"

#include "core/base/parallel_runs.h"
#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/recognition/types/paper_appendix.h"
#include "core/signal/excitation/excitation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double sampleTime_s = 0.05, bit_s = 0.5;

/// The mean of the logarithms of each of the paper's types.
std::map<QString, Eigen::Vector3d> paperMeans()
{
    std::map<QString, Eigen::Vector3d> sums;
    std::map<QString, int> counts;
    for (const TypeSqueeze& squeeze : paperSqueezesAsPrinted()) {
        const Eigen::Vector3d log = squeeze.parameters.vector().array().log();
        sums.try_emplace(squeeze.type, Eigen::Vector3d::Zero()).first->second += log;
        ++counts[squeeze.type];
    }
    for (auto& [name, sum] : sums)
        sum /= counts[name];
    return sums;
}

Eigen::Vector3d normalVector(GaussianNoise& noise)
{
    Eigen::Vector3d vector;
    for (double& value : vector)
        value = noise();
    return vector;
}

double deviationOf(const std::vector<double>& values)
{
    const double mean =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    double squares = 0;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return std::sqrt(squares / static_cast<double>(values.size()));
}

/// One squeeze: what was squeezed, and the program's library that day.
struct Draw {
    std::optional<std::size_t> truth; ///< empty: a stranger
    std::vector<CandidateType> library;
    std::vector<double> force, position;
};

std::vector<double> prbs(const EarlyDecisionSetting& setting, std::uint64_t seed)
{
    ExcitationOptions options;
    options.peak = 1;
    options.bias = 0;
    options.bit_s = bit_s;
    options.sampleTime_s = sampleTime_s;
    options.samples = setting.longest;
    options.seed = seed;
    options.oneSided = false;
    return makeExcitation(options).value_or(std::vector<double>());
}

void measure(Draw& draw, const EarlyDecisionSetting& setting, const Eigen::Vector3d& logs,
             GaussianNoise& noise)
{
    SimulationOptions simulation;
    simulation.sampleTime_s = sampleTime_s;
    const MassDampingStiffness object{std::exp(logs(0)), std::exp(logs(1)), std::exp(logs(2))};
    draw.position = simulate(object, draw.force, simulation);
    const double signal = deviationOf(draw.position);
    if (!setting.restKnown) {
        simulation.x0 = 0.3 * signal * noise();
        simulation.v0 = 0.3 * signal * std::sqrt(object.k / object.m) * noise();
        simulation.offset = signal * noise();
        draw.position = simulate(object, draw.force, simulation);
    }
    // Fit = 1 - sd / sqrt(signal^2 + sd^2), solved for sd.
    const double miss = 1 - setting.fitPercent / 100;
    const double deviation = signal * miss / std::sqrt(1 - miss * miss);
    const double driving = deviation * std::sqrt(1 - setting.noisePole * setting.noisePole);
    double error = deviation * noise();
    for (double& y : draw.position) {
        y += error;
        error = setting.noisePole * error + driving * noise();
    }
}

Draw drawSqueeze(const EarlyDecisionStudyOptions& options, int run)
{
    static const std::map<QString, Eigen::Vector3d> means = paperMeans();
    const EarlyDecisionSetting& setting = options.setting;
    const std::uint64_t seed = runSeed(options.seed, setting.name(), static_cast<std::uint64_t>(run));
    GaussianNoise noise(seed);
    const double enrolled = std::max(setting.enrolled, 1);
    const double variance = setting.scatter * setting.scatter;
    Draw draw;
    std::vector<CandidateType> truth;
    for (const auto& [name, mean] : means) {
        truth.push_back({name, mean, variance * Eigen::Matrix3d::Identity()});
        draw.library.push_back({name, mean + setting.scatter / std::sqrt(enrolled) * normalVector(noise),
                                (1 + 1 / enrolled) * variance * Eigen::Matrix3d::Identity()});
    }
    draw.force = prbs(setting, seed);
    Eigen::Vector3d logs;
    if (noise.uniform() < options.strangerShare) {
        const InstrumentRange range = rangeAround(truth);
        const Eigen::Vector3d lowest = range.lowest.vector().array().log();
        const Eigen::Vector3d highest = range.highest.vector().array().log();
        for (Eigen::Index i = 0; i < 3; ++i)
            logs(i) = lowest(i) + noise.uniform() * (highest(i) - lowest(i));
    } else {
        draw.truth = std::min(static_cast<std::size_t>(noise.uniform() * static_cast<double>(truth.size())),
                              truth.size() - 1);
        logs = truth[*draw.truth].meanLog + setting.scatter * normalVector(noise);
    }
    measure(draw, setting, logs, noise);
    return draw;
}

struct DrawOutcome {
    std::optional<std::size_t> truth;
    std::vector<char> right;              ///< at each look, whether the likeliest is what was squeezed
    std::optional<std::size_t> decidedAt; ///< the look
    std::optional<std::size_t> called;    ///< the type, when it was decided to be one
};

EarlyDecisionOptions deciderOptions(const EarlyDecisionStudyOptions& options)
{
    EarlyDecisionOptions decision;
    decision.sampleTime_s = sampleTime_s;
    decision.hold = ForceHold::Zero;
    decision.freeInitialState = decision.freeOffset = !options.setting.restKnown;
    decision.statedError = options.statedError;
    decision.strangerShare = options.strangerShare;
    decision.colouredNoise = options.setting.colouredNoise;
    return decision;
}

DrawOutcome perform(const EarlyDecisionStudyOptions& options, int run)
{
    const Draw draw = drawSqueeze(options, run);
    EarlyDecider decider(draw.library, rangeAround(draw.library), deciderOptions(options));
    DrawOutcome outcome;
    outcome.truth = draw.truth;
    for (std::size_t t = 0; t < draw.force.size(); ++t) {
        if (!decider.add(draw.force[t], draw.position[t]))
            continue;
        const EarlyJudgement& judgement = decider.look();
        outcome.right.push_back(!judgement.posterior.empty() && judgement.best == draw.truth);
        if (decider.decided() && !outcome.decidedAt) {
            outcome.decidedAt = outcome.right.size() - 1;
            outcome.called = judgement.best;
        }
    }
    return outcome;
}

/// The lengths at which the decider looks.
std::vector<std::size_t> lookLengths(const EarlyDecisionStudyOptions& options)
{
    EarlyDecider decider({}, {}, deciderOptions(options));
    std::vector<std::size_t> lengths;
    for (std::size_t t = 1; t <= options.setting.longest; ++t)
        if (decider.add(0, 0))
            lengths.push_back(t);
    return lengths;
}

void countDecisions(const std::vector<DrawOutcome>& outcomes, EarlyDecisionStudy& study)
{
    for (const DrawOutcome& outcome : outcomes) {
        study.strangers += outcome.truth ? 0 : 1;
        const bool rightAtLast = !outcome.right.empty() && outcome.right.back() != 0;
        if (!outcome.decidedAt) {
            study.wrongWhenForced += rightAtLast ? 0 : 1;
            continue;
        }
        ++study.decided;
        if (outcome.called == outcome.truth)
            continue;
        ++study.wrong;
        ++study.wrongWhenForced;
        if (!outcome.truth)
            ++study.strangersAccepted;
        else
            ++(outcome.called ? study.wrongTypes : study.knownCalledStrangers);
    }
}

void findEqualLength(const std::vector<DrawOutcome>& outcomes, const std::vector<std::size_t>& lengths,
                     EarlyDecisionStudy& study)
{
    for (std::size_t look = 0; look < lengths.size(); ++look) {
        int wrong = 0;
        for (const DrawOutcome& outcome : outcomes)
            wrong += outcome.right[look] != 0 ? 0 : 1;
        if (wrong <= study.wrongWhenForced) {
            study.equalFixedLength = lengths[look];
            study.saving = static_cast<double>(lengths[look]) / study.meanSamples;
            return;
        }
    }
}

} // namespace

QString EarlyDecisionSetting::name() const
{
    return u"%1-%2-%3"_s.arg(restKnown ? u"rest"_s : u"free"_s)
        .arg(fitPercent)
        .arg(noisePole == 0 ? u"white"_s : QString::number(noisePole));
}

std::vector<EarlyDecisionSetting> earlyDecisionSettings()
{
    std::vector<EarlyDecisionSetting> settings;
    for (const bool restKnown : {true, false})
        for (const double fitPercent : {90.0, 95.0})
            for (const double pole : {0.0, 0.8}) {
                EarlyDecisionSetting setting;
                setting.restKnown = restKnown;
                setting.fitPercent = fitPercent;
                setting.noisePole = pole;
                settings.push_back(setting);
            }
    return settings;
}

EarlyDecisionStudy studyEarlyDecisions(const EarlyDecisionStudyOptions& options)
{
    EarlyDecisionStudy study;
    study.setting = options.setting;
    study.runs = std::max(options.runs, 0);
    const std::vector<std::size_t> lengths = lookLengths(options);
    std::vector<DrawOutcome> outcomes(static_cast<std::size_t>(study.runs));
    performRuns(study.runs, options.threads, options.progress, [&](std::int64_t run) {
        outcomes[static_cast<std::size_t>(run)] = perform(options, static_cast<int>(run));
    });
    if (outcomes.empty())
        return study;
    std::vector<double> samples;
    samples.reserve(outcomes.size());
    for (const DrawOutcome& outcome : outcomes)
        samples.push_back(
            static_cast<double>(outcome.decidedAt ? lengths[*outcome.decidedAt] : options.setting.longest));
    std::sort(samples.begin(), samples.end());
    const auto quantile = [&](double share) {
        return samples[static_cast<std::size_t>(share * static_cast<double>(samples.size() - 1))];
    };
    study.meanSamples =
        std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
    study.medianSamples = quantile(0.5);
    study.ninetyPercentSamples = quantile(0.9);
    countDecisions(outcomes, study);
    findEqualLength(outcomes, lengths, study);
    return study;
}

} // namespace gripscope
