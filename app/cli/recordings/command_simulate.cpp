// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/bounded_number.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/output.h"
#include "app/cli/options/force_file.h"
#include "app/cli/options/recording_output.h"
#include "app/cli/options/shared_options.h"
#include "core/base/csv.h"
#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/signal/excitation/excitation.h"
#include "core/signal/recording/recording_limits.h"

#include <QLocale>

#include <cmath>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

struct SimulateRequest {
    MassDampingStiffness object;
    ExcitationOptions excitation;
    ForceHold hold = ForceHold::Zero;
    double noise = 0;
    QString file;
};

MassDampingStiffness readObject(CommandLine& line)
{
    const QStringList parts = line.list(u"object"_qs);
    std::vector<double> values;
    for (const QString& part : parts) {
        bool ok = false;
        const double value = QLocale::c().toDouble(part, &ok);
        if (ok && std::isfinite(value) && (value > 0 || (value == 0 && !values.empty())))
            values.push_back(value);
    }
    if (parts.size() != 3 || values.size() != 3) {
        line.reject(
            u"--object is \"%1\"; m,b,k was expected, with m above zero and b and k not below it."_qs.arg(
                line.text(u"object"_qs)));
        return {};
    }
    return {values[0], values[1], values[2]};
}

SimulateRequest readSimulateRequest(CommandLine& line)
{
    using Range = CommandLine::Range;
    SimulateRequest request;
    request.object = readObject(line);
    ExcitationOptions& excitation = request.excitation;
    excitation.kind = excitationKind(line);
    excitation.periods = excitationPeriods(line);
    excitation.peak = line.number(u"peak"_qs);
    excitation.bias = line.number(u"bias"_qs);
    excitation.bit_s = line.number(u"bit"_qs, Range::Positive);
    excitation.samples =
        static_cast<std::size_t>(line.integer(u"samples"_qs, 1, static_cast<int>(mostSamples)));
    excitation.sampleTime_s =
        boundedNumber(line, u"sample-time"_qs, shortestSampleTime_s, longestSampleTime_s);
    excitation.seed = line.seed();
    excitation.oneSided = false;
    request.hold = line.choice(u"hold"_qs, {u"zoh"_qs, u"foh"_qs}) == 0 ? ForceHold::Zero : ForceHold::First;
    request.noise = line.number(u"noise-sd"_qs, Range::NotNegative);
    request.file = line.text(u"output"_qs);
    if (request.file.isEmpty())
        line.reject(u"-o FILE is missing."_qs);
    return request;
}

Recording simulated(const SimulateRequest& request, std::vector<double> force)
{
    Recording recording;
    recording.sampleTime_s = request.excitation.sampleTime_s;
    recording.hold = request.hold;
    SimulationOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = request.hold;
    recording.position = simulate(request.object, force, options);
    // A stream of its own, so that the noise does not follow the excitation's choice of phases.
    GaussianNoise noise(request.excitation.seed + 0x9e3779b97f4a7c15u);
    for (std::size_t i = 0; i < force.size(); ++i) {
        recording.time_s.push_back(static_cast<double>(i) * recording.sampleTime_s);
        recording.position[i] += request.noise * noise();
    }
    recording.force = std::move(force);
    recording.provenance = {
        {u"source"_qs, u"simulated"_qs},
        {forceLagSourceKey(), u"stated"_qs}, // there is none
        {u"object_m"_qs, exactText(request.object.m)},
        {u"object_b"_qs, exactText(request.object.b)},
        {u"object_k"_qs, exactText(request.object.k)},
        {u"excitation"_qs, toString(request.excitation.kind)},
        {u"excitation_peak"_qs, exactText(request.excitation.peak)},
        {u"excitation_bias"_qs, exactText(request.excitation.bias)},
        {u"excitation_bit_s"_qs, exactText(request.excitation.bit_s)},
        {u"noise_sd"_qs, exactText(request.noise)},
        {u"seed"_qs, QString::number(request.excitation.seed)},
    };
    if (const std::optional<std::size_t> period = excitationPeriod(request.excitation))
        recording.provenance.insert(u"excitation_period_samples"_qs, QString::number(*period));
    return recording;
}

void addSimulateOptions(CommandLine& line)
{
    line.option(u"object"_qs, u"m,b,k"_qs, u"Mass, damping and stiffness."_qs);
    addExcitationKind(line);
    line.option(u"peak"_qs, u"FORCE"_qs, u"Largest force above and below the bias."_qs, u"1"_qs);
    line.option(u"bias"_qs, u"FORCE"_qs, u"Force in the middle."_qs, u"0"_qs);
    line.option(u"bit"_qs, u"SECONDS"_qs,
                u"Length of a bit of prbs and inverse-repeat; shortest half period of the others."_qs,
                u"0.5"_qs);
    line.option(u"samples"_qs, u"N"_qs, u"How many samples."_qs, u"400"_qs);
    line.option(u"sample-time"_qs, u"SECONDS"_qs, u"Time from sample to sample."_qs, u"0.05"_qs);
    line.option(u"noise-sd"_qs, u"SD"_qs, u"Standard deviation of the noise on the position."_qs, u"0.1"_qs);
    line.option(u"seed"_qs, u"N"_qs, u"Seed of excitation and noise."_qs, u"1"_qs);
    line.option(u"hold"_qs, u"HOLD"_qs, u"The force between samples: zoh (held) or foh (a straight line)."_qs,
                u"zoh"_qs);
    line.shortOption(u'o', u"output"_qs, u"FILE"_qs, u"The recording to write."_qs);
    addForceOption(line);
}

} // namespace

int runSimulate(const QStringList& arguments)
{
    CommandLine line(
        u"simulate"_qs,
        u"Writes the recording of an object with known m, b and k, at rest at first, in numbers without "
        "units."_qs);
    addSimulateOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    SimulateRequest request = readSimulateRequest(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    if (const Expected<void> may = mayReplace(request.file, line.isSet(u"force"_qs)); !may)
        return fail(may.error(), json);
    if (const auto taken = takeForceFile(line, request.excitation); !taken)
        return fail(taken.error(), json);
    Expected<std::vector<double>> force = makeExcitation(request.excitation);
    if (!force)
        return fail(force.error(), json);
    const Recording recording = simulated(request, std::move(*force));
    if (const Expected<void> written = writeRecordingCsv(recording, request.file); !written)
        return fail(written.error(), json);
    if (json)
        printJson({{u"file"_qs, request.file},
                   {u"samples"_qs, static_cast<qint64>(recording.size())},
                   {u"sample_time_s"_qs, recording.sampleTime_s},
                   {u"hold"_qs, toString(request.hold)}});
    else
        message(u"%1: %2 samples, %3 s apart."_qs.arg(request.file, QString::number(recording.size()),
                                                      QString::number(recording.sampleTime_s, 'g', 6)));
    return 0;
}

} // namespace gripscope::cli
