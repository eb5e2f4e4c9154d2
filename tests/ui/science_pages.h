// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/test_registry.h"
#include "ui/context/workbench.h"
#include "ui/theme/theme.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace gripscope::test {

/// A workbench on a library of its own, for one test.
struct PageFixture {
    QTemporaryDir folder;
    Workbench bench{folder.filePath(QStringLiteral("library.db"))};
    QSignalSpy reports{&bench.messages(), &Messages::reported};
    QSignalSpy told{&bench.messages(), &Messages::told};

    [[nodiscard]] bool loadExamples()
    {
        bool done = false;
        bench.background().ask<void>(
            nullptr, [](Library& library) { return library.loadExampleTypes(); },
            [&](Expected<void> loaded) {
                done = loaded.has_value();
                bench.tellLibraryChanged();
            });
        return QTest::qWaitFor([&] { return done; }, gripscope::test::longEnough_ms);
    }
};

/// Longest that a test waits for something that takes a moment on a busy computer.

} // namespace gripscope::test
