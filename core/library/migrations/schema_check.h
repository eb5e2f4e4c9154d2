// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

#include <vector>

namespace gripscope {

class Database;

/// The tables of a library in an empty database, as the migrations of this program make them, without a row
/// in them: it is no library yet, and its file is told to nobody.
[[nodiscard]] Expected<void> makeTables(Database& database);

struct SchemaDifference {
    enum class What { Missing, Different, Unknown };
    What what = What::Different;
    QString type; ///< "table", "index", "view", "trigger"
    QString name;
    friend bool operator==(const SchemaDifference&, const SchemaDifference&) = default;
};
[[nodiscard]] QString inWords(SchemaDifference::What what);

/// Whether tables, indexes, views and triggers are those that the migrations of this program make, to the
/// letter but for blanks: a library may come from anybody, and one that does something by itself, or no
/// longer holds rows to what they may be, is none. None: all is as it should be. SQLite's own statistics may
/// be there.
[[nodiscard]] Expected<std::vector<SchemaDifference>> schemaDifferences(Database& database);

} // namespace gripscope
