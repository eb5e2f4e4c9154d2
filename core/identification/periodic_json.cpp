// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic_json.h"

#include <QJsonArray>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonValue number(double value)
{
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue();
}

QJsonObject lineJson(const PeriodicLine& line)
{
    return {{u"frequency_hz"_s, number(line.frequency_Hz)},
            {u"real"_s, number(line.response.real())},
            {u"imaginary"_s, number(line.response.imag())},
            {u"deviation"_s, number(line.deviation)}};
}

} // namespace

QJsonObject toJson(const PeriodicDiagnostics& diagnostics)
{
    QJsonArray lines;
    for (const PeriodicLine& one : diagnostics.lines)
        lines.append(lineJson(one));
    QJsonValue distortion;
    if (diagnostics.distortionPercent && diagnostics.distortionP)
        distortion = QJsonObject{{u"percent"_s, number(*diagnostics.distortionPercent)},
                                 {u"p"_s, number(*diagnostics.distortionP)}};
    return {{u"period_samples"_s, static_cast<qint64>(diagnostics.periodSamples)},
            {u"periods"_s, static_cast<qint64>(diagnostics.periods)},
            {u"noise"_s, QJsonObject{{u"force"_s, number(diagnostics.forceNoise)},
                                     {u"position"_s, number(diagnostics.positionNoise)},
                                     {u"correlation"_s, number(diagnostics.noiseCorrelation)}}},
            {u"cost"_s,
             QJsonObject{{u"ratio"_s, number(diagnostics.costRatio)}, {u"p"_s, number(diagnostics.costP)}}},
            {u"distortion"_s, distortion},
            {u"lines"_s, lines}};
}

} // namespace gripscope
