// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/job_desk.h"
#include "core/session/line/line_status.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <random>

using namespace gripscope;
using namespace std::chrono_literals;

namespace {

/// A desk whose station is ready and whose PLC lives, and a clock that only the test moves.
struct ReadyDesk {
    ReadyDesk()
    {
        desk.setStation({LineState::Ready, true, false, 3});
        desk.beat(1, now);
    }
    JobAnswer ask(std::uint16_t trigger, std::uint32_t token, std::uint16_t type = 0)
    {
        return desk.startSingleJob({trigger, type, token}, now);
    }
    /// The job that waits, done at once; its token, 0 where there is none.
    std::uint32_t inspect()
    {
        const std::optional<LineJob> job = desk.takeJob();
        if (!job)
            return 0;
        LineResult result;
        result.state = ResultState::Completed;
        result.evaluation = ResultEvaluation::Ok;
        desk.finish(result, now);
        return job->partToken;
    }
    JobDesk::View view() const { return desk.view(now); }

    JobDesk::TimePoint now{1h};
    JobDesk desk{77};
};

} // namespace

class JobDeskTest : public QObject {
    Q_OBJECT
private slots:
    void aResultEchoesItsJobAndWaitsForItsRelease()
    {
        ReadyDesk line;
        QVERIFY(line.ask(1, 4711, 2) == JobAnswer::Taken);
        QVERIFY(line.view().busy);
        QVERIFY(line.view().state == LineState::SingleExecution);
        QCOMPARE(line.inspect(), 4711U);
        QCOMPARE(line.inspect(), 0U); // told once
        const JobDesk::View view = line.view();
        QVERIFY(view.unread && !view.busy);
        QVERIFY(view.result->job == (LineJob{1, 2, 4711}));
        QCOMPARE(view.result->sequence, 1U);
        QVERIFY(!line.desk.releaseResult(2)); // no such result
        QVERIFY(line.desk.releaseResult(1));
        QVERIFY(!line.desk.releaseResult(1)); // the same write again
        QVERIFY(line.view().wouldTake);
        QVERIFY(line.desk.resultById(1).has_value());
        QVERIFY(!line.desk.resultById(2).has_value());
    }
    void aTriggerWithAnUnreadResultIsAnOverrun()
    {
        ReadyDesk line;
        QVERIFY(line.ask(1, 10) == JobAnswer::Taken);
        QVERIFY(line.ask(2, 11) == JobAnswer::Busy);
        QCOMPARE(line.inspect(), 10U);
        QVERIFY(line.ask(3, 12) == JobAnswer::ResultUnread);
        QVERIFY(line.ask(3, 12) == JobAnswer::ResultUnread); // a PLC that writes in a cycle counts once
        QCOMPARE(line.view().overruns, 2U);
        QCOMPARE(line.desk.takeRefusals().size(), std::size_t(2));
        QCOMPARE(line.view().result->job.partToken, 10U); // untouched
        QVERIFY(line.desk.releaseResult(1));
        QVERIFY(line.ask(3, 12) == JobAnswer::ResultUnread); // answered for good
        QVERIFY(line.ask(4, 12) == JobAnswer::Taken);
    }
    void lostDoubledAndLateWritesChangeNothing()
    {
        ReadyDesk line;
        QVERIFY(line.ask(1, 10) == JobAnswer::Taken);
        QVERIFY(line.ask(1, 10) == JobAnswer::Taken);     // doubled
        QVERIFY(line.ask(1, 99) == JobAnswer::OutOfStep); // the same number for another part
        QVERIFY(line.ask(5, 99) == JobAnswer::OutOfStep);
        QVERIFY(line.ask(0, 99) == JobAnswer::None);
        QCOMPARE(line.inspect(), 10U);
        QVERIFY(line.desk.releaseResult(1));
        QVERIFY(line.ask(2, 20) == JobAnswer::Taken);
        QVERIFY(line.ask(1, 10) == JobAnswer::OutOfStep); // late
        QCOMPARE(line.inspect(), 20U);
        QCOMPARE(line.inspect(), 0U);
        QCOMPARE(line.view().outOfStep, 3U);
        QCOMPARE(line.view().lastTrigger, std::uint16_t(2));
    }
    void triggersBeginAnewBehindTheLargest()
    {
        ReadyDesk line;
        for (int i = 1; i <= 65536; ++i) {
            const auto trigger = static_cast<std::uint16_t>(i == 65536 ? 1 : i);
            QVERIFY(line.ask(trigger, std::uint32_t(i)) == JobAnswer::Taken);
            QCOMPARE(line.inspect(), std::uint32_t(i));
            QVERIFY(line.desk.releaseResult(std::uint32_t(i)));
        }
        QVERIFY(!line.desk.resultById(65536 - JobDesk::mostKept).has_value()); // bounded
        QVERIFY(line.desk.resultById(65536).has_value());
    }
    void whatIsNotReadyRefuses_data()
    {
        QTest::addColumn<int>("state");
        QTest::addColumn<int>("answer");
        const auto row = [](const char* name, LineState state, JobAnswer answer) {
            QTest::newRow(name) << int(state) << int(answer);
        };
        row("no gripper", LineState::Preoperational, JobAnswer::NotReady);
        row("not armed", LineState::Initialized, JobAnswer::NotArmed);
        row("squeezed by hand", LineState::SingleExecution, JobAnswer::Busy);
        row("stopped", LineState::Halted, JobAnswer::NotReady);
        row("error", LineState::Error, JobAnswer::NotReady);
    }
    void whatIsNotReadyRefuses()
    {
        QFETCH(int, state);
        QFETCH(int, answer);
        ReadyDesk line;
        line.desk.setStation({static_cast<LineState>(state), false, false, 3});
        QVERIFY(!line.view().wouldTake);
        QCOMPARE(int(line.ask(1, 5)), answer);
        QCOMPARE(line.inspect(), 0U);
        const std::vector<JobDesk::Refusal> refusals = line.desk.takeRefusals();
        QCOMPARE(refusals.size(), std::size_t(1));
        QVERIFY(!refusalInWords(refusals[0].answer, 1, 5).describe().contains(QStringLiteral("%")));
    }
    void aTypeIsOneOfTheList()
    {
        ReadyDesk line;
        QVERIFY(line.ask(1, 5, 4) == JobAnswer::NoSuchType);
        QVERIFY(line.ask(2, 5, 3) == JobAnswer::Taken);
    }
    void aPlcWhoseHeartbeatStandsStillIsLost()
    {
        ReadyDesk line;
        line.now += 1900ms;
        QVERIFY(!line.desk.takeLostHeartbeat(line.now));
        line.desk.beat(1, line.now); // the same number is no beat
        line.now += 200ms;
        QVERIFY(line.desk.takeLostHeartbeat(line.now));
        QVERIFY(!line.desk.takeLostHeartbeat(line.now)); // once
        QVERIFY(line.ask(1, 5) == JobAnswer::HeartbeatMissing);
        line.desk.beat(2, line.now);
        QVERIFY(line.ask(2, 5) == JobAnswer::Taken);
    }
    void howItStandsIsToldInWords()
    {
        ReadyDesk line;
        LineLink link;
        const auto words = [&] { return lineWords(link, line.view(), line.now); };
        QCOMPARE(words().headline.describe(), QStringLiteral("PLC: off"));
        link.on = true;
        link.clientsChanged = QDateTime(QDate(2026, 3, 1), QTime(10, 42));
        QCOMPARE(described(words().problems), QStringList{QStringLiteral("No PLC connected since 10:42.")});
        link.clients = 1;
        QCOMPARE(words().headline.describe(), QStringLiteral("PLC: in step"));
        QVERIFY(line.ask(1, 9) == JobAnswer::Taken);
        QCOMPARE(line.inspect(), 9U);
        line.now += 6s;
        line.desk.beat(2, line.now);
        QCOMPARE(described(words().problems),
                 QStringList{QStringLiteral("PLC has not acknowledged result 1.")});
        QVERIFY(line.ask(2, 10) == JobAnswer::ResultUnread);
        QVERIFY(words().problems.back().describe().contains(QStringLiteral("Trigger 2 for part 10")));
    }
    /// Whatever a PLC does, a part is inspected once, under its own token.
    void noWayOfWritingMixesParts()
    {
        std::mt19937 random(5);
        const auto one = [&random](unsigned in) { return random() % in == 0; };
        ReadyDesk line;
        std::vector<LineJob> sent;
        std::uint32_t waiting = 0, overruns = 0, taken = 0; // waiting: the part whose result is unread
        for (std::uint32_t token = 1; token <= 20000; ++token) {
            sent.push_back({static_cast<std::uint16_t>(token), 0, token});
            const bool skips = line.view().unread;
            QVERIFY(line.desk.startSingleJob(sent.back(), line.now) ==
                    (skips ? JobAnswer::ResultUnread : JobAnswer::Taken));
            if (one(4)) // doubled
                line.desk.startSingleJob(sent.back(), line.now);
            if (one(4) && token > 10) // late
                line.desk.startSingleJob(sent[token - 2 - random() % 9], line.now);
            QCOMPARE(line.inspect(), skips ? 0U : token);
            overruns += skips ? 1 : 0;
            taken += skips ? 0 : 1;
            waiting = skips ? waiting : token;
            QCOMPARE(line.view().result->job.partToken, waiting);
            QCOMPARE(line.view().result->sequence, taken);
            if (!one(5)) // else it forgets to acknowledge
                QVERIFY(line.desk.releaseResult(taken));
            if (one(5))
                QVERIFY(!line.desk.releaseResult(taken - 1));
        }
        QCOMPARE(line.view().overruns, overruns);
        QVERIFY(overruns > 1000 && taken > 10000);
    }
};

GRIPSCOPE_TEST(JobDeskTest)
#include "job_desk_test.moc"
