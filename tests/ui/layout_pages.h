// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/test_registry.h"
#include "tests/ui/layout_walk.h"
#include "tests/ui/workbench_fixture.h"

#include <QAbstractItemModelTester>
#include <QAbstractItemView>

namespace gripscope::test {

inline void pageRows()
{
    QTest::addColumn<QString>("id");
    for (const char* id : {"live", "inspect", "enroll", "types", "fit", "calibrate", "history", "quality"})
        QTest::newRow(id) << QString::fromLatin1(id);
}

/// The page of the row in the state that the tour shows, in every theme and size, with a message and without.
inline void walkPageAtWork(const QString& message)
{
    QFETCH(QString, id);
    WindowFixture f(true, QStringLiteral("virtual:"));
    f.window->showPage(id);
    f.page(id)->prepareTour();
    QTRY_VERIFY_WITH_TIMEOUT(f.page(id)->tourReady(), longEnough_ms);
    f.window->showPage(id);
    for (const QAbstractItemView* view : f.page(id)->findChildren<QAbstractItemView*>())
        if (view->model())
            QAbstractItemModelTester(view->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    LayoutWalk walk(*f.window);
    walk.inAll(QStringLiteral("at work"), everySize, message);
    QVERIFY(walk.sound());
}

/// The page of the row with an empty library and no gripper.
inline void walkEmptyPage(const QString& message)
{
    QFETCH(QString, id);
    WindowFixture f(false, QString());
    f.window->showPage(id);
    LayoutWalk walk(*f.window);
    walk.inAll(QStringLiteral("empty"), everySize, message);
    QVERIFY(walk.sound());
}

} // namespace gripscope::test
