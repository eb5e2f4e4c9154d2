// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>
#include <memory>

namespace gripscope::test {

using TestFactory = std::function<std::unique_ptr<QObject>()>;

/// Makes a test class known by its name; returns true so that it can initialise a variable.
bool registerTest(const char* name, TestFactory factory);

/// Runs the class named by the first argument (all classes without one); the rest goes to Qt Test.
int runTests(int argc, char** argv);

} // namespace gripscope::test

#define GRIPSCOPE_TEST(Class)                                                                                \
    static const bool registered##Class =                                                                    \
        gripscope::test::registerTest(#Class, [] { return std::unique_ptr<QObject>(new Class); });
