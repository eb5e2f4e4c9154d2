// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"

namespace gripscope::cli {

/// At the end of an enrolment from files: in a library without people the type is approved, by whoever
/// enrolled it; where people are, it waits for one who may. Whether its parts are recognised now, which is
/// told on standard error.
[[nodiscard]] Expected<bool> approveEnrolled(Library& library, const QString& type,
                                             const QString& operatorName);

} // namespace gripscope::cli
