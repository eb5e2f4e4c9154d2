// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/truth_settings.h"

#include "core/math/gaussian.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// The can of physics.md, squeezed as there.
TruthSetting can(const QString& name, int levels = 2)
{
    TruthSetting setting;
    setting.name = name;
    setting.part = {.m = 0.0396, .b = 43, .k = 9990};
    setting.levels = levels;
    return setting;
}

TruthSetting rubbing(double friction, int levels)
{
    TruthSetting setting = can(u"friction %1 N, %2 levels"_s.arg(friction).arg(levels), levels);
    setting.part.friction = friction;
    return setting;
}

TruthSetting hysteretic(double force, double reach = 1e-4)
{
    TruthSetting setting = can(u"hysteresis %1 N over %2 mm"_s.arg(force).arg(1000 * reach));
    setting.part.hysteresis = force;
    setting.part.hysteresisReach = reach;
    setting.inFamily = false;
    return setting;
}

TruthSetting yielding(double share, double tau_s, int levels = 2)
{
    TruthSetting setting =
        can(u"relaxes %1 % over %2 ms, %3 levels"_s.arg(100 * share).arg(1000 * tau_s).arg(levels), levels);
    setting.part.relaxing = share * setting.part.k;
    setting.part.relaxationTime_s = tau_s;
    return setting;
}

TruthSetting jittering(double share, int levels = 2)
{
    TruthSetting setting = can(u"jitter %1 %, %2 levels"_s.arg(100 * share).arg(levels), levels);
    setting.jitterShare = share;
    setting.inFamily = false;
    return setting;
}

/// A part of this frequency and damping ratio 0.3, k as the can's, sampled so often; bits of 0.4 periods, 200
/// of them, noise of 1 % of what the amplitude moves it.
TruthSetting swinging(double frequency_Hz, double rate_Hz, int levels)
{
    TruthSetting setting =
        can(u"%1 Hz, sampled at %2 Hz, %3 levels"_s.arg(frequency_Hz).arg(rate_Hz).arg(levels), levels);
    const double speed = 2 * std::numbers::pi * frequency_Hz;
    setting.part.m = setting.part.k / (speed * speed);
    setting.part.b = 0.6 * std::sqrt(setting.part.k * setting.part.m);
    setting.sampleTime_s = 1 / rate_Hz;
    setting.bit_s = 0.4 / frequency_Hz;
    setting.seconds = 200 * setting.bit_s;
    return setting;
}

/// The same with friction of a share of the amplitude, or relaxing.
TruthSetting with(TruthSetting setting, double friction, double relaxing = 0, double tau_s = 0.05)
{
    setting.part.friction = friction;
    setting.part.relaxing = relaxing * setting.part.k;
    setting.part.relaxationTime_s = tau_s;
    if (friction > 0)
        setting.name += u", friction %1 N"_s.arg(friction);
    if (relaxing > 0)
        setting.name += u", relaxes %1 % over %2 ms"_s.arg(100 * relaxing).arg(1000 * tau_s);
    return setting;
}

/// Another force about another preload; noise of 1 % of what it moves.
TruthSetting pressed(TruthSetting setting, double bias, double amplitude)
{
    setting.name += u", %1 ± %2 N"_s.arg(bias).arg(amplitude);
    setting.bias = bias;
    setting.amplitude = amplitude;
    setting.noise_m = 0.01 * amplitude / setting.part.k;
    return setting;
}

/// A millimetre takes this share more force than a straight spring would, or less.
TruthSetting bent(TruthSetting setting, double share)
{
    constexpr double reach = 1e-3;
    setting.name += (share > 0 ? u", stiffens %1 %"_s : u", softens %1 %"_s).arg(100 * std::abs(share));
    setting.part.cubic = share * setting.part.k / (reach * reach);
    return setting;
}

void addTheCan(std::vector<TruthSetting>& all)
{
    all.push_back(can(u"plain"_s));
    TruthSetting noisy = can(u"noise 50 um"_s);
    noisy.noise_m = 5e-5;
    all.push_back(noisy);
    for (const double friction : {0.3, 1.0, 3.0})
        for (const int levels : {2, 4})
            all.push_back(rubbing(friction, levels));
    for (const double force : {0.3, 1.0})
        all.push_back(hysteretic(force));
    for (const auto& [share, tau_s] : {std::pair(0.05, 0.05), {0.3, 0.05}, {0.3, 0.005}, {0.1, 0.3}})
        all.push_back(yielding(share, tau_s));
    all.push_back(with(can(u"both"_s, 4), 0.3, 0.2, 0.03));
    all.push_back(bent(can(u"spring"_s), 0.1));
    all.push_back(jittering(0.1));
}

void addOthers(std::vector<TruthSetting>& all)
{
    all.push_back(rubbing(0.1, 2));
    all.push_back(rubbing(0.1, 4));
    all.push_back(rubbing(0.6, 3));
    all.push_back(hysteretic(0.1));
    all.push_back(hysteretic(0.5, 1e-3));
    all.push_back(yielding(0.02, 0.02));
    all.push_back(yielding(0.5, 0.1, 4));
    all.push_back(yielding(0.2, 1.0));
    all.push_back(jittering(0.05, 4));
    all.push_back(jittering(0.2));
    all.push_back(swinging(5, 100, 2));
    all.push_back(swinging(5, 200, 4));
    all.push_back(with(swinging(5, 200, 4), 0.5));
    all.push_back(with(swinging(5, 100, 2), 0, 0.3, 0.4));
    all.push_back(swinging(20, 500, 4));
    all.push_back(with(swinging(20, 1000, 2), 0.4));
    all.push_back(swinging(200, 6000, 2));
    all.push_back(with(swinging(200, 6000, 4), 0.5));
    all.push_back(with(swinging(200, 6000, 2), 0, 0.2, 0.003));
    all.push_back(pressed(can(u"gently"_s, 4), 5, 2));
    all.push_back(pressed(can(u"firmly"_s, 2), 60, 30));
    all.push_back(with(pressed(can(u"firmly"_s, 4), 60, 30), 3));
    all.push_back(with(bent(can(u"spring"_s, 4), 0.1), 0.5));
    all.push_back(bent(can(u"spring"_s, 4), 0.02));
    TruthSetting overdamped = can(u"overdamped"_s, 4);
    overdamped.part.b = 120;
    all.push_back(overdamped);
}

} // namespace

std::vector<TruthSetting> truthSettings()
{
    std::vector<TruthSetting> all;
    addTheCan(all);
    addOthers(all);
    return all;
}

std::vector<ModelSetting> modelSettings()
{
    std::vector<ModelSetting> all{{Estimator::OutputError, can(u"plain"_s, 4)}};
    for (const double friction : {0.0, 0.01, 0.1, 0.3, 1.0})
        all.push_back({Estimator::Friction, rubbing(friction, 4)});
    for (const auto& [share, tau_s] : {std::pair(0.05, 0.05), {0.3, 0.05}, {0.3, 0.005}})
        all.push_back({Estimator::Zener, yielding(share, tau_s, 4)});
    for (const double share : {0.05, -0.005})
        all.push_back({Estimator::Duffing, bent(can(u"spring"_s, 4), share)});
    return all;
}

MotionTerms termsOf(const RealPart& part)
{
    return {.friction = part.friction > 0, .relaxation = part.relaxing > 0, .cubic = part.cubic != 0};
}

MotionValues valuesOf(const RealPart& part)
{
    using P = MotionParameter;
    MotionValues values;
    values[P::Mass] = part.m;
    values[P::Damping] = part.b;
    values[P::Stiffness] = part.k;
    values[P::Friction] = part.friction;
    values[P::Relaxing] = part.relaxing;
    values[P::RelaxationTime] = part.relaxationTime_s;
    values[P::Cubic] = part.cubic;
    return values;
}

Recording drawSqueeze(const TruthSetting& setting, std::uint64_t seed)
{
    Recording recording;
    recording.sampleTime_s = setting.sampleTime_s;
    recording.hold = ForceHold::Zero;
    recording.forceUnit = QStringLiteral("N");
    recording.positionUnit = QStringLiteral("m");
    std::mt19937_64 draws(seed);
    GaussianNoise noise(seed + 1);
    const auto samples = static_cast<int>(std::lround(setting.seconds / setting.sampleTime_s));
    const int bit = std::max(1, static_cast<int>(std::lround(setting.bit_s / setting.sampleTime_s)));
    const auto levels = static_cast<std::uint64_t>(setting.levels);
    std::vector<double> times_s;
    double force = 0;
    for (int i = 0; i < samples; ++i) {
        if (i % bit == 0)
            force = setting.bias +
                    setting.amplitude *
                        (2 * static_cast<double>(draws() % levels) / static_cast<double>(levels - 1) - 1);
        recording.time_s.push_back(i * setting.sampleTime_s);
        recording.force.push_back(force);
        // Cut at 3.3 deviations, so that the times still rise.
        const double beside = std::clamp(setting.jitterShare * noise(), -0.33, 0.33);
        times_s.push_back(std::max(0.0, (i + beside) * setting.sampleTime_s));
    }
    // At rest under the bias before.
    std::vector<double> forceTimes_s{-1.0};
    std::vector<double> forces{setting.bias};
    forceTimes_s.insert(forceTimes_s.end(), recording.time_s.begin(), recording.time_s.end());
    forces.insert(forces.end(), recording.force.begin(), recording.force.end());
    recording.position = simulateRealPart(setting.part, forceTimes_s, forces, ForceHold::Zero, times_s);
    for (double& x : recording.position)
        x += setting.noise_m * noise();
    return recording;
}

} // namespace gripscope
