// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture_transport.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

Expected<void> CapturingTransport::open()
{
    Expected<std::unique_ptr<CaptureWriter>> writer = CaptureWriter::create(m_file);
    if (!writer)
        return tl::unexpected<Error>(writer.error());
    {
        const std::lock_guard lock(m_mutex);
        m_writer = std::move(*writer);
    }
    return m_inner->open();
}

void CapturingTransport::close() noexcept
{
    m_inner->close();
    const std::lock_guard lock(m_mutex);
    if (m_writer)
        m_writer->finish();
}

Expected<protocol::Report> CapturingTransport::feature(protocol::ReportId id)
{
    return m_inner->feature(id).map([&](const protocol::Report& report) {
        m_writer->add(CaptureKind::Feature, report);
        return report;
    });
}

Transport::ReadResult CapturingTransport::read(Buffer& buffer, std::chrono::milliseconds timeout)
{
    const ReadResult result = m_inner->read(buffer, timeout);
    if (result.outcome == Outcome::Report)
        m_writer->add(CaptureKind::Input,
                      protocol::ReportView(buffer).first(std::min(result.size, buffer.size())));
    return result;
}

bool CapturingTransport::write(const protocol::Report& report)
{
    m_writer->add(CaptureKind::Output, report);
    return m_inner->write(report);
}

Expected<void> CaptureReplayTransport::open()
{
    Expected<std::vector<CaptureRecord>> records = readCapture(m_file);
    if (!records)
        return tl::unexpected<Error>(records.error());
    m_records = std::move(*records);
    const auto first = std::find_if(m_records.begin(), m_records.end(), [](const CaptureRecord& record) {
        return record.kind == CaptureKind::Input;
    });
    if (first == m_records.end())
        return failure(ErrorCode::BadInput,
                       {m_file, u"no report of a gripper"_qs, u"expected at least one"_qs});
    m_firstInput_us = first->time_us;
    return {};
}

Expected<protocol::Report> CaptureReplayTransport::feature(protocol::ReportId id)
{
    for (const CaptureRecord& record : m_records) {
        protocol::Report report{};
        if (record.kind != CaptureKind::Feature || record.bytes.size() != report.size() ||
            record.bytes[0] != static_cast<std::uint8_t>(id))
            continue;
        std::copy(record.bytes.begin(), record.bytes.end(), report.begin());
        return report;
    }
    return failure(ErrorCode::BadInput,
                   {m_file, u"no feature report 0x%1"_qs.arg(static_cast<int>(id), 2, 16, QLatin1Char('0')),
                    u"expected one, since it says what the numbers mean"_qs});
}

Transport::ReadResult CaptureReplayTransport::read(Buffer& buffer, std::chrono::milliseconds timeout)
{
    const Clock::time_point now = Clock::now();
    if (!m_started)
        m_started = now;
    while (m_next < m_records.size() && m_records[m_next].kind != CaptureKind::Input)
        ++m_next;
    if (m_next == m_records.size())
        return {Outcome::Ended};
    const CaptureRecord& record = m_records[m_next];
    const Clock::time_point due = *m_started + std::chrono::microseconds(record.time_us - m_firstInput_us);
    {
        std::unique_lock lock(m_mutex);
        m_wake.wait_until(lock, std::min(due, now + timeout), [&] { return m_closed; });
        if (m_closed)
            return {Outcome::Lost};
    }
    if (Clock::now() < due)
        return {Outcome::Timeout};
    ++m_next;
    std::copy_n(record.bytes.begin(), std::min(record.bytes.size(), buffer.size()), buffer.begin());
    return {Outcome::Report, record.bytes.size()};
}

void CaptureReplayTransport::close() noexcept
{
    {
        const std::lock_guard lock(m_mutex);
        m_closed = true;
    }
    m_wake.notify_all();
}

} // namespace gripscope
