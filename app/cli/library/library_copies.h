// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace gripscope::cli {

/// `library backup FILE`: a copy of a library that may be in use.
int backUp(const QStringList& arguments);
/// `library restore FILE`: the way back.
int restore(const QStringList& arguments);

} // namespace gripscope::cli
