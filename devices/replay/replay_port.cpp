// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/replay_port.h"

#include "core/base/words.h"
#include "core/signal/recording/recording_csv.h"

#include <QFileInfo>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

GripperIdentity identityOf(const Recording& recording, const QString& address, const QString& file)
{
    GripperIdentity identity;
    identity.address = address;
    identity.corrected = true;
    identity.serial = recording.provenance.value(u"serial"_qs);
    identity.name = Words::tr("Replay of %1").arg(QFileInfo(file).fileName());
    identity.firmware = recording.provenance.value(u"firmware"_qs);
    identity.forceUnit = recording.forceUnit;
    identity.positionUnit = recording.positionUnit;
    identity.sampleTime_s = recording.sampleTime_s;
    identity.hold = recording.hold.value_or(ForceHold::First); // as wherever a recording does not say
    identity.forceLag_s = recording.forceLag_s;
    return identity;
}

} // namespace

ReplayPort::ReplayPort(QString address, QString file, double speed)
    : m_address(std::move(address)), m_file(std::move(file)), m_speed(speed)
{
}

ReplayPort::~ReplayPort() = default;

void ReplayPort::open()
{
    close();
    m_error.reset();
    m_recording = {};
    m_next = m_nextGap = 0;
    m_counters = {};
    m_state = LinkState::Opening;
    m_reading = std::make_shared<Reading>();
    m_reader = BoundedThread([reading = m_reading, file = m_file] {
        Expected<Recording> recording = readRecordingCsv(file);
        const std::lock_guard lock(reading->mutex);
        reading->result = std::move(recording);
    });
}

void ReplayPort::close()
{
    constexpr std::chrono::milliseconds longest{500}; // for a file that is still being read
    m_reader.finishBy(Clock::now() + longest);
    m_state = LinkState::Closed;
}

void ReplayPort::takeOver() const
{
    if (m_state != LinkState::Opening)
        return;
    const std::lock_guard lock(m_reading->mutex);
    if (!m_reading->result)
        return;
    Expected<Recording>& recording = *m_reading->result;
    if (!recording || recording->size() == 0) {
        m_error = recording ? Error{ErrorCode::BadInput,
                                    {m_file, Words::tr("no samples"), Words::tr("expected at least one")}}
                            : recording.error();
        m_state = LinkState::Lost;
        return;
    }
    m_recording = std::move(*recording);
    m_gaps = findGaps(m_recording);
    m_identity = identityOf(m_recording, m_address, m_file);
    m_started = Clock::now();
    m_state = LinkState::Ready;
}

LinkState ReplayPort::state() const
{
    takeOver();
    return m_state;
}

std::optional<Error> ReplayPort::lastError() const
{
    takeOver();
    return m_error;
}

GripperIdentity ReplayPort::identity() const
{
    takeOver();
    return m_identity;
}

LinkCounters ReplayPort::counters() const
{
    return m_counters;
}

std::size_t ReplayPort::drain(std::vector<Sample>& samples, std::size_t most)
{
    takeOver();
    if (m_state != LinkState::Ready)
        return 0;
    const double played_s = std::chrono::duration<double>(Clock::now() - m_started).count();
    std::size_t count = 0;
    for (; count < most && m_next < m_recording.size(); ++count, ++m_next) {
        if (m_speed > 0 && m_recording.time_s[m_next] - m_recording.time_s.front() > played_s * m_speed)
            break;
        if (m_nextGap < m_gaps.size() && m_gaps[m_nextGap].before == m_next) {
            m_counters.lostSamples += static_cast<std::uint64_t>(m_gaps[m_nextGap++].lostSamples);
            ++m_counters.sequenceGaps;
            m_counters.lastLoss = Clock::now();
        }
        // Without numbers of its own a recording gets some that jump where its time does.
        samples.push_back(
            {m_recording.sequence.empty() ? m_next + m_counters.lostSamples : m_recording.sequence[m_next],
             m_recording.time_s[m_next], m_recording.force[m_next], m_recording.position[m_next],
             m_recording.status.empty() ? std::uint16_t(0) : m_recording.status[m_next]});
    }
    m_counters.samples += count;
    if (m_next == m_recording.size()) {
        m_state = LinkState::Closed;
        m_error = Error{ErrorCode::NotFound,
                        {Words::tr("further sample at %1: it was replayed to its end").arg(m_address)}};
    }
    return count;
}

} // namespace gripscope
