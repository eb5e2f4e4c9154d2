// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/database.h"
#include "core/store/library.h"

namespace gripscope {

struct Library::Private {
    explicit Private(std::unique_ptr<Database> opened) : database(std::move(opened)) {}
    std::unique_ptr<Database> database;

    /// Runs `work` in one write transaction: all of it is stored, or, when it or the commit fails, nothing.
    template <typename T, typename Work>
    Expected<T> write(const QString& doing, const Work& work)
    {
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
};

} // namespace gripscope
