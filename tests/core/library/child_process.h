// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace gripscope::test {

/// A second process that runs `work` and ends. A failure in it must not end in Qt Test's report of a crash,
/// and it must not outlive a test that hangs.
template <typename Work>
pid_t startChild(const Work& work)
{
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
