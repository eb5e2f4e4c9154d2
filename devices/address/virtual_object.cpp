// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/address/virtual_object.h"

#include "core/base/random_stream.h"

namespace gripscope {

MassDampingStiffness VirtualObject::draw(std::uint64_t seed, std::uint64_t squeeze) const
{
    RandomStream random(seed, squeeze, 1);
    Eigen::Vector3d normal;
    for (Eigen::Index i = 0; i < 3; ++i)
        normal[i] = random.normal();
    const Eigen::Vector3d factor = (m_scatter * normal).array().exp().matrix();
    return {m_centre.m * factor[0], m_centre.b * factor[1], m_centre.k * factor[2]};
}

} // namespace gripscope
