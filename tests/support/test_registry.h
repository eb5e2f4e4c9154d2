// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"

#include <QObject>
#include <QTest>

#include <functional>
#include <memory>

namespace gripscope::test {

using TestFactory = std::function<std::unique_ptr<QObject>()>;

/// Makes a test class known by its name; returns true so that it can initialise a variable.
bool registerTest(const char* name, TestFactory factory);

/// What runTests() returns when nothing failed, but something was skipped: ctest then says so
/// (SKIP_RETURN_CODE). It is an exit status of its own, since an expression that ctest looks for in the
/// output ("SKIP") would hide a failure beside the skip.
inline constexpr int skippedStatus = 77;

/// Runs the class named by the first argument (all classes without one); the rest goes to Qt Test. Returns 0,
/// 1 when anything failed, or skippedStatus.
int runTests(int argc, char** argv);

/// That a function was skipped; QSKIP tells it.
void noteSkip();

} // namespace gripscope::test

#define GRIPSCOPE_TEST(Class)                                                                                \
    static const bool registered##Class =                                                                    \
        gripscope::test::registerTest(#Class, [] { return std::unique_ptr<QObject>(new Class); });

// Qt Test tells nobody how many it skipped, so that its macro is replaced by one that does.
#undef QSKIP
#define QSKIP(reason)                                                                                        \
    do {                                                                                                     \
        gripscope::test::noteSkip();                                                                         \
        QTest::qSkip(reason, __FILE__, __LINE__);                                                            \
        return;                                                                                              \
    } while (false)

// Qt Test's own five seconds are too few beside busy neighbours.
#undef QTRY_VERIFY
#define QTRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT((condition), gripscope::test::longEnough_ms)
#undef QTRY_VERIFY2
#define QTRY_VERIFY2(condition, message)                                                                     \
    QTRY_VERIFY2_WITH_TIMEOUT((condition), message, gripscope::test::longEnough_ms)
#undef QTRY_COMPARE
#define QTRY_COMPARE(actual, expected)                                                                       \
    QTRY_COMPARE_WITH_TIMEOUT((actual), expected, gripscope::test::longEnough_ms)
