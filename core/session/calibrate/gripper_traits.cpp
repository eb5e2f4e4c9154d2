// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/calibrate/gripper_traits.h"

namespace gripscope {

namespace {

bool isSame(GripperTrait trait, const NewMeasuringChain& a, const NewMeasuringChain& b)
{
    switch (trait) {
    case GripperTrait::Baseline:
        return a.chain.baseline == b.chain.baseline;
    case GripperTrait::Friction:
        return a.chain.friction == b.chain.friction;
    case GripperTrait::ForceNoise:
        return a.chain.forceNoiseDeviation == b.chain.forceNoiseDeviation;
    case GripperTrait::Frame:
        return a.chain.frameCompliance == b.chain.frameCompliance &&
               a.chain.frameComplianceUncertainty == b.chain.frameComplianceUncertainty;
    case GripperTrait::Lag:
        return a.forceLag_s == b.forceLag_s && a.chain.forceLagUncertainty_s == b.chain.forceLagUncertainty_s;
    }
    return false;
}

} // namespace

bool isKnown(GripperTrait trait, const NewMeasuringChain& chain)
{
    return !isSame(trait, chain, NewMeasuringChain());
}

std::optional<MeasuringChainRecord> measurementOf(GripperTrait trait,
                                                  std::span<const MeasuringChainRecord> newestFirst)
{
    if (newestFirst.empty() || !isKnown(trait, newestFirst.front()))
        return std::nullopt;
    std::size_t first = 0;
    while (first + 1 < newestFirst.size() && isSame(trait, newestFirst[first + 1], newestFirst.front()))
        ++first;
    return newestFirst[first];
}

} // namespace gripscope
