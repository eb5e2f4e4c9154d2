// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"

#include <QDir>
#include <QThreadPool>

#include <csignal>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace gripscope::test {

/// Until this thread is the only one: a child has the one that forked alone, and a lock that another held
/// then is never released in it. (Qt says that a pool's threads are done before they let go of GLib's.)
inline void waitToBeAlone()
{
    QThreadPool::globalInstance()->waitForDone();
    const auto end = std::chrono::steady_clock::now() + patience;
    const auto threads = [] {
        return QDir(QStringLiteral("/proc/self/task")).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size();
    };
    while (threads() > 2) {
        if (std::chrono::steady_clock::now() > end)
            qFatal("a process that forks has other threads, which do not end");
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// A second process that runs `work` and ends. A failure in it must not end in Qt Test's report of a crash,
/// and it must not outlive a test that hangs.
template <typename Work>
pid_t startChild(const Work& work)
{
    waitToBeAlone();
    const pid_t process = fork();
    if (process == 0) {
        std::signal(SIGABRT, SIG_DFL);
        std::signal(SIGSEGV, SIG_DFL);
        alarm(120);
        work();
        _exit(0);
    }
    return process;
}

/// Waits for its end; true when it ended as it should.
inline bool endedWell(pid_t process)
{
    int status = 0;
    waitpid(process, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace gripscope::test
