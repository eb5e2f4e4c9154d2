// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/report_descriptor.h"

#include "devices/protocol/report.h"

namespace gripscope::protocol {

namespace {

// Items of the Device Class Definition for HID 1.11, section 6.2.2, that are needed here.
constexpr std::uint8_t input = 0x81;
constexpr std::uint8_t output = 0x91;
constexpr std::uint8_t feature = 0xB1;
constexpr std::uint8_t dataVariableAbsolute = 0x02;

} // namespace

std::vector<std::uint8_t> reportDescriptor()
{
    std::vector<std::uint8_t> bytes{
        0x06, 0x00, 0xFF,                      // Usage Page (vendor-defined 0xFF00)
        0x09, 0x01,                            // Usage (1)
        0xA1, 0x01,                            // Collection (Application)
        0x15, 0x00, 0x26, 0xFF,          0x00, // Logical Minimum (0), Maximum (255)
        0x75, 0x08, 0x95, reportSize - 1       // Report Size (8 bits), Count (all but the ID)
    };
    const auto add = [&](ReportId id, std::uint8_t kind) {
        for (const std::uint8_t byte : {std::uint8_t(0x85), static_cast<std::uint8_t>(id), std::uint8_t(0x09),
                                        std::uint8_t(0x01), kind, dataVariableAbsolute})
            bytes.push_back(byte); // Report ID, Usage (1), kind
    };
    for (const ReportId id : {ReportId::Stream, ReportId::Acknowledgement})
        add(id, input);
    for (const ReportId id : {ReportId::Arm, ReportId::Disarm, ReportId::Stop, ReportId::Heartbeat,
                              ReportId::SetLimits, ReportId::Upload, ReportId::Start, ReportId::Finish})
        add(id, output);
    for (const ReportId id : {ReportId::Identity, ReportId::Measurement, ReportId::Limits})
        add(id, feature);
    bytes.push_back(0xC0); // End Collection
    return bytes;
}

} // namespace gripscope::protocol
