// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme/theme.h"
#include "ui/workbench.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace gripscope::test {

/// A workbench on a library of its own, for one test.
struct PageFixture {
    QTemporaryDir folder;
    Workbench bench{folder.filePath(QStringLiteral("library.db"))};
    QSignalSpy reports{&bench, &Workbench::reported};

    [[nodiscard]] bool loadExamples()
    {
        bool done = false;
        bench.ask<void>(
            nullptr, [](Library& library) { return library.loadExampleTypes(); },
            [&](Expected<void> loaded) {
                done = loaded.has_value();
                bench.tellLibraryChanged();
            });
        return QTest::qWaitFor([&] { return done; }, 20000);
    }
};

/// Longest that a test waits for something that takes a moment on a busy computer.
inline constexpr int patience_ms = 30000;

} // namespace gripscope::test
