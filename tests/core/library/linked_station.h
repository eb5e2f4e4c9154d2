// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/exchange/library_exchange.h"
#include "tests/core/library/library_fixture.h"

namespace gripscope::test {

/// A station's own file, open; a server's library is a file here too, or a database where the tests run on
/// one.
struct LinkedStation {
    QTemporaryDir folder;
    std::unique_ptr<Library> library = valueOf(Library::open(file()));
    QString marks;
    [[nodiscard]] QString file() const { return folder.filePath(u"station.db"_s); }

    ExchangeStep step(Library& server, qint64 most = linksOfStep)
    {
        ExchangeStep taken = valueOf(library->exchangeWith(server, marks, most));
        marks = taken.marks;
        return taken;
    }
    /// Until both know the same. Returns what nobody has seen.
    std::vector<PlantConflict> bringInStep(Library& server)
    {
        std::vector<PlantConflict> conflicts;
        for (int i = 0; i < 100; ++i) {
            const ExchangeStep taken = step(server);
            if (taken.conflicts)
                conflicts = *taken.conflicts;
            if (taken.inStep)
                return conflicts;
        }
        qFatal("it does not come in step");
    }
};

} // namespace gripscope::test
