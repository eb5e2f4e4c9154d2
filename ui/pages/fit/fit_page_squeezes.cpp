// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit/fit_page_squeezes.h"

#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/signal/excitation/excitation.h"
#include "ui/context/workbench.h"

using namespace Qt::StringLiterals;

namespace gripscope {

void openStoredSqueeze(Workbench& workbench, QObject* context, const QString& graspId, const QString& title,
                       const QString& backTo)
{
    Workbench* bench = &workbench;
    workbench.background().ask<Recording>(
        context, [graspId](Library& library) { return library.recording(graspId); },
        [bench, context, title, backTo](Expected<Recording> recording) {
            if (!recording) {
                bench->messages().report(recording.error().describe());
                return;
            }
            bench->background().compute<FitSubject>(
                context,
                [recording = std::move(*recording), title, backTo]() -> FitSubject {
                    Identification identification = identify(recording);
                    return {title, recording, std::move(identification), backTo};
                },
                [bench](FitSubject subject) { bench->navigator().showInFit(std::move(subject)); });
        });
}

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
