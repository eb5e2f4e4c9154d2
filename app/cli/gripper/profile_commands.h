// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace gripscope::cli {

// The actions of `gripscope-cli profile ACTION`; `arguments` follow the action. They return the exit code.
int checkProfiles(const QStringList& arguments);
int showProfile(const QStringList& arguments);
int listProfiles(const QStringList& arguments);
int installProfiles(const QStringList& arguments);
int watchReports(const QStringList& arguments);

} // namespace gripscope::cli
