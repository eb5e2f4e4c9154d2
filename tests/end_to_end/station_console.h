// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/end_to_end/program_run.h"
#include "tests/support/patience.h"

namespace gripscope::test {

inline QString stationProgram()
{
    return QStringLiteral(GRIPSCOPE_BIN_DIR "/gripscope-station");
}

/// What a person asks the station that runs in this workplace, by the same program.
inline ProgramRun askStation(const Workplace& work, const QString& command)
{
    QProcess process;
    work.prepare(process, {command, QStringLiteral("--console"), work.path(QStringLiteral("console")),
                           QStringLiteral("--library"), work.path(QStringLiteral("parts.db"))});
    process.setProgram(stationProgram());
    process.start();
    const bool ended = process.waitForFinished(longEnough_ms);
    return {ended ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace gripscope::test
