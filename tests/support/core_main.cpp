// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/own_home.h"
#include "tests/support/test_registry.h"

#include <QCoreApplication>

#ifdef __SANITIZE_THREAD__
// Qt Test has a thread of its own that watches the time; Debian's Qt is built without the sanitizer, which
// therefore does not see how that thread and the main one agree.
extern "C" const char* __tsan_default_suppressions()
{
    return "race:QWaitCondition\ncalled_from_lib:libQt6Test\n";
}
#endif

int main(int argc, char** argv)
{
    const gripscope::test::OwnHome home;
    QCoreApplication application(argc, argv);
    return gripscope::test::runTests(argc, argv);
}
