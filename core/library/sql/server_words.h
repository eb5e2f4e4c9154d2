// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/library_location.h"
#include "core/library/sql/sql_dialect.h"

class QSqlError;

namespace gripscope {

/// What a failed statement on a PostgreSQL server means, by its SQLSTATE, and what to do.
[[nodiscard]] SqlFailure serverFailure(const QSqlError& error);

/// Why a server cannot be reached or lets nobody in, and what to do. A server says that in words alone, its
/// own language's: those of English and German are known, others are given as they are.
[[nodiscard]] QString whyNotConnected(const ServerAddress& server, const QSqlError& error);

} // namespace gripscope
