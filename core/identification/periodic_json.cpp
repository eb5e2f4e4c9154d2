// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic_json.h"

#include "core/identification/json_number.h"

#include <QJsonArray>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonObject lineJson(const PeriodicLine& line)
{
    return {{u"frequency_hz"_s, jsonNumber(line.frequency_Hz)},
            {u"real"_s, jsonNumber(line.response.real())},
            {u"imaginary"_s, jsonNumber(line.response.imag())},
            {u"deviation"_s, jsonNumber(line.deviation)}};
}

} // namespace

QJsonObject toJson(const PeriodicDiagnostics& diagnostics)
{
    QJsonArray lines;
    for (const PeriodicLine& one : diagnostics.lines)
        lines.append(lineJson(one));
    QJsonValue distortion;
    if (diagnostics.distortionPercent && diagnostics.distortionP)
        distortion = QJsonObject{{u"percent"_s, jsonNumber(*diagnostics.distortionPercent)},
                                 {u"p"_s, jsonNumber(*diagnostics.distortionP)}};
    return {{u"period_samples"_s, static_cast<qint64>(diagnostics.periodSamples)},
            {u"periods"_s, static_cast<qint64>(diagnostics.periods)},
            {u"noise"_s, QJsonObject{{u"force"_s, jsonNumber(diagnostics.forceNoise)},
                                     {u"position"_s, jsonNumber(diagnostics.positionNoise)},
                                     {u"correlation"_s, jsonNumber(diagnostics.noiseCorrelation)}}},
            {u"drift"_s, QJsonObject{{u"force"_s, jsonNumber(diagnostics.forceDrift)},
                                     {u"position"_s, jsonNumber(diagnostics.positionDrift)}}},
            {u"cost"_s, QJsonObject{{u"ratio"_s, jsonNumber(diagnostics.costRatio)},
                                    {u"p"_s, jsonNumber(diagnostics.costP)}}},
            {u"distortion"_s, distortion},
            {u"lines"_s, lines}};
}

} // namespace gripscope
