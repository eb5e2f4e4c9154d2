// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/own_home.h"
#include "tests/support/test_registry.h"

#include <QApplication>

int main(int argc, char** argv)
{
    const gripscope::test::OwnHome home;
    QApplication application(argc, argv);
    return gripscope::test::runTests(argc, argv);
}
