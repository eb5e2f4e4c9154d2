// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace gripscope::cli {

/// `library take-back FILE`: stores inspections that were kept aside.
int takeBack(const QStringList& arguments);

} // namespace gripscope::cli
