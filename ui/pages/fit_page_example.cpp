// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_example.h"

#include "core/identification/discretization.h"
#include "core/signal/excitation.h"
#include "core/signal/gaussian.h"

namespace gripscope {

using namespace Qt::StringLiterals;

Recording simulatedSqueeze(const MassDampingStiffness& object, std::uint64_t seed)
{
    constexpr double positionNoise_m = 5e-6;
    ExcitationOptions excitation; // the defaults are those of a squeeze: PRBS, 20 +- 10 N, 2 kHz, 1 s
    excitation.seed = seed;
    const Expected<std::vector<double>> force = makeExcitation(excitation);
    if (!force)
        return {};
    Recording recording;
    recording.sampleTime_s = excitation.sampleTime_s;
    recording.forceUnit = u"N"_s;
    recording.positionUnit = u"m"_s;
    recording.hold = ForceHold::Zero;
    recording.force = *force;
    SimulationOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = ForceHold::Zero;
    options.x0 = excitation.bias / object.k; // it rests under the bias when the squeeze begins
    recording.position = simulate(object, recording.force, options);
    GaussianNoise noise(seed);
    recording.time_s.reserve(recording.force.size());
    for (std::size_t i = 0; i < recording.force.size(); ++i) {
        recording.time_s.push_back(double(i) * recording.sampleTime_s);
        recording.position[i] += positionNoise_m * noise();
    }
    recording.provenance.insert(u"source"_s, u"simulated"_s);
    return recording;
}

} // namespace gripscope
