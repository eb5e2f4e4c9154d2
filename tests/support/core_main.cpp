// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"

#include <QCoreApplication>
#include <QStandardPaths>

#ifdef __SANITIZE_THREAD__
// Qt Test has a thread of its own that watches the time; Debian's Qt is built without the sanitizer, which
// therefore does not see how that thread and the main one agree. The same goes for GLib, whose allocator
// passes memory from a thread that ended to the next.
extern "C" const char* __tsan_default_suppressions()
{
    return "race:QWaitCondition\ncalled_from_lib:libQt6Test\nrace:libglib-2.0.so\n";
}
#endif

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    return gripscope::test::runTests(argc, argv);
}
