// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/gripscope_decoder.h"

namespace gripscope {

using namespace protocol;

Expected<DeviceDescription> GripscopeDecoder::describe(Transport& transport, const QString& address)
{
    Expected<DeviceDescription> device = describeDevice(transport, address);
    if (device)
        m_assembler.emplace(device->measurement.forcePerCount, device->measurement.positionPerCount,
                            device->measurement.sampleTime_s);
    return device;
}

ReportDecoder::Taken GripscopeDecoder::take(ReportView bytes, std::vector<Sample>& samples)
{
    const Decoded<InputMessage> message = decodeInput(bytes);
    if (!message)
        return message.error();
    if (const auto* answer = std::get_if<Acknowledgement>(&*message))
        return *answer;
    const auto& report = std::get<StreamReport>(*message);
    switch (m_assembler->take(report, samples)) {
    case StreamAssembler::Outcome::Duplicate:
        return Duplicate{};
    case StreamAssembler::Outcome::Restarted:
        return Restarted{};
    case StreamAssembler::Outcome::Accepted:
        break;
    }
    return Stream{{report.status, report.timestamp_us, report.excitation, report.excitationNumber}};
}

ReportDecoder::Counts GripscopeDecoder::counts() const
{
    return {m_assembler->lostSamples(), m_assembler->sequenceGaps(), m_assembler->clockSteps(),
            m_assembler->duplicateReports()};
}

} // namespace gripscope
