// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/library/merge/known_history.h"
#include "core/library/sql/database.h"
#include "core/library/tables/permission_check.h"
#include "core/library/tables/write_transaction.h"

namespace gripscope {

struct Library::Private {
    explicit Private(std::unique_ptr<Database> opened) : database(std::move(opened)) {}
    std::unique_ptr<Database> database;
    ReadMeetings meetings; ///< what other stations had seen
    bool atOnce = false;   ///< a transaction is open, and ends where it began

    /// Runs `work` in one write transaction: all of it is stored, or, when it or the commit fails, nothing.
    /// Part of the larger one where there is one.
    template <typename T, typename Work>
    Expected<T> write(const QString& doing, const Work& work)
    {
        if (atOnce)
            return work();
        return writeTo<T>(*database, doing, work);
    }
    /// The same for what not everybody may do.
    template <typename T, typename Work>
    Expected<T> writeIf(Permission permission, const QString& doing, const Work& work)
    {
        return write<T>(doing, [&]() -> Expected<T> {
            RETURN_IF_ERROR(requirePermission(*database, permission));
            return work();
        });
    }

    /// Whether a squeeze counts in its type: ChangeKind::Drop or Undrop. Nothing where it is so already.
    [[nodiscard]] Expected<void> place(const QString& graspId, ChangeKind kind, const QString& reason,
                                       const QString& operatorName);
};

} // namespace gripscope
