// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace gripscope::cli {

/// One subcommand: what it is called, what it does in a line, and how to run it with what follows its name.
/// It returns the exit code.
struct Command {
    QString name;
    QString summary;
    int (*run)(const QStringList& arguments);
};

[[nodiscard]] const std::vector<Command>& commands();

int runDemo(const QStringList& arguments);
int runDevice(const QStringList& arguments);
int runSelfCheck(const QStringList& arguments);
int runDevices(const QStringList& arguments);
int runProfile(const QStringList& arguments);
int runRecord(const QStringList& arguments);
int runReplay(const QStringList& arguments);
int runCaptures(const QStringList& arguments);
int runSimulate(const QStringList& arguments);
int runIdentify(const QStringList& arguments);
int runCluster(const QStringList& arguments);
int runEnroll(const QStringList& arguments);
int runClassify(const QStringList& arguments);
int runTypes(const QStringList& arguments);
int runHistory(const QStringList& arguments);
int runLibrary(const QStringList& arguments);
int runAudit(const QStringList& arguments);
int runDrift(const QStringList& arguments);
int runTransfer(const QStringList& arguments);
int runReproducePaper(const QStringList& arguments);
int runCalibrate(const QStringList& arguments);
int runStudy(const QStringList& arguments);
int runDesign(const QStringList& arguments);

} // namespace gripscope::cli
