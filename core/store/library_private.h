// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/database.h"
#include "core/store/library.h"

namespace gripscope {

struct Library::Private {
    explicit Private(std::unique_ptr<Database> opened) : database(std::move(opened)) {}
    std::unique_ptr<Database> database;
    bool atOnce = false; ///< a transaction is open, and ends where it began

    /// Runs `work` in one write transaction: all of it is stored, or, when it or the commit fails, nothing.
    /// Part of the larger one where there is one.
    template <typename T, typename Work>
    Expected<T> write(const QString& doing, const Work& work)
    {
        if (atOnce)
            return work();
        auto transaction = Transaction::begin(*database, doing);
        if (!transaction)
            return tl::unexpected(transaction.error());
        Expected<T> result = work();
        if (!result)
            return result;
        if (auto done = (*transaction)->commit(); !done)
            return tl::unexpected(done.error());
        return result;
    }

    /// Whether a squeeze counts in its type: ChangeKind::Drop or Undrop. Nothing where it is so already.
    [[nodiscard]] Expected<void> place(const QString& graspId, ChangeKind kind, const QString& reason,
                                       const QString& operatorName);
};

} // namespace gripscope
