// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/profile_counter.h"
#include "devices/transport/report_decoder.h"

namespace gripscope {

/// A gripper by its profile, and which one of its kind it is.
struct ProfiledDevice {
    GripperProfile profile;
    QString serial;
};

/// Samples out of the reports of another maker's gripper, by its profile. Pure: the same bytes give the same
/// samples.
class ProfileDecoder : public ReportDecoder {
public:
    /// Finds the profile; called by describe(), so that it may read files.
    using Source = std::function<Expected<ProfiledDevice>()>;
    explicit ProfileDecoder(Source source) : m_source(std::move(source)) {}
    /// For reports alone, without a device.
    explicit ProfileDecoder(const GripperProfile& profile);

    Expected<DeviceDescription> describe(Transport& transport, const QString& address) override;
    /// A report with another ID is Other; a wrong length, a number that is not finite and a counter that
    /// makes no sense are errors.
    Taken take(protocol::ReportView bytes, std::vector<Sample>& samples) override;
    [[nodiscard]] Counts counts() const override;
    [[nodiscard]] bool understandsCommands() const override { return false; }

    /// Status bits of a report, but for those of the channels.
    [[nodiscard]] static std::uint16_t statusOf(const GripperProfile& profile, protocol::ReportView report);

private:
    void use(const GripperProfile& profile);
    [[nodiscard]] bool readSamples(protocol::ReportView bytes);

    Source m_source;
    GripperProfile m_profile;
    std::unique_ptr<ProfileCounter> m_counter; ///< from describe() on
    std::vector<Sample> m_read;                ///< those of one report; kept so that nothing is allocated
};

} // namespace gripscope
