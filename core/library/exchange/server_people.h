// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/table_rows.h"

#include <vector>

namespace gripscope {

/// Puts people of a server's library into a station's, where roles are in force from then on: each as they
/// are at the server, whatever the station has made of them before; within the station's open transaction,
/// with an entry of the audit trail each. Who is in the station's library alone stays as they are: a name
/// that one of them has comes as "Ada (plant)". At least one active supervisor is left; where what the
/// station changed itself would leave none, all people of the server are as there again. `there`: all rows of
/// the server's people; `news`: the keys of those that the station has not. Returns how many were put in.
[[nodiscard]] Expected<qint64> takeServerPeople(Database& there, const std::vector<Cell>& news,
                                                Database& station, const QString& place);

} // namespace gripscope
