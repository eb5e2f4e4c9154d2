// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"

#include <QTest>

#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace gripscope::test {

namespace {
std::map<std::string, TestFactory>& registry()
{
    static std::map<std::string, TestFactory> tests;
    return tests;
}

bool skipped = false;
} // namespace

bool registerTest(const char* name, TestFactory factory)
{
    return registry().emplace(name, std::move(factory)).second;
}

void noteSkip()
{
    skipped = true;
}

int runTests(int argc, char** argv)
{
    std::vector<char*> rest(argv, argv + argc);
    std::string wanted;
    if (argc > 1 && argv[1][0] != '-') {
        wanted = argv[1];
        rest.erase(rest.begin() + 1);
    }
    // Qt Test ends a function after five minutes by itself, which a sanitizer on a busy machine may take: the
    // time limit is ctest's alone, where the build sets it.
    if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT"))
        qputenv("QTEST_FUNCTION_TIMEOUT", "86400000");
    int failures = 0;
    int run = 0;
    for (const auto& [name, factory] : registry()) {
        if (!wanted.empty() && name != wanted)
            continue;
        ++run;
        const std::unique_ptr<QObject> test = factory();
        failures += QTest::qExec(test.get(), static_cast<int>(rest.size()), rest.data());
    }
    if (run == 0) {
        std::fprintf(stderr, "no test class is called %s\n", wanted.c_str());
        return 1;
    }
    // Not the number of failures: 77 of them would be a skip, and 256 nothing.
    if (failures != 0)
        return 1;
    return skipped ? skippedStatus : 0;
}

} // namespace gripscope::test
