// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/captured_session.h"

#include "core/base/words.h"
#include "core/calibration/calibration_facts.h"
#include "core/session/connection/identity_limits.h"
#include "core/session/squeeze/squeeze_notes.h"
#include "core/signal/recording/stream_account.h"
#include "devices/acquisition/sample_queue.h"
#include "devices/replay/capture_decoder.h"
#include "devices/replay/capture_transport.h"

#include <deque>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A shift has 400; a capture that says more only keeps the program busy.
constexpr std::size_t mostSqueezes = 10'000;

/// Takes the records of a session in their order.
class SessionCutter {
public:
    SessionCutter(CapturedSession& session, ReportDecoder& decoder) : m_session(session), m_decoder(decoder)
    {
    }

    /// BadInput where there are more squeezes than any session has.
    Expected<void> take(const CaptureRecord& record)
    {
        if (m_session.squeezes.size() > mostSqueezes)
            return failure(ErrorCode::BadInput, {Words::tr("found more than %1 squeezes").arg(mostSqueezes),
                                                 Words::tr("expected fewer in one session")});
        follow(record);
        return {};
    }
    void follow(const CaptureRecord& record)
    {
        m_now_s = 1e-6 * static_cast<double>(record.time_us);
        switch (record.kind) {
        case CaptureKind::Input:
            return takeInput(record);
        case CaptureKind::Output:
            return takeOutput(record);
        case CaptureKind::Note:
            return takeNote(record.note());
        case CaptureKind::Feature:
            return;
        }
    }
    void finish()
    {
        if (m_open && m_recorder.complete())
            closeByItself();
        else if (m_open)
            fail(Words::tr("the capture ends within the squeeze"));
        const ReportDecoder::Counts counts = m_decoder.counts();
        m_session.counters.lostSamples = counts.lostSamples;
        m_session.counters.duplicateReports = counts.duplicateReports;
        m_session.seconds = m_now_s;
    }

private:
    void takeInput(const CaptureRecord& record);
    void takeOutput(const CaptureRecord& record);
    void takeNote(const QString& note);
    void open(const SqueezeBegins& begins);
    void end(const SqueezeEnded& ended);
    void closeByItself();
    void fail(const QString& reason);

    CapturedSession& m_session;
    ReportDecoder& m_decoder;
    std::vector<Sample> m_batch;
    std::deque<Sample> m_recent; ///< what may have waited for the program when it began a squeeze
    SqueezeRecorder m_recorder;
    bool m_open = false;  ///< a squeeze is being cut out
    bool m_noted = false; ///< the capture has notes of squeezes, so that commands need not be looked at
    std::optional<std::uint16_t> m_excitation; ///< the last one that was uploaded
    bool m_endedJustNow =
        false; ///< the last squeeze, by its note: one that says how it was judged is its own
    double m_now_s = 0, m_begins_s = 0;
};

void SessionCutter::takeInput(const CaptureRecord& record)
{
    m_batch.clear();
    ++m_session.counters.reports;
    if (std::holds_alternative<protocol::DecodeError>(m_decoder.take(record.bytes, m_batch)))
        ++m_session.counters.badReports;
    m_session.counters.samples += m_batch.size();
    m_recent.insert(m_recent.end(), m_batch.begin(), m_batch.end());
    while (m_recent.size() > SampleQueue::defaultCapacity)
        m_recent.pop_front();
    if (m_open)
        m_recorder.take(m_batch);
}

void SessionCutter::takeOutput(const CaptureRecord& record)
{
    const auto command = protocol::decodeCommand(record.bytes);
    const auto* upload = command ? std::get_if<protocol::UploadCommand>(&command->body) : nullptr;
    if (m_noted || !upload || upload->excitationNumber == m_excitation)
        return;
    m_excitation = upload->excitationNumber;
    // From here on: what came before this upload was before the squeeze.
    open({SqueezeRecorder::Mode::Movement, 0,
          m_recent.empty() ? std::nullopt : std::optional(m_recent.back().sequence)});
}

void SessionCutter::takeNote(const QString& note)
{
    if (const std::optional<SqueezeBegins> begins = squeezeBegins(note)) {
        if (!m_noted)
            m_open = false; // its first commands may stand before its note
        m_noted = true;
        return open(*begins);
    }
    if (const std::optional<SqueezeEnded> ended = squeezeEnded(note))
        return end(*ended);
    const bool judged = note.startsWith(
        QLatin1String(squeezeJudgedNote.data(), static_cast<qsizetype>(squeezeJudgedNote.size())));
    if (judged) {
        if (std::exchange(m_endedJustNow, false))
            m_session.squeezes.back().judged = note;
        return;
    }
    const auto fact = [&](const QString& key) {
        return note.section(u'\n' + key + u": "_s, 1, 1).section(u'\n', 0, 0);
    };
    if (note.startsWith(u"session\n"_s)) {
        m_session.name = fact(u"name"_s);
        m_session.address = fact(u"address"_s);
    } else if (note.startsWith(u"dropped\n"_s)) {
        m_session.droppedRecords += fact(u"records"_s).toULongLong();
    }
}

void SessionCutter::open(const SqueezeBegins& begins)
{
    if (m_open && m_recorder.complete())
        closeByItself();
    else if (m_open)
        fail(Words::tr("another squeeze began within it"));
    m_open = true;
    m_endedJustNow = false;
    m_begins_s = m_now_s;
    m_recorder.begin(begins.mode, begins.samples, m_session.identity.sampleTime_s);
    std::vector<Sample> waiting;
    for (const Sample& sample : m_recent)
        if (!begins.after || sample.sequence > *begins.after)
            waiting.push_back(sample);
    m_recorder.take(waiting);
}

void SessionCutter::end(const SqueezeEnded& ended)
{
    m_endedJustNow = std::exchange(m_open, false);
    if (!m_endedJustNow)
        return; // its beginning is in a part that is not there
    CapturedSqueeze squeeze{ended.head, ended.failure, true, 0, m_begins_s, {}};
    if (!ended.failure) {
        m_recorder.moveTo(squeeze.recording);
        squeeze.recording = slice(squeeze.recording, {0, std::min(squeeze.recording.size(), ended.samples)});
        squeeze.missingSamples = ended.samples - squeeze.recording.size();
        correctAsNoted(squeeze.recording);
    }
    m_session.squeezes.push_back(std::move(squeeze));
}

void SessionCutter::closeByItself()
{
    m_open = false;
    const GripperIdentity& identity = m_session.identity;
    CapturedSqueeze squeeze;
    squeeze.begins_s = m_begins_s;
    Recording& recording = squeeze.recording;
    recording.sampleTime_s = identity.sampleTime_s;
    recording.forceUnit = identity.forceUnit;
    recording.positionUnit = identity.positionUnit;
    recording.hold = identity.hold;
    recording.forceLag_s = identity.forceLag_s;
    recording.provenance = {
        {u"device"_s, identity.name}, {u"serial"_s, identity.serial}, {u"firmware"_s, identity.firmware}};
    m_recorder.moveTo(recording);
    recording.provenance.remove(streamAccountKey()); // of that a reading sees only a part
    m_session.squeezes.push_back(std::move(squeeze));
}

void SessionCutter::fail(const QString& reason)
{
    m_open = false;
    CapturedSqueeze squeeze;
    squeeze.failure = reason;
    squeeze.noted = m_noted;
    squeeze.begins_s = m_begins_s;
    m_session.squeezes.push_back(std::move(squeeze));
}

} // namespace

Expected<CapturedSession> readCapturedSession(const QString& file)
{
    CaptureReplayTransport transport(file, 0);
    RETURN_IF_ERROR(transport.open());
    CaptureDecoder decoder(file);
    ASSIGN_OR_RETURN(DeviceDescription device, decoder.describe(transport, u"replay:"_s + file));
    if (const std::optional<Finding> reason = outOfRange(device.identity))
        return failure(ErrorCode::BadInput, {file, *reason, Words::tr("expected a gripper that can be")});
    ASSIGN_OR_RETURN(CaptureReader reader, CaptureReader::open(file));
    CapturedSession session;
    session.identity = device.identity;
    SessionCutter cutter(session, decoder);
    for (;;) {
        ASSIGN_OR_RETURN(const std::optional<CaptureRecord> record, reader.next());
        if (!record)
            break;
        if (const Expected<void> taken = cutter.take(*record); !taken) {
            Error inFile = taken.error();
            inFile.arguments.insert(inFile.arguments.begin(), file);
            return tl::unexpected<Error>(inFile);
        }
    }
    cutter.finish();
    return session;
}

} // namespace gripscope
