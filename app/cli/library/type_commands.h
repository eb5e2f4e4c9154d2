// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace gripscope::cli {

// The actions of `gripscope-cli types ACTION`; `arguments` follow the action. They return the exit code.
int listTypes(const QStringList& arguments);
int listSqueezes(const QStringList& arguments);
int listVersions(const QStringList& arguments);
int guideEnrollment(const QStringList& arguments);
int showConfusion(const QStringList& arguments);
int renameType(const QStringList& arguments);
int setTypeCode(const QStringList& arguments);
int typeLimits(const QStringList& arguments);
int mergeTypes(const QStringList& arguments);
int splitType(const QStringList& arguments);
int retireType(const QStringList& arguments);
int reinstateType(const QStringList& arguments);
int approveType(const QStringList& arguments);
int restoreVersion(const QStringList& arguments);

} // namespace gripscope::cli
