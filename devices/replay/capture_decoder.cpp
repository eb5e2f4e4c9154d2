// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture_decoder.h"

#include "devices/acquisition/gripscope_decoder.h"
#include "devices/profile/profile_note.h"
#include "devices/replay/capture_reader.h"

namespace gripscope {

namespace {

/// The profile stands before the first report.
Expected<std::optional<ProfiledDevice>> keptProfile(const QString& file)
{
    ASSIGN_OR_RETURN(CaptureReader reader, CaptureReader::open(file));
    for (;;) {
        ASSIGN_OR_RETURN(const std::optional<CaptureRecord> record, reader.next());
        if (!record || record->kind == CaptureKind::Input)
            return std::nullopt;
        if (record->kind != CaptureKind::Note)
            continue;
        if (std::optional<ProfiledDevice> device = profiledDeviceOf(record->note()))
            return device;
    }
}

} // namespace

Expected<DeviceDescription> CaptureDecoder::describe(Transport& transport, const QString& address)
{
    ASSIGN_OR_RETURN(const std::optional<ProfiledDevice> kept, keptProfile(m_file));
    if (kept)
        m_inner = std::make_unique<ProfileDecoder>([device = *kept] { return device; });
    else
        m_inner = std::make_unique<GripscopeDecoder>();
    return m_inner->describe(transport, address);
}

} // namespace gripscope
