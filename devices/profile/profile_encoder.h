// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"

#include <span>

namespace gripscope {

/// The reports that a gripper with this profile sends: what ProfileDecoder undoes.
class ProfileEncoder {
public:
    struct Reading {
        double force_N = 0, position_m = 0;
        std::uint16_t status = 0; ///< SampleStatus bits; those of the whole report are what any sample has
    };

    explicit ProfileEncoder(const GripperProfile& profile);

    /// The next report, of `profile.samples` readings; its first was taken at `time_s`.
    [[nodiscard]] std::vector<std::uint8_t> encode(std::span<const Reading> readings, double time_s);

private:
    /// True: the number did not fit, or the channel says that it is at the end of its range.
    bool put(const ProfileChannel& channel, double value_SI, double siPerUnit, std::span<std::uint8_t> report,
             std::size_t shift) const;
    void putStatus(std::uint16_t status, std::span<std::uint8_t> report) const;

    GripperProfile m_profile;
    double m_newtons, m_metres; ///< in a unit of the channels
    std::uint64_t m_reports = 0;
};

} // namespace gripscope
