// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/scaled_record.h"

#include <algorithm>

namespace gripscope {

Nuisance nuisanceInChannelUnits(const ScaledRecord& record, double x0, double v0, double offset)
{
    Nuisance nuisance;
    if (record.freeInitialState) {
        nuisance.x0 = x0 * record.positionScale;
        nuisance.v0 = v0 * record.positionScale / record.sampleTime_s;
    }
    if (record.freeOffset)
        nuisance.offset = offset * record.positionScale + record.positionShift;
    return nuisance;
}

double squaredSize(const ScaledRecord& record)
{
    double sum = 0;
    for (const double y : record.position)
        sum += y * y;
    return sum;
}

double positionEnergy(const ScaledRecord& record)
{
    double mean = 0;
    double squares = 0;
    for (const double y : record.position) {
        mean += y;
        squares += y * y;
    }
    const auto count = static_cast<double>(record.position.size());
    return squares - (record.freeOffset ? mean * mean / count : 0);
}

ScaledRecord firstSamples(const ScaledRecord& record, std::size_t most)
{
    ScaledRecord part = record;
    if (part.force.size() > most) {
        part.force.resize(most);
        part.position.resize(most);
    }
    return part;
}

bool isConstant(const std::vector<double>& values)
{
    return std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); });
}

} // namespace gripscope
