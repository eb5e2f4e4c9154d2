// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/recognition_study.h"

#include "core/base/parallel_runs.h"
#include "core/recognition/types/paper_appendix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Squeezes a type, and the rate stated with them.
constexpr std::array<std::pair<int, double>, 4> settings{{{3, 0.01}, {5, 0.01}, {10, 0.01}, {10, 0.001}}};

RecognitionScenario scenario(ScenarioKind kind, int squeezes, double rate)
{
    RecognitionScenario made;
    made.kind = kind;
    made.squeezes = squeezes;
    made.options.siUnits = false; // no instrument's range: strangers are a row of their own
    if (kind == ScenarioKind::Neighbours)
        made.options.wrongType = rate;
    else if (kind == ScenarioKind::StrangersInRange)
        made.options.strangerAccept = rate;
    else
        made.options.falseReject = rate;
    if (kind == ScenarioKind::Promise)
        made.options.confidence = 0.95;
    return made;
}

/// What else squeezes may determine: a slow gripper k, with or without its relaxation; a fast one of a
/// viscoelastic part all but friction, or all.
std::vector<QuantitySpace> otherSpaces()
{
    using enum TypeQuantity;
    return {{{Stiffness}},
            {{Stiffness, RelaxingShare, RelaxationTime}},
            {{Mass, Damping, Stiffness, RelaxingShare, RelaxationTime}},
            {{Mass, Damping, Stiffness, RelaxingShare, RelaxationTime, Friction}}};
}

/// The three rates in other spaces than m, b, k.
std::vector<RecognitionScenario> scenariosOfSpaces()
{
    std::vector<RecognitionScenario> all;
    for (const QuantitySpace& space : otherSpaces()) {
        for (const ScenarioKind kind :
             {ScenarioKind::KnownParts, ScenarioKind::Neighbours, ScenarioKind::StrangersInRange}) {
            for (const auto& setting : settings) {
                all.push_back(scenario(kind, setting.first, setting.second));
                all.back().space = space;
            }
        }
    }
    return all;
}

std::vector<RecognitionScenario> scenarios()
{
    std::vector<RecognitionScenario> all;
    for (const ScenarioKind kind :
         {ScenarioKind::KnownParts, ScenarioKind::Promise, ScenarioKind::Neighbours, ScenarioKind::Strangers,
          ScenarioKind::TwiceTheSpread, ScenarioKind::HeavyTails}) {
        for (const auto& setting : settings) {
            RecognitionScenario plain = scenario(kind, setting.first, setting.second);
            if (kind == ScenarioKind::Strangers) {
                for (const double deviations : {4.0, 6.0, 10.0}) {
                    plain.deviations = deviations;
                    all.push_back(plain);
                }
                continue;
            }
            all.push_back(plain);
            if (kind == ScenarioKind::KnownParts || kind == ScenarioKind::Neighbours) {
                plain.unlikeScatter = true;
                all.push_back(plain);
            }
            if (kind == ScenarioKind::TwiceTheSpread || kind == ScenarioKind::HeavyTails) {
                plain.options.robust = true;
                all.push_back(plain);
            }
        }
    }
    RecognitionScenario mismatch = scenario(ScenarioKind::NoiseMismatch, 10, 0.01);
    mismatch.judged = 200;
    all.push_back(mismatch);
    for (const auto& setting : settings)
        all.push_back(scenario(ScenarioKind::StrangersInRange, setting.first, setting.second));
    for (RecognitionScenario& other : scenariosOfSpaces())
        all.push_back(std::move(other));
    return all;
}

StudyLimit limitOf(const StudyTally& tally, const QString& name, double divisor, const QString& figure)
{
    const ClusteredShare share = tally.shares.value(name);
    return {figure, share.share / divisor, share.standardError / divisor, {}, {}};
}

/// Named at all over those an oracle names; the standard error is that of the numerator alone.
StudyLimit decidedOver(const StudyTally& tally, const QString& oracle, const QString& figure)
{
    const ClusteredShare right = tally.shares.value(u"type"_s);
    const ClusteredShare wrong = tally.shares.value(u"wrong_type"_s);
    const double known = tally.shares.value(oracle).share;
    StudyLimit limit{figure, 0, 0, {}, {}};
    if (known > 0) {
        limit.value = (right.share + wrong.share) / known;
        limit.standardError = std::hypot(right.standardError, wrong.standardError) / known;
    }
    return limit;
}

std::vector<StudyLimit> limitsOf(const RecognitionScenario& scenario, const StudyTally& tally)
{
    const double stated = scenario.statedRate();
    const auto bounded = [](StudyLimit limit, std::optional<double> least, std::optional<double> most) {
        limit.least = least;
        limit.most = most;
        return limit;
    };
    switch (scenario.kind) {
    case ScenarioKind::KnownParts:
        return {bounded(limitOf(tally, u"unknown"_s, stated, u"unknown / stated"_s), 0.8, 1.2)};
    case ScenarioKind::Promise:
        return {bounded(limitOf(tally, u"kept"_s, 1, u"enrolments that keep the rate"_s), 0.94, {})};
    case ScenarioKind::Neighbours:
        // As many as the rate allows can be named only by who knows the true types: shown, held to nothing.
        // Nor is it where the scatter may be of any shape, which fewer squeezes cannot tell.
        if (scenario.space != QuantitySpace{})
            return {bounded(limitOf(tally, u"wrong_type"_s, stated, u"wrong type / stated"_s), {}, 1.2),
                    decidedOver(tally, u"oracle_rate"_s, u"decided / oracle_rate's"_s)};
        if (scenario.unlikeScatter)
            return {decidedOver(tally, u"oracle_rate"_s, u"decided / oracle_rate's"_s)};
        return {bounded(limitOf(tally, u"wrong_type"_s, stated, u"wrong type / stated"_s), {}, 1.2),
                bounded(decidedOver(tally, u"oracle_posterior"_s, u"decided / oracle's"_s), 0.9, {}),
                decidedOver(tally, u"oracle_rate"_s, u"decided / oracle_rate's"_s)};
    case ScenarioKind::TwiceTheSpread:
    case ScenarioKind::HeavyTails:
        if (!scenario.options.robust)
            return {};
        return {bounded(limitOf(tally, u"unknown"_s, stated, u"unknown / stated"_s), {}, 3)};
    case ScenarioKind::NoiseMismatch:
        return {bounded(limitOf(tally, u"wrong_type"_s, 1, u"wrong type"_s), {}, 0.001),
                bounded(limitOf(tally, u"type"_s, 1, u"named as themselves"_s), 0.98, {})};
    case ScenarioKind::StrangersInRange:
        return {bounded(limitOf(tally, u"accepted"_s, stated, u"accepted / stated"_s), {}, 1.2)};
    case ScenarioKind::Strangers:
        break;
    }
    return {};
}

PaperRecognition recognizePaper()
{
    const std::vector<TypeSqueeze> all = paperSqueezesInSi();
    const TypeModels models = fitTypeModels(all);
    PaperRecognition paper;
    paper.squeezes = int(all.size());
    paper.leaveOneOutCorrect = leaveOneOutCorrect(all);
    for (const TypeSqueeze& squeeze : all) {
        std::vector<TypeSqueeze> others = all;
        std::erase_if(others, [&](const TypeSqueeze& other) { return other.type == squeeze.type; });
        paper.leftOutTypeUnknown +=
            judge(fitTypeModels(others), squeeze.parameters).kind == VerdictKind::Unknown;
        paper.rejectedInTraining += judge(models, squeeze.parameters).kind == VerdictKind::Unknown;
    }
    return paper;
}

} // namespace

bool StudyLimit::met() const
{
    return (!least || value >= *least) && (!most || value <= *most);
}

RecognitionRow studyRow(const RecognitionScenario& scenario, const RecognitionStudyOptions& options)
{
    const bool identified = scenario.kind == ScenarioKind::NoiseMismatch;
    const int runs = identified ? std::max(1, options.runs / 10) : std::max(1, options.runs);
    const QString name = scenario.name();
    const auto one = [&](int run) {
        const std::uint64_t seed = runSeed(options.seed, name, static_cast<std::uint64_t>(run));
        return identified ? runNoiseMismatch(scenario, seed) : runScenario(scenario, seed);
    };
    RecognitionRow row{scenario, pooled(tallyRuns(runs, options.threads, one)), {}};
    row.limits = limitsOf(scenario, row.tally);
    return row;
}

RecognitionStudy studyRecognition(const RecognitionStudyOptions& options)
{
    RecognitionStudy study;
    const std::vector<RecognitionScenario> all = scenarios();
    for (const RecognitionScenario& scenario : all) {
        study.rows.push_back(studyRow(scenario, options));
        if (options.progress)
            options.progress(int(study.rows.size()), int(all.size()));
    }
    study.paper = recognizePaper();
    return study;
}

} // namespace gripscope
