// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/transport/report_decoder.h"

namespace gripscope {

/// Reads the reports of a capture as they were read when it was taken: by the profile that it keeps, whatever
/// became of that profile since, else as Gripscope's own protocol.
class CaptureDecoder : public ReportDecoder {
public:
    explicit CaptureDecoder(QString file) : m_file(std::move(file)) {}

    /// FileUnreadable, BadInput, and what the decoder of its kind says.
    Expected<DeviceDescription> describe(Transport& transport, const QString& address) override;
    Taken take(protocol::ReportView bytes, std::vector<Sample>& samples) override
    {
        return m_inner->take(bytes, samples);
    }
    [[nodiscard]] Counts counts() const override { return m_inner ? m_inner->counts() : Counts(); }
    [[nodiscard]] bool understandsCommands() const override { return false; }

private:
    QString m_file;
    std::unique_ptr<ReportDecoder> m_inner; ///< from describe() on
};

} // namespace gripscope
