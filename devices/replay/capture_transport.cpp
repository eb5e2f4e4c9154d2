// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture_transport.h"

#include "core/base/words.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
/// For what waits for the disk when a session ends, within the second that closing a port may take; a disk
/// that takes longer goes on by itself.
constexpr std::chrono::milliseconds closingTakes{450};
/// Feature reports that stand in front of the first sample; a device has three, and every part repeats them.
constexpr std::size_t mostReplayedFeatures = 1000;
} // namespace

Expected<void> CapturingTransport::open()
{
    ASSIGN_OR_RETURN(std::unique_ptr<CaptureWriter> writer, CaptureWriter::create(m_destination, m_monitor));
    {
        const std::lock_guard lock(m_mutex);
        m_writer = std::move(writer);
    }
    return m_inner->open();
}

void CapturingTransport::close() noexcept
{
    m_inner->close();
    const auto deadline = std::chrono::steady_clock::now() + closingTakes;
    while (m_reading && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard lock(m_mutex);
    if (m_writer)
        m_writer->finishBy(deadline);
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
    m_reading = true;
    const ReadResult result = m_inner->read(buffer, timeout);
    if (result.outcome == Outcome::Report)
        m_writer->add(CaptureKind::Input,
                      protocol::ReportView(buffer).first(std::min(result.size, buffer.size())));
    m_reading = false;
    return result;
}

bool CapturingTransport::write(const protocol::Report& report)
{
    m_writer->add(CaptureKind::Output, report);
    return m_inner->write(report);
}

void CapturingTransport::note(const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    const std::lock_guard lock(m_mutex);
    if (m_writer)
        m_writer->add(CaptureKind::Note, {reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                                          static_cast<std::size_t>(bytes.size())});
}

QString CapturingTransport::keptSession() const
{
    const std::lock_guard lock(m_mutex);
    return m_writer ? m_writer->session() : QString();
}

Expected<void> CaptureReplayTransport::open()
{
    ASSIGN_OR_RETURN(CaptureReader reader, CaptureReader::open(m_file));
    m_reader = std::move(reader);
    RETURN_IF_ERROR(findNextInput());
    if (!m_nextInput)
        return failure(ErrorCode::BadInput,
                       {m_file, Words::tr("no report of a gripper"), Words::tr("expected at least one")});
    m_firstInput_us = m_nextInput->time_us;
    return {};
}

Expected<void> CaptureReplayTransport::findNextInput()
{
    m_nextInput.reset();
    for (;;) {
        ASSIGN_OR_RETURN(std::optional<CaptureRecord> record, m_reader->next());
        if (!record)
            return {};
        if (record->kind == CaptureKind::Input) {
            m_nextInput = std::move(record);
            return {};
        }
        if (record->kind == CaptureKind::Feature && !m_started && m_features.size() < mostReplayedFeatures)
            m_features.push_back(std::move(*record));
    }
}

Expected<protocol::Report> CaptureReplayTransport::feature(protocol::ReportId id)
{
    for (const CaptureRecord& record : m_features) {
        protocol::Report report{};
        if (record.bytes.size() != report.size() || record.bytes[0] != static_cast<std::uint8_t>(id))
            continue;
        std::copy(record.bytes.begin(), record.bytes.end(), report.begin());
        return report;
    }
    return failure(ErrorCode::BadInput,
                   {m_file,
                    Words::tr("no feature report 0x%1").arg(static_cast<int>(id), 2, 16, QLatin1Char('0')),
                    Words::tr("expected one, since it says what the numbers mean")});
}

CaptureReplayTransport::Clock::time_point CaptureReplayTransport::due() const
{
    if (m_speed == 0)
        return *m_started;
    const double after_us = static_cast<double>(m_nextInput->time_us - m_firstInput_us) / m_speed;
    return *m_started +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::micro>(after_us));
}

Transport::ReadResult CaptureReplayTransport::read(Buffer& buffer, std::chrono::milliseconds timeout)
{
    const Clock::time_point now = Clock::now();
    if (!m_started)
        m_started = now;
    if (!m_nextInput)
        return {Outcome::Ended};
    {
        std::unique_lock lock(m_mutex);
        m_wake.wait_until(lock, std::min(due(), now + timeout), [&] { return m_closed; });
        if (m_closed)
            return {Outcome::Lost};
    }
    if (Clock::now() < due())
        return {Outcome::Timeout};
    const CaptureRecord record = std::move(*m_nextInput);
    std::copy_n(record.bytes.begin(), std::min(record.bytes.size(), buffer.size()), buffer.begin());
    // What cannot be read any more ends the replay; `captures verify` says why.
    static_cast<void>(findNextInput());
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
