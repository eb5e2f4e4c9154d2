// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/enroll/simulated_examples.h"

#include "core/base/parallel_runs.h"
#include "core/identification/identification.h"
#include "core/identification/motion/motion_integrator.h"
#include "core/math/gaussian.h"
#include "core/recognition/types/simulated_parts.h"
#include "core/session/enroll/enrollment_storage.h"
#include "core/session/squeeze/squeeze_job.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int squeezesOfEach = 6;
constexpr double scatter = 0.04, noise_m = 5e-6;

Recipe exampleRecipe()
{
    Recipe recipe = recipeOfNewTypes();
    recipe.name = u"squeeze-5N"_s;
    recipe.peak_N = 5;
    recipe.bias_N = 10;
    recipe.bit_s = 0.01;
    recipe.maxForce_N = 20;
    return recipe;
}

MotionValues drawn(const SimulatedPart& part, GaussianNoise& noise)
{
    using P = MotionParameter;
    MotionValues values;
    const auto vary = [&noise](double usual) { return usual * std::exp(scatter * noise()); };
    values[P::Mass] = vary(part.centre.m);
    values[P::Damping] = vary(part.centre.b);
    values[P::Stiffness] = vary(part.centre.k);
    values[P::Relaxing] = vary(part.relaxingShare * part.centre.k);
    values[P::RelaxationTime] = vary(part.relaxationTime_s);
    return values;
}

/// One squeeze by the recipe, from rest under its preload.
Recording squeezed(const SimulatedPart& part, const Recipe& recipe, std::uint64_t seed)
{
    const GripperIdentity gripper;
    GaussianNoise noise(seed);
    const MotionValues values = drawn(part, noise);
    MotionIntegrator<double> motion({.relaxation = true}, values.values);
    Recording recording;
    recording.sampleTime_s = gripper.sampleTime_s;
    recording.hold = gripper.hold;
    recording.forceUnit = gripper.forceUnit;
    recording.positionUnit = gripper.positionUnit;
    recording.provenance = {{u"source"_s, u"simulated"_s}, {forceLagSourceKey(), u"stated"_s}};
    recording.force =
        makeExcitation(excitationOptions(recipe, gripper, seed)).value_or(std::vector<double>());
    motion.begin(recipe.bias_N / values[MotionParameter::Stiffness], 0, 0, recipe.bias_N);
    for (const double force : recording.force) {
        recording.time_s.push_back(static_cast<double>(recording.position.size()) * gripper.sampleTime_s);
        recording.position.push_back(motion.position() + noise_m * noise());
        if (!motion.advance(gripper.sampleTime_s, force, force))
            break; // no part of ours is that stiff
    }
    recording.force.resize(recording.position.size());
    return recording;
}

} // namespace

std::vector<ExampleType> simulatedExamples()
{
    const Recipe recipe = exampleRecipe();
    const GripperIdentity gripper;
    std::vector<ExampleType> examples;
    for (const SimulatedPart& part : simulatedParts())
        examples.push_back({part.name, recipe, gripper.forceUnit, gripper.positionUnit,
                            std::vector<NewGrasp>(squeezesOfEach)});
    shareAmongThreads(std::int64_t(examples.size()) * squeezesOfEach, 0, [&](std::int64_t number) {
        const auto [type, squeeze] = std::div(number, std::int64_t(squeezesOfEach));
        const Recording recording =
            squeezed(simulatedParts()[std::size_t(type)], recipe, std::uint64_t(number) + 1);
        examples[std::size_t(type)].squeezes[std::size_t(squeeze)] =
            makeGrasp(recording, identify(recording), u"simulated"_s, u"example"_s);
    });
    return examples;
}

} // namespace gripscope
