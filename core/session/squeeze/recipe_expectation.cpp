// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/recipe_expectation.h"

#include "core/identification/motion/expected_deviations.h"
#include "core/math/normal_interval.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

namespace {

using P = MotionParameter;

constexpr std::size_t longestExpected = 100'000;

MotionValues valuesOf(const ExpectedPart& part, const Recipe& recipe)
{
    MotionValues values;
    values[P::Mass] = part.m_kg;
    values[P::Damping] = part.b_Ns_per_m;
    values[P::Stiffness] = part.k_N_per_m;
    values[P::Friction] = part.frictionShare * recipe.peak_N;
    values[P::Relaxing] = part.relaxingShare * part.k_N_per_m;
    values[P::RelaxationTime] = part.relaxationShare * recipe.seconds;
    return values;
}

} // namespace

std::optional<double> ModelExpectation::of(MotionParameter parameter) const
{
    const std::vector<P> own = terms.parameters();
    const auto at = static_cast<std::size_t>(std::ranges::find(own, parameter) - own.begin());
    return at < relative.size() ? std::optional(relative[at]) : std::nullopt;
}

std::vector<ModelExpectation> expectationOf(const Recipe& recipe, const GripperIdentity& identity,
                                            const ExpectedPart& part)
{
    if (forceProblem(recipe, identity))
        return {};
    const ExcitationOptions excitation = excitationOptions(recipe, identity, 1);
    if (excitation.samples > longestExpected)
        return {};
    const auto force = makeExcitation(excitation);
    if (!force)
        return {};
    const PlannedSqueeze squeeze{*force, recipe.bias_N, identity.sampleTime_s, identity.hold, part.noise_m};
    const MotionValues values = valuesOf(part, recipe);
    std::vector<ModelExpectation> all;
    for (const MotionTerms& terms :
         std::array{MotionTerms{}, MotionTerms{.friction = true}, MotionTerms{.relaxation = true}}) {
        ModelExpectation one{terms, {}};
        const std::vector<P> parameters = terms.parameters();
        if (const auto deviations = expectedDeviations(terms, values, squeeze))
            for (std::size_t i = 0; i < parameters.size(); ++i)
                one.relative.push_back(normal95 * (*deviations)[i] / values[parameters[i]]);
        all.push_back(std::move(one));
    }
    return all;
}

} // namespace gripscope
