// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/command_queue.h"
#include "devices/acquisition/link_words.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::protocol;
using namespace std::chrono_literals;

namespace {

const CommandQueue::Clock::time_point start{1h};

Command sent(CommandQueue& queue, CommandQueue::Clock::time_point now)
{
    const std::optional<Report> report = queue.next(now);
    return report ? decodeCommand(*report).value() : Command{};
}
Acknowledgement answerTo(const Command& command, CommandResult result = CommandResult::Done)
{
    Acknowledgement answer;
    answer.commandNumber = command.number;
    answer.command = reportId(command.body);
    answer.result = result;
    return answer;
}

} // namespace

class CommandQueueTest : public QObject {
    Q_OBJECT
private slots:
    void oneAfterAnotherEachWhenTheOneBeforeWasAnswered()
    {
        CommandQueue queue;
        queue.push(ArmCommand{});
        queue.push(SetLimitsCommand{1, 2});
        const Command arm = sent(queue, start);
        QVERIFY(std::holds_alternative<ArmCommand>(arm.body));
        QVERIFY(!queue.next(start));
        QVERIFY(queue.acknowledge(answerTo(arm)).has_value());
        QVERIFY(std::holds_alternative<SetLimitsCommand>(sent(queue, start).body));
    }

    void uploadsRunAheadUpToTheWindowAndTheStartWaitsForAll()
    {
        CommandQueue queue;
        UploadCommand chunk;
        chunk.count = 1;
        for (int i = 0; i < 10; ++i)
            queue.push(chunk);
        queue.push(StartCommand{});
        std::vector<Command> out;
        while (const auto report = queue.next(start))
            out.push_back(*decodeCommand(*report));
        QCOMPARE(out.size(), CommandQueue::uploadWindow);
        // Answered out of order, the window moves on; the start comes last of all.
        std::reverse(out.begin(), out.end());
        for (std::size_t i = 0; i < out.size(); ++i) {
            QVERIFY(queue.acknowledge(answerTo(out[i])).has_value());
            while (const auto report = queue.next(start))
                out.push_back(*decodeCommand(*report));
        }
        QCOMPARE(out.size(), std::size_t(11));
        QVERIFY(std::holds_alternative<StartCommand>(out.back().body));
    }

    void withoutAnAnswerTheSameBytesGoOutAgainAndThenItIsTold()
    {
        constexpr int attempts = 13;
        CommandQueue queue(0, true, attempts);
        queue.push(SetLimitsCommand{1, 2});
        const std::optional<Report> first = queue.next(start);
        auto now = start;
        for (int i = 1; i < attempts; ++i) {
            QVERIFY(!queue.next(now + CommandQueue::patience - 1ms));
            QVERIFY(!queue.expired(now + CommandQueue::patience - 1ms));
            now += CommandQueue::patience;
            QVERIFY(queue.wakeAt() == now);
            QVERIFY(queue.next(now) == first);
        }
        QVERIFY(!queue.next(now + CommandQueue::patience)); // enough
        const auto outcome = queue.expired(now + CommandQueue::patience);
        QVERIFY(outcome.has_value());
        QVERIFY(!outcome->result);
        QVERIFY(outcome->waited == attempts * CommandQueue::patience);
        QCOMPARE(refusal(*outcome).argument(1), u"1.3"_qs);
        QVERIFY(queue.empty());
    }

    void armIsRepeatedSoonerThanItsWatchdogTripsAndNotAtAllWhereThatCouldArmAnew()
    {
        CommandQueue queue;
        queue.push(ArmCommand{7});
        const std::optional<Report> first = queue.next(start);
        QVERIFY(!queue.next(start + CommandQueue::armPatience - 1ms));
        QVERIFY(queue.next(start + CommandQueue::armPatience) == first);

        CommandQueue toAnOldDevice(100, false);
        toAnOldDevice.push(ArmCommand{7});
        QVERIFY(toAnOldDevice.next(start).has_value());
        QVERIFY(!toAnOldDevice.next(start + CommandQueue::armPatience));
        const auto outcome = toAnOldDevice.expired(start + CommandQueue::armPatience);
        QVERIFY(outcome && !outcome->result);
    }

    void aHaltThrowsAwayWhatWaitsAndItsAnswerIsKnown()
    {
        CommandQueue queue;
        queue.push(SetLimitsCommand{1, 2});
        queue.push(StartCommand{});
        static_cast<void>(queue.next(start));
        const Command stop = decodeCommand(queue.halt(StopCommand{})).value();
        QVERIFY(std::holds_alternative<StopCommand>(stop.body));
        QVERIFY(queue.empty() && !queue.next(start + CommandQueue::patience));
        const auto outcome = queue.acknowledge(answerTo(stop));
        QVERIFY(outcome && std::holds_alternative<StopCommand>(outcome->body));
        QVERIFY(!queue.acknowledge(answerTo(stop)));
    }

    void whatThisProgramDidNotSendIsSomebodyElses()
    {
        CommandQueue queue(65534, true); // numbers go round
        const auto answer = [](std::uint16_t number, ReportId command) {
            Acknowledgement out;
            out.commandNumber = number;
            out.command = command;
            return out;
        };
        QVERIFY(!queue.sentHere(answer(65534, ReportId::Heartbeat)));
        static_cast<void>(queue.heartbeat());
        static_cast<void>(queue.halt(StopCommand{}));
        QVERIFY(queue.sentHere(answer(65535, ReportId::Heartbeat)));
        QVERIFY(queue.sentHere(answer(0, ReportId::Stop)));
        QVERIFY(!queue.sentHere(answer(0, ReportId::Heartbeat)));
        QVERIFY(!queue.sentHere(answer(1, ReportId::Stop)));
        for (int i = 0; i < 2000; ++i)
            static_cast<void>(queue.heartbeat());
        QVERIFY(!queue.sentHere(answer(0, ReportId::Stop))); // nobody answers that late
        QVERIFY(queue.sentHere(answer(2000, ReportId::Heartbeat)));
    }

    void answersNobodyWaitsForAreIgnored()
    {
        CommandQueue queue;
        queue.push(ArmCommand{});
        Acknowledgement answer;
        answer.commandNumber = 1; // the first there is
        answer.command = ReportId::Arm;
        QVERIFY(!queue.acknowledge(answer)); // not sent yet
        const Command arm = sent(queue, start);
        answer = answerTo(arm);
        answer.command = ReportId::Stop;
        QVERIFY(!queue.acknowledge(answer));
        answer = answerTo(arm);
        answer.commandNumber++;
        QVERIFY(!queue.acknowledge(answer));
        QVERIFY(queue.acknowledge(answerTo(arm, CommandResult::Busy))->result == CommandResult::Busy);
        QVERIFY(!queue.acknowledge(answerTo(arm)));
    }
};

GRIPSCOPE_TEST(CommandQueueTest)
#include "command_queue_test.moc"
