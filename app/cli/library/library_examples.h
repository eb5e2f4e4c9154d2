// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace gripscope::cli {

/// `library examples`: adds types to look at.
int addExamples(const QStringList& arguments);

} // namespace gripscope::cli
