// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/address/virtual_object.h"

#include "core/base/random_stream.h"

#include <algorithm>

namespace gripscope {

namespace {

/// Purposes of streams: of the effects of a study. The squeeze of a part by an operator counts its trials and
/// repeats, of which there are at most a thousand each.
constexpr std::uint64_t partPurpose = 11, operatorPurpose = 12, repeatPurpose = 13;

std::uint64_t squeezeOfStudy(const VirtualStudyPart& study)
{
    constexpr std::uint64_t places = VirtualStudyPart::mostOfStudy + 1;
    return (std::uint64_t(study.part) * places + std::uint64_t(study.operatorNumber)) * places +
           std::uint64_t(study.trial);
}

} // namespace

std::uint64_t VirtualStudyPart::noiseSeed() const
{
    return RandomStream(seed, squeezeOfStudy(*this), repeatPurpose + 1).bits();
}

MassDampingStiffness VirtualObject::drawOfStudy(std::uint64_t squeeze) const
{
    RandomStream part(m_study->seed, std::uint64_t(m_study->part), partPurpose);
    RandomStream person(m_study->seed, std::uint64_t(m_study->operatorNumber), operatorPurpose);
    RandomStream repeat(m_study->seed, (squeezeOfStudy(*m_study) << 20) + squeeze, repeatPurpose);
    MassDampingStiffness drawn = m_centre;
    for (double* const quantity : {&drawn.m, &drawn.b, &drawn.k}) {
        const double share = m_study->partSpread * part.normal() + m_study->operatorSpread * person.normal() +
                             m_study->repeatSpread * repeat.normal();
        *quantity *= std::max(0.01, 1 + share); // what no draw reaches in a lifetime, and no part is
    }
    return drawn;
}

MassDampingStiffness VirtualObject::draw(std::uint64_t seed, std::uint64_t squeeze) const
{
    if (m_study)
        return drawOfStudy(squeeze);
    RandomStream random(seed, squeeze, 1);
    Eigen::Vector3d normal;
    for (Eigen::Index i = 0; i < 3; ++i)
        normal[i] = random.normal();
    const Eigen::Vector3d factor = (m_scatter * normal).array().exp().matrix();
    return {m_centre.m * factor[0], m_centre.b * factor[1], m_centre.k * factor[2]};
}

} // namespace gripscope
