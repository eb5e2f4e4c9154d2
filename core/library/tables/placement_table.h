// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/statement.h"

#include <map>

namespace gripscope {

/// Which type an enrolled squeeze belongs to, and whether it counts there.
struct Placement {
    QString typeId;
    bool accepted = true;
    friend bool operator==(const Placement&, const Placement&) = default;
};

} // namespace gripscope

namespace gripscope::placement_table {

/// From `version` of the library on.
[[nodiscard]] Expected<void> insert(Database& database, qint64 version, const QString& graspId,
                                    const Placement& placement);
/// Every enrolled squeeze by its key, as it was placed at `version`; not accepted where it came later.
[[nodiscard]] Expected<std::map<QString, Placement>> at(Database& database, qint64 version);

} // namespace gripscope::placement_table
