// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/stream_assembler.h"
#include "devices/transport/report_decoder.h"

namespace gripscope {

/// The Gripscope protocol (devices/PROTOCOL.md).
class GripscopeDecoder : public ReportDecoder {
public:
    Expected<DeviceDescription> describe(Transport& transport, const QString& address) override;
    Taken take(protocol::ReportView bytes, std::vector<Sample>& samples) override;
    [[nodiscard]] Counts counts() const override;
    [[nodiscard]] bool understandsCommands() const override { return true; }

    [[nodiscard]] static std::unique_ptr<ReportDecoder> make()
    {
        return std::make_unique<GripscopeDecoder>();
    }

private:
    std::optional<protocol::StreamAssembler> m_assembler; ///< from describe() on
};

} // namespace gripscope
