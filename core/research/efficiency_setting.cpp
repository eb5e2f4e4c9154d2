// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/efficiency_setting.h"

#include "core/identification/model/discretization.h"
#include "core/identification/model/response_sensitivities.h"
#include "core/recognition/types/paper_appendix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double lowestFrequency_rad_s = 0.2, highestFrequency_rad_s = 3.0;

/// The types' means in the appendix's own numbers.
std::map<QString, MassDampingStiffness> paperTypes()
{
    const PaperAppendix& appendix = paperAppendix();
    std::map<QString, Eigen::RowVector3d> sums;
    for (Eigen::Index i = 0; i < appendix.parameters.rows(); ++i)
        sums.try_emplace(appendix.object[i], Eigen::RowVector3d::Zero()).first->second +=
            appendix.parameters.row(i);
    std::map<QString, MassDampingStiffness> types;
    for (const auto& [name, sum] : sums) {
        const auto count = static_cast<double>(appendix.object.count(name));
        types[name] = {sum(0) / count, sum(1) / count, sum(2) / count};
    }
    return types;
}

std::vector<double> prbs(const EfficiencySetting& setting)
{
    ExcitationOptions options;
    options.kind = ExcitationKind::Prbs;
    options.peak = 1;
    options.bias = 0;
    options.bit_s = efficiencyBit_s;
    options.sampleTime_s = setting.sampleTime_s;
    options.samples = setting.samples;
    options.oneSided = false;
    return makeExcitation(options).value_or(std::vector<double>(setting.samples, 0.0));
}

std::vector<double> multisine(const EfficiencySetting& setting, EfficiencyExperiment& experiment)
{
    const auto samples = static_cast<double>(setting.samples);
    const double fundamental = 2 * std::numbers::pi / (samples * setting.sampleTime_s);
    experiment.fundamental_rad_s = fundamental;
    for (int harmonic = 1; harmonic * fundamental <= highestFrequency_rad_s; ++harmonic) {
        if (harmonic * fundamental >= lowestFrequency_rad_s)
            experiment.harmonics.push_back(harmonic);
    }
    std::vector<double> force(setting.samples, 0.0);
    const auto count = static_cast<double>(experiment.harmonics.size());
    double largest = 0;
    for (std::size_t t = 0; t < force.size(); ++t) {
        const double time = static_cast<double>(t) * setting.sampleTime_s;
        double order = 0;
        for (const int harmonic : experiment.harmonics) {
            force[t] +=
                std::cos(harmonic * fundamental * time - std::numbers::pi * order * (order + 1) / count);
            ++order;
        }
        largest = std::max(largest, std::abs(force[t]));
    }
    for (double& value : force)
        value /= largest > 0 ? largest : 1;
    return force;
}

double standardDeviation(const std::vector<double>& values)
{
    const auto count = static_cast<double>(values.size());
    double mean = 0;
    for (const double value : values)
        mean += value / count;
    double variance = 0;
    for (const double value : values)
        variance += (value - mean) * (value - mean) / count;
    return std::sqrt(variance);
}

/// What a setting's name is made of.
std::array<QString, 4> wordsOf(const EfficiencySetting& setting)
{
    return {setting.type, toString(setting.excitation), QString::number(setting.fitPercent),
            QString::number(setting.samples)};
}

} // namespace

QString EfficiencySetting::name() const
{
    const std::array<QString, 4> words = wordsOf(*this);
    return u"%1-%2-%3-%4"_s.arg(words[0], words[1], words[2], words[3]);
}

std::vector<EfficiencySetting> efficiencySettings()
{
    std::vector<EfficiencySetting> settings;
    for (const auto& [name, truth] : paperTypes()) {
        for (const ExcitationKind excitation : {ExcitationKind::Prbs, ExcitationKind::Multisine}) {
            for (const double fitPercent : {85.0, 90.0, 95.0}) {
                for (const std::size_t samples : {std::size_t(200), std::size_t(1000)})
                    settings.push_back({name, truth, excitation, fitPercent, samples, 0.05});
            }
        }
    }
    return settings;
}

std::vector<EfficiencySetting> selectSettings(const QStringList& words)
{
    std::vector<EfficiencySetting> all = efficiencySettings();
    std::vector<EfficiencySetting> selected;
    // Which kinds of word were given, and whether each word is one.
    std::array<bool, 4> asked{};
    for (const QString& word : words) {
        bool known = false;
        for (const EfficiencySetting& setting : all) {
            const std::array<QString, 4> own = wordsOf(setting);
            for (std::size_t i = 0; i < own.size(); ++i) {
                asked[i] = asked[i] || own[i] == word;
                known = known || own[i] == word;
            }
            known = known || setting.name() == word;
        }
        if (!known)
            return {};
    }
    const bool anyKind = std::any_of(asked.begin(), asked.end(), [](bool one) { return one; });
    for (const EfficiencySetting& setting : all) {
        const std::array<QString, 4> own = wordsOf(setting);
        bool fits = anyKind || words.isEmpty();
        for (std::size_t i = 0; i < own.size(); ++i)
            fits = fits && (!asked[i] || words.contains(own[i]));
        if (fits || words.contains(setting.name()))
            selected.push_back(setting);
    }
    return selected;
}

EfficiencyExperiment makeExperiment(const EfficiencySetting& setting)
{
    EfficiencyExperiment experiment;
    experiment.force =
        setting.excitation == ExcitationKind::Multisine ? multisine(setting, experiment) : prbs(setting);
    SimulationOptions simulation;
    simulation.sampleTime_s = setting.sampleTime_s;
    simulation.hold = ForceHold::Zero;
    experiment.position = simulate(setting.truth, experiment.force, simulation);
    // Fit = 1 - sd / sqrt(signal^2 + sd^2), solved for sd.
    const double miss = 1 - setting.fitPercent / 100;
    experiment.noiseDeviation = standardDeviation(experiment.position) * miss / std::sqrt(1 - miss * miss);
    SensitivityOptions sensitivity;
    sensitivity.sampleTime_s = setting.sampleTime_s;
    experiment.bound = cramerRaoBound(setting.truth, experiment.force, sensitivity, experiment.noiseDeviation)
                           .value_or(Eigen::Vector3d::Zero());
    return experiment;
}

} // namespace gripscope
