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
    Expected<CaptureReader> reader = CaptureReader::open(file);
    if (!reader)
        return tl::unexpected<Error>(reader.error());
    for (;;) {
        const Expected<std::optional<CaptureRecord>> record = reader->next();
        if (!record)
            return tl::unexpected<Error>(record.error());
        if (!*record || (*record)->kind == CaptureKind::Input)
            return std::nullopt;
        if ((*record)->kind != CaptureKind::Note)
            continue;
        if (std::optional<ProfiledDevice> device = profiledDeviceOf((*record)->note()))
            return device;
    }
}

} // namespace

Expected<DeviceDescription> CaptureDecoder::describe(Transport& transport, const QString& address)
{
    const Expected<std::optional<ProfiledDevice>> kept = keptProfile(m_file);
    if (!kept)
        return tl::unexpected<Error>(kept.error());
    if (*kept)
        m_inner = std::make_unique<ProfileDecoder>([device = **kept] { return device; });
    else
        m_inner = std::make_unique<GripscopeDecoder>();
    return m_inner->describe(transport, address);
}

} // namespace gripscope
