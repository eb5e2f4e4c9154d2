// SPDX-License-Identifier: GPL-3.0-or-later
// A session with a bad cable, replayed: the same samples, the same squeezes, the same estimates, the same
// verdicts, bit for bit.
#include "core/session/enroll/enroll_session.h"
#include "core/session/inspect/inspect_session.h"
#include "core/session/inspect/squeeze_judged.h"
#include "core/session/squeeze/squeeze_notes.h"
#include "core/signal/recording/recording_csv.h"
#include "devices/replay/capture_reader.h"
#include "devices/replay/captured_session.h"
#include "tests/devices/connected_program.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cstring>
#include <memory>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

constexpr int enrolled = 5;
constexpr int inspected = 3;

/// The bits, so that -0 is not 0 and a NaN is itself.
bool sameBits(double a, double b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}
bool sameBits(const std::vector<double>& a, const std::vector<double>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}
bool sameBits(const Recording& a, const Recording& b)
{
    return a == b && sameBits(a.time_s, b.time_s) && sameBits(a.force, b.force) &&
           sameBits(a.position, b.position);
}

bool sameEstimate(const Estimate& a, const Estimate& b)
{
    if (a.estimator != b.estimator || a.status != b.status || !a.parameters || !b.parameters ||
        !a.covariance || !b.covariance)
        return false;
    return sameBits(a.parameters->m, b.parameters->m) && sameBits(a.parameters->b, b.parameters->b) &&
           sameBits(a.parameters->k, b.parameters->k) &&
           std::memcmp(a.covariance->data(), b.covariance->data(), 9 * sizeof(double)) == 0 &&
           sameBits(a.residual, b.residual);
}
bool sameIdentification(const Identification& a, const Identification& b)
{
    return a.recommended == b.recommended && a.best() && b.best() && sameEstimate(*a.best(), *b.best()) &&
           a.validity.verdict == b.validity.verdict && sameBits(a.position, b.position);
}
bool sameVerdict(const Verdict& a, const Verdict& b)
{
    return a.kind == b.kind && a.type == b.type && a.nearest == b.nearest && a.posterior == b.posterior &&
           a.distance == b.distance && a.gate == b.gate && a.samplesUsed == b.samplesUsed &&
           a.reasons == b.reasons && a.strangerPosterior == b.strangerPosterior;
}

/// Not those that a program begins with.
VerdictOptions ownRates()
{
    VerdictOptions rates;
    rates.falseReject = 0.02;
    rates.wrongType = 0.0123456789012345;
    rates.strangerAccept = 0.003;
    return rates;
}

/// Fewer than any squeeze of the session loses.
JudgingPolicy lossIsRefused()
{
    return {false, 1e-4, false};
}

/// What a session with the virtual gripper left behind.
struct LiveSession {
    std::vector<Sample> samples;
    std::vector<Recording> recordings; ///< in their order
    std::vector<Identification> identifications;
    std::vector<Verdict> verdicts; ///< of the inspections
    LinkCounters counters;
};

/// Five squeezes enrolled and three inspected, on a gripper with faults.
class SessionRun {
public:
    SessionRun(const QString& address, const QString& libraryFile)
        : m_library(libraryFile), m_connection(m_factory), m_enroll(m_connection, m_library),
          m_inspect(m_connection, m_library)
    {
        m_recipe.seconds = 0.5;
        m_connection.addListener([this](const std::vector<Sample>& batch) {
            live.samples.insert(live.samples.end(), batch.begin(), batch.end());
        });
        worked = connect(address) && enrol() && inspect();
        live.counters = m_connection.counters();
        m_connection.disconnect();
    }

    LiveSession live;
    bool worked = false;

private:
    bool until(const std::function<bool()>& done)
    {
        return waitFor([&] {
            m_connection.poll();
            m_enroll.poll();
            m_inspect.poll();
            return done();
        });
    }
    bool connect(const QString& address)
    {
        return m_connection.connectTo(address) &&
               until([&] { return m_connection.state() == ConnectSession::State::Connected; }) &&
               m_connection.arm(u"tester"_qs) && until([&] { return m_connection.armed(); });
    }
    bool enrol()
    {
        if (!m_enroll.setName(u"A"_qs) || !m_enroll.setRecipe(m_recipe) ||
            !until([&] { return m_enroll.step() == EnrollSession::Step::Squeeze; }))
            return false;
        for (int i = 0; i < enrolled; ++i) {
            if (!m_enroll.squeeze() ||
                !until([&] { return m_enroll.activity() == EnrollSession::Activity::Deciding; }))
                return false;
            live.recordings.push_back(m_enroll.squeezes().back().recording);
            live.identifications.push_back(m_enroll.squeezes().back().identification);
            if (!m_enroll.accept() || !until([&] { return m_enroll.acceptedCount() == i + 1; }))
                return false;
        }
        return m_enroll.review() && m_enroll.approve() &&
               until([&] { return m_enroll.step() == EnrollSession::Step::Approved; });
    }
    bool inspect()
    {
        m_inspect.setRecipe(m_recipe);
        m_inspect.setRates(ownRates());
        m_inspect.setEarlyEnd(false); // a decision in time depends on how quick the computer is
        m_inspect.reload();
        const auto ready = [&] { return m_inspect.state() == InspectSession::State::Ready; };
        for (int i = 0; i < inspected; ++i) {
            if (i + 1 == inspected) // the last one is refused for the samples that it lost
                m_inspect.setPolicy(lossIsRefused());
            if (!until(ready) || !m_inspect.squeeze() || !until(ready) || !m_inspect.result())
                return false;
            live.recordings.push_back(m_inspect.result()->recording);
            live.identifications.push_back(m_inspect.result()->identification);
            live.verdicts.push_back(m_inspect.result()->verdict);
            if (!until([&] { return !m_inspect.storing(); }))
                return false;
        }
        return true;
    }

    DeviceFactory m_factory;
    LibraryService m_library;
    ConnectSession m_connection;
    EnrollSession m_enroll;
    InspectSession m_inspect;
    Recipe m_recipe;
};

/// Judges recordings one after another as the inspections were.
std::vector<InspectSession::Result> judgeAgain(const QString& libraryFile,
                                               const std::vector<Recording>& recordings,
                                               const VerdictOptions& rates,
                                               const std::vector<JudgingPolicy>& policies = {})
{
    DeviceFactory factory;
    LibraryService library(libraryFile);
    ConnectSession unconnected(factory);
    InspectSession session(unconnected, library);
    session.setStoring(false);
    session.setRates(rates);
    const auto ready = [&] {
        session.poll();
        return session.state() == InspectSession::State::Ready;
    };
    std::vector<InspectSession::Result> results;
    for (std::size_t i = 0; i < recordings.size(); ++i) {
        session.setPolicy(i < policies.size() ? policies[i] : JudgingPolicy());
        if (waitFor(ready) && session.judgeRecording(recordings[i], u"replay"_qs) && waitFor(ready))
            results.push_back(*session.result());
    }
    return results;
}

/// A force channel that reads too high, and a position channel with a bend.
CalibrationsInForce twoPercentLess()
{
    CalibrationsInForce calibrations;
    calibrations.force.emplace();
    calibrations.force->unit = u"N"_qs;
    calibrations.position.emplace();
    calibrations.position->unit = u"m"_qs;
    calibrations.position->channel = SensorChannel::Position;
    calibrations.position->degree = 2;
    for (auto* record : {&calibrations.force, &calibrations.position}) {
        (*record)->reference.name = u"Weights and gauge blocks"_qs;
        (*record)->takenUtc = QDateTime::currentDateTimeUtc();
        (*record)->due = QDate::currentDate().addDays(100);
    }
    for (int i = 0; i <= 10; ++i) {
        calibrations.force->points.push_back({10.0 * i, 10.2 * i + 0.01});
        const double x = 0.0025 * i;
        calibrations.position->points.push_back({x, x + 0.1 * x * x});
    }
    return calibrations;
}

/// The capture as a program of before would have written it: without notes, version 1.
void writeWithoutNotes(const QString& from, const QString& to)
{
    QFile out(to);
    QVERIFY(out.open(QIODevice::WriteOnly));
    QByteArray header = captureHeader();
    header[6] = 1;
    out.write(header);
    const std::vector<CaptureRecord> records = readCapture(from).value();
    for (const CaptureRecord& record : records)
        if (record.kind != CaptureKind::Note)
            out.write(encodeRecord(record.time_us, record.kind, record.bytes));
}

/// A session with one squeeze that a bad cable thins out, kept in as many parts as it can be.
struct KeptSession {
    QTemporaryDir place;
    ConnectedProgram program;

    bool squeeze()
    {
        KeepSessions keep{place.path(), {}, true};
        keep.limits.partBytes = 1; // a part for each visit of the disk
        program.factory.keepSessions(keep);
        if (!program.connectTo(u"virtual:?speed=1&fault=loss:0.02"_qs))
            return false;
        program.connection.setCalibrations(twoPercentLess()); // the reports stay those of the device
        constexpr double long_s = 1;
        const bool done =
            program.arm() && program.squeeze(long_s) && program.job.state() == SqueezeJob::State::Done;
        program.connection.disconnect();
        return done;
    }
};

/// In real time: where a busy computer keeps the gripper waiting for so long that its watchdog ends the
/// squeeze, another session's turn.
std::unique_ptr<KeptSession> keptSession()
{
    constexpr int mostTries = 20;
    for (int tries = 0; tries < mostTries; ++tries) {
        auto kept = std::make_unique<KeptSession>();
        if (kept->squeeze())
            return kept;
        if (const auto& error = kept->program.job.error())
            qInfo("once more: %s", qPrintable(error->describe()));
    }
    return nullptr;
}

} // namespace

class SessionReplayTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase()
    {
        m_capture = m_folder.filePath(u"session.gscap"_qs);
        m_library = m_folder.filePath(u"library.db"_qs);
        SessionRun run(u"virtual:?speed=0&seed=5&fault=loss:0.01,duplicate:0.01,crc:0.005&capture="_qs +
                           m_capture,
                       m_library);
        QVERIFY(run.worked);
        m_live = std::move(run.live);
        QVERIFY(m_live.counters.lostSamples > 0);
        QVERIFY(m_live.counters.badReports > 0);
        QVERIFY(m_live.counters.duplicateReports > 0);
        // A busy computer may bring the rest to the disk a little after the port was closed.
        QVERIFY(waitFor([&] {
            const Expected<CapturedSession> session = readCapturedSession(m_capture);
            return session && session->counters.reports >= m_live.counters.reports &&
                   !session->squeezes.empty() && !session->squeezes.back().judged.isEmpty();
        }));
    }

    void theSqueezesAreCutOutAsTheyWere()
    {
        const Expected<CapturedSession> session = readCapturedSession(m_capture);
        QVERIFY2(session.has_value(), qPrintable(whyNot(session)));
        QCOMPARE(session->squeezes.size(), std::size_t(enrolled + inspected));
        for (std::size_t i = 0; i < session->squeezes.size(); ++i) {
            const CapturedSqueeze& squeeze = session->squeezes[i];
            QVERIFY(squeeze.noted && !squeeze.failure);
            QCOMPARE(squeeze.missingSamples, std::size_t(0));
            QVERIFY(sameBits(squeeze.recording, m_live.recordings[i]));
            QCOMPARE(toCsv(squeeze.recording), toCsv(m_live.recordings[i]));
        }
        // What came between the look at the counters and the end of the link is in the capture alone.
        const std::uint64_t later = session->counters.reports - m_live.counters.reports;
        const auto goOn = [later](std::uint64_t kept, std::uint64_t seen) {
            return kept >= seen && kept - seen <= later;
        };
        QVERIFY(goOn(session->counters.badReports, m_live.counters.badReports));
        QVERIFY(goOn(session->counters.duplicateReports, m_live.counters.duplicateReports));
        QVERIFY(session->counters.lostSamples >= m_live.counters.lostSamples);
        if (later == 0)
            QCOMPARE(session->counters.lostSamples, m_live.counters.lostSamples);
        QCOMPARE(session->droppedRecords, std::uint64_t(0));
    }

    void theEstimatesAndVerdictsAreTheSameToTheBit()
    {
        const CapturedSession session = readCapturedSession(m_capture).value();
        std::vector<Recording> recordings;
        for (const CapturedSqueeze& squeeze : session.squeezes)
            recordings.push_back(squeeze.recording);
        // The capture tells which were inspections, at which rates they were judged, and what was refused.
        std::vector<JudgingPolicy> policies;
        for (std::size_t i = 0; i < session.squeezes.size(); ++i) {
            const auto judged = squeezeJudged(session.squeezes[i].judged);
            QCOMPARE(judged.has_value(), i >= std::size_t(enrolled));
            QVERIFY(!judged || (judged->rates == ownRates() && !judged->earlyEnd));
            if (judged)
                policies.push_back(judged->policy);
        }
        QVERIFY(policies.front() == JudgingPolicy() && policies.back() == lossIsRefused());
        const VerdictOptions rates = squeezeJudged(session.squeezes.back().judged)->rates;
        // As the sessions saw them: the enrolled ones together, then the inspected ones.
        const auto inspections = recordings.begin() + enrolled;
        const auto first = judgeAgain(m_library, {recordings.begin(), inspections}, rates);
        const auto second = judgeAgain(m_library, {inspections, recordings.end()}, rates, policies);
        QCOMPARE(first.size(), std::size_t(enrolled));
        QCOMPARE(second.size(), std::size_t(inspected));
        for (std::size_t i = 0; i < first.size(); ++i)
            QVERIFY(sameIdentification(first[i].identification, m_live.identifications[i]));
        for (std::size_t i = 0; i < second.size(); ++i) {
            QVERIFY(sameIdentification(second[i].identification, m_live.identifications[enrolled + i]));
            QVERIFY(sameVerdict(second[i].verdict, m_live.verdicts[i]));
            const bool refused = i + 1 == second.size();
            QCOMPARE(second[i].refused, refused);
            QVERIFY(refused || !second[i].verdict.posterior.isEmpty()); // there is something to be the same
        }
        // At other rates they are not.
        const auto other = judgeAgain(m_library, {inspections, recordings.end()}, {});
        QVERIFY(!sameVerdict(other.front().verdict, m_live.verdicts.front()));
    }

    void atAnySpeedTheSamplesAreTheSame_data()
    {
        QTest::addColumn<QString>("speed");
        QTest::newRow("as fast as it is read") << u"0"_qs;
        QTest::newRow("a hundred times faster") << u"100"_qs;
        QTest::newRow("ten times faster") << u"10"_qs;
    }
    void atAnySpeedTheSamplesAreTheSame()
    {
        QFETCH(QString, speed);
        OpenPort replay(u"replay:%1?speed=%2"_qs.arg(m_capture, speed));
        QVERIFY(replay.pollUntil([&] { return replay.port->state() == LinkState::Closed; }));
        replay.port->drain(replay.samples);
        QCOMPARE(replay.port->counters().droppedSamples, std::uint64_t(0));
        QCOMPARE(replay.samples.size(), m_live.samples.size());
        for (std::size_t i = 0; i < replay.samples.size(); ++i) {
            const Sample& now = replay.samples[i];
            const Sample& then = m_live.samples[i];
            QVERIFY(now.sequence == then.sequence && now.status == then.status);
            QVERIFY(sameBits(now.time_s, then.time_s) && sameBits(now.force, then.force) &&
                    sameBits(now.position, then.position));
        }
    }

    void withoutNotesTheCommandsTellWhereTheSqueezesAre()
    {
        const QString old = m_folder.filePath(u"old.gscap"_qs);
        writeWithoutNotes(m_capture, old);
        const CapturedSession session = readCapturedSession(old).value();
        QCOMPARE(session.squeezes.size(), std::size_t(enrolled + inspected));
        for (std::size_t i = 0; i < session.squeezes.size(); ++i) {
            const CapturedSqueeze& squeeze = session.squeezes[i];
            QVERIFY(!squeeze.noted && !squeeze.failure);
            QVERIFY(sameBits(squeeze.recording.force, m_live.recordings[i].force));
            QVERIFY(sameBits(squeeze.recording.position, m_live.recordings[i].position));
            QVERIFY(squeeze.recording.sequence == m_live.recordings[i].sequence);
        }
    }

    void howALostSqueezeWasJudgedIsSaidOfNoOther()
    {
        const QString part = m_folder.filePath(u"part.gscap"_qs);
        const std::vector<CaptureRecord> records = readCapture(m_capture).value();
        const auto last = std::find_if(records.rbegin(), records.rend(), [](const CaptureRecord& record) {
            return record.kind == CaptureKind::Note && squeezeBegins(record.note());
        });
        QVERIFY(last != records.rend());
        QByteArray bytes = captureHeader();
        for (const CaptureRecord& record : records) {
            QByteArray own = encodeRecord(record.time_us, record.kind, record.bytes);
            if (&record == &*last)
                continue; // its beginning was in a part that is not there
            if (record.kind == CaptureKind::Note && squeezeJudged(record.note()) && &record > &*last) {
                std::vector<std::uint8_t> note(record.bytes.begin(), record.bytes.end());
                for (const char letter : "of the lost one"_L1)
                    note.push_back(static_cast<std::uint8_t>(letter));
                own = encodeRecord(record.time_us, record.kind, note);
            }
            bytes += own;
        }
        QFile out(part);
        QVERIFY(out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size());
        out.close();
        const CapturedSession session = readCapturedSession(part).value();
        QCOMPARE(session.squeezes.size(), std::size_t(enrolled + inspected - 1));
        QVERIFY(squeezeJudged(session.squeezes.back().judged));
        QVERIFY(!session.squeezes.back().judged.contains(u"of the lost one"_s));
    }
    void aKeptSessionInPartsReplaysAsOne()
    {
        const std::unique_ptr<KeptSession> kept = keptSession();
        QVERIFY(kept);
        const QTemporaryDir& place = kept->place;
        const Recording& recording = kept->program.job.recording();
        const QString session = recording.provenance.value(u"capture"_qs);
        QVERIFY(!session.isEmpty());
        const QString first = place.filePath(session + u".part0001.gscap"_qs);
        QVERIFY(waitFor([&] {
            const Expected<CapturedSession> replay = readCapturedSession(first);
            return replay && !replay->squeezes.empty() && replay->squeezes.back().noted;
        }));
        QVERIFY(capturePartsFrom(first).size() > 1); // how many, a busy computer says
        const CapturedSession replay = readCapturedSession(first).value();
        QCOMPARE(replay.name, session);
        QCOMPARE(replay.squeezes.size(), std::size_t(1));
        const Recording& again = replay.squeezes.front().recording;
        QCOMPARE(again.provenance, recording.provenance); // named first: a difference says where
        QCOMPARE(again.sequence.size(), recording.sequence.size());
        QVERIFY(sameBits(again, recording));
        QVERIFY(!replay.squeezes.front().recording.provenance.value(u"position_correction"_qs).isEmpty());
    }

private:
    QTemporaryDir m_folder;
    QString m_capture, m_library;
    LiveSession m_live;
};

GRIPSCOPE_TEST(SessionReplayTest)
#include "session_replay_test.moc"
