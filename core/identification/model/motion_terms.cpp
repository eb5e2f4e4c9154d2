// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/motion_terms.h"

namespace gripscope {

QString toString(MotionParameter parameter)
{
    static constexpr std::array<const char*, motionParameters> names{
        "m", "b", "k", "Fc", "k1", "tau", "k3", "b_back", "Fc_back", "force_offset"};
    return QString::fromLatin1(names[static_cast<std::size_t>(parameter)]);
}

bool isPositive(MotionParameter parameter)
{
    using P = MotionParameter;
    return parameter == P::Mass || parameter == P::Damping || parameter == P::Stiffness ||
           parameter == P::Relaxing || parameter == P::RelaxationTime || parameter == P::DampingBack;
}

bool isFriction(MotionParameter parameter)
{
    return parameter == MotionParameter::Friction || parameter == MotionParameter::FrictionBack;
}

std::optional<std::size_t> linearPlaceOf(MotionParameter parameter)
{
    const auto place = static_cast<std::size_t>(parameter); // they come first
    return place <= static_cast<std::size_t>(MotionParameter::Stiffness) ? std::optional(place)
                                                                         : std::nullopt;
}

std::vector<MotionParameter> MotionTerms::parameters() const
{
    using P = MotionParameter;
    std::vector<P> all;
    const auto add = [&](bool on, std::initializer_list<P> some) {
        if (on)
            all.insert(all.end(), some);
    };
    add(mass, {P::Mass});
    add(damping, {P::Damping});
    add(spring, {P::Stiffness});
    add(friction, {P::Friction});
    add(relaxation, {P::Relaxing, P::RelaxationTime});
    add(cubic, {P::Cubic});
    add(eachWay, {P::DampingBack});
    add(eachWay && friction, {P::FrictionBack});
    add(forceOffset, {P::ForceOffset});
    return all;
}

} // namespace gripscope
