// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/codec.h"
#include "devices/transport/crash_stop.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace gripscope;
using namespace gripscope::protocol;

// A program that crashes, as a child process; what it wrote to its gripper, a pipe here.

namespace {

using Crash = void (*)();

void readsNothing()
{
    // Not null, which a sanitizer would see before the system does.
    auto* nowhere = reinterpret_cast<volatile int*>(std::uintptr_t(64));
    *nowhere = 1;
}
void aborts()
{
    std::abort();
}
int usesUpItsStack(int depth);
int (*volatile again)(int) = usesUpItsStack; // so that no compiler sees that it never ends
int usesUpItsStack(int depth)
{
    volatile char room[4096] = {};
    room[0] = static_cast<char>(depth);
    return again(depth + 1) + room[0];
}
void overflows()
{
    static_cast<void>(usesUpItsStack(0));
}
#ifndef __SANITIZE_THREAD__ // which takes no thread that begins behind a fork
void overflowsInAThread()
{
    std::thread([] {
        const CrashStop::Stack own;
        static_cast<void>(usesUpItsStack(0));
    }).join();
}
#endif
void throwsWhatNobodyCatches()
{
    throw 1;
}

Report stopReport()
{
    return encode(Command{0, StopCommand{}});
}

/// In the child.
[[noreturn]] void crashHolding(int gripper, Crash crash) noexcept
{
    const rlimit noCore{0, 0};
    setrlimit(RLIMIT_CORE, &noCore);
    for (const int signal : {SIGSEGV, SIGABRT}) // those of the test library would call a debugger
        std::signal(signal, SIG_DFL);
    CrashStop::installHandler();
    const CrashStop stop(gripper, stopReport());
    crash();
    _exit(0);
}

} // namespace

class CrashStopTest : public QObject {
    Q_OBJECT
private slots:
    void aProgramThatCrashesStopsItsGripper_data()
    {
        QTest::addColumn<Crash>("crash");
        QTest::addColumn<int>("signal");
        QTest::newRow("a fault of memory") << Crash(readsNothing) << SIGSEGV;
        QTest::newRow("an abort") << Crash(aborts) << SIGABRT;
        QTest::newRow("an exception that nobody catches") << Crash(throwsWhatNobodyCatches) << SIGABRT;
        QTest::newRow("the stack used up") << Crash(overflows) << SIGSEGV;
#ifndef __SANITIZE_THREAD__
        QTest::newRow("the stack of a thread used up") << Crash(overflowsInAThread) << SIGSEGV;
#endif
    }
    void aProgramThatCrashesStopsItsGripper()
    {
        QFETCH(Crash, crash);
        QFETCH(int, signal);
        int ends[2];
        QVERIFY(pipe(ends) == 0);
        const pid_t child = fork();
        if (child == 0)
            crashHolding(ends[1], crash);
        close(ends[1]);
        std::array<Report, 4> came{};
        const auto bytes = read(ends[0], came.data(), sizeof came); // written at once, in three pieces
        std::size_t all = bytes > 0 ? static_cast<std::size_t>(bytes) : 0;
        while (all < 3 * reportSize) {
            const auto more = read(ends[0], reinterpret_cast<char*>(came.data()) + all, sizeof came - all);
            if (more <= 0)
                break;
            all += static_cast<std::size_t>(more);
        }
        close(ends[0]);
        int status = 0;
        QCOMPARE(waitpid(child, &status, 0), child);
        QCOMPARE(all, 3 * reportSize);
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(came[i] == stopReport());
        // The system sees the crash as it was.
        QVERIFY(WIFSIGNALED(status));
        QCOMPARE(WTERMSIG(status), signal);
    }

    void whatWasLetGoOfIsNotWrittenTo()
    {
        int ends[2];
        QVERIFY(pipe(ends) == 0);
        const pid_t child = fork();
        if (child == 0) {
            {
                CrashStop first(ends[1], stopReport());
                const CrashStop moved(std::move(first));
            }
            crashHolding(-1, aborts);
        }
        close(ends[1]);
        char byte = 0;
        QCOMPARE(read(ends[0], &byte, 1), ssize_t(0));
        close(ends[0]);
        QCOMPARE(waitpid(child, nullptr, 0), child);
    }
};

GRIPSCOPE_TEST(CrashStopTest)
#include "crash_stop_test.moc"
