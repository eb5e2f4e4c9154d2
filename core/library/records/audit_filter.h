// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

struct AuditFilter {
    QString text;   ///< person, subject, reason, details or station contains
    QString action; ///< begins with; empty: all
    int limit = 200;
    int offset = 0;
};

} // namespace gripscope
