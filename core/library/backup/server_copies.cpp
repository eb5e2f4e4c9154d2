// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/backup/server_copies.h"

#include "core/base/words.h"
#include "core/library/sql/library_location.h"

namespace gripscope {

using namespace Qt::StringLiterals;

std::optional<Error> copiedByServer(const QString& library, const QString& copy)
{
    if (!LibraryLocation::isOnServer(library))
        return {};
    const QString command = u"pg_dump --format=custom --file='%1' '%2'"_s.arg(copy, withoutPassword(library));
    return Error{ErrorCode::Usage,
                 {Words::tr("A library on a PostgreSQL server is copied by the server's own program, also "
                            "while it is in use: %1")
                      .arg(command)}};
}

std::optional<Error> putBackByServer(const QString& library, const QString& backup)
{
    if (!LibraryLocation::isOnServer(library))
        return {};
    const QString command = u"pg_restore --clean --if-exists --single-transaction --dbname='%1' '%2'"_s.arg(
        withoutPassword(library), backup);
    return Error{ErrorCode::Usage,
                 {Words::tr("A library on a PostgreSQL server is put back by the server's own program, from "
                            "what pg_dump made, while no station has it open: %1")
                      .arg(command)}};
}

} // namespace gripscope
