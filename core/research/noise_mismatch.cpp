// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/discretization.h"
#include "core/identification/output_error/output_error.h"
#include "core/math/gaussian.h"
#include "core/research/efficiency_setting.h"
#include "core/research/recognition_scenario.h"

#include <array>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int mismatchTypes = 4;
constexpr double mismatchScatter = 0.039;
constexpr double enrolledFit = 95, judgedFit = 85;

struct TypeExperiment {
    EfficiencySetting setting;
    EfficiencyExperiment experiment;
};

/// The paper's four types at one noise fit, made once.
std::array<TypeExperiment, mismatchTypes> experimentsAt(double fitPercent)
{
    std::array<TypeExperiment, mismatchTypes> made;
    for (int type = 0; type < mismatchTypes; ++type) {
        const QString name(QChar(u'A' + type));
        TypeExperiment& one = made[std::size_t(type)];
        one.setting = selectSettings({u"%1-prbs-%2-200"_s.arg(name).arg(fitPercent)}).front();
        one.setting.samples = 400;
        one.experiment = makeExperiment(one.setting);
    }
    return made;
}

/// A squeeze of a new part, measured and identified. No parameters where that failed.
TypeSqueeze squeeze(const TypeExperiment& type, GaussianNoise& noise)
{
    const auto part = [&](double value) { return value * std::exp(mismatchScatter * noise()); };
    const MassDampingStiffness& mean = type.setting.truth;
    MassDampingStiffness truth;
    truth.m = part(mean.m);
    truth.b = part(mean.b);
    truth.k = part(mean.k);
    SimulationOptions simulation;
    simulation.sampleTime_s = type.setting.sampleTime_s;
    simulation.hold = ForceHold::Zero;
    std::vector<double> position = simulate(truth, type.experiment.force, simulation);
    for (double& y : position)
        y += type.experiment.noiseDeviation * noise();
    OutputErrorOptions options;
    options.sampleTime_s = type.setting.sampleTime_s;
    options.hold = ForceHold::Zero;
    const Estimate estimate = estimateOutputError(type.experiment.force, position, options);
    TypeSqueeze result{type.setting.type, {}};
    if (estimate.status == EstimateStatus::Converged && estimate.parameters) {
        result.parameters = *estimate.parameters;
        result.covariance = estimate.covariance;
    }
    return result;
}

} // namespace

EnrolmentTally runNoiseMismatch(const RecognitionScenario& scenario, std::uint64_t seed)
{
    static const std::array<TypeExperiment, mismatchTypes> quiet = experimentsAt(enrolledFit);
    static const std::array<TypeExperiment, mismatchTypes> loud = experimentsAt(judgedFit);
    GaussianNoise noise(seed);
    std::vector<TypeSqueeze> enrolled;
    for (const TypeExperiment& type : quiet)
        for (int i = 0; i < scenario.squeezes; ++i)
            enrolled.push_back(squeeze(type, noise));
    const TypeModels models = fitTypeModels(enrolled);
    EnrolmentTally tally;
    for (int i = 0; i < scenario.judged; ++i) {
        const TypeExperiment& type = loud[std::size_t(i % mismatchTypes)];
        const TypeSqueeze next = squeeze(type, noise);
        count(judge(models, next.parameters, scenario.options, next.covariance), next.type, tally);
        // What it would be without the squeeze's own covariance.
        const Verdict blind = judge(models, next.parameters, scenario.options);
        tally.counts[u"without_covariance_unknown"_s] += blind.kind == VerdictKind::Unknown;
        tally.counts[u"without_covariance_wrong_type"_s] +=
            blind.kind == VerdictKind::Type && blind.type != next.type;
    }
    return tally;
}

} // namespace gripscope
