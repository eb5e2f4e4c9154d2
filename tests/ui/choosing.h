// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/test_registry.h"

#include <QAction>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QStringList>
#include <QTest>
#include <QTimer>

#include <algorithm>
#include <functional>

// Files and entries of menus, chosen by real events.
namespace gripscope::test::choosing {

template <typename T>
T* child(QWidget* of, const QString& name)
{
    T* found = of->findChild<T*>(name);
    if (!found)
        qFatal("there is no %s", qPrintable(name));
    return found;
}

inline QFileDialog* openFileDialog(QWidget* over)
{
    const auto all = over->window()->findChildren<QFileDialog*>();
    const auto shown =
        std::find_if(all.begin(), all.end(), [](const QFileDialog* one) { return one->isVisible(); });
    return shown == all.end() ? nullptr : *shown;
}

/// Puts the name into the dialog that is over this window, and presses Enter.
inline void chooseFile(QWidget* over, const QString& file)
{
    QVERIFY(QTest::qWaitFor([&] { return openFileDialog(over) != nullptr; }, longEnough_ms));
    auto* name = child<QLineEdit>(openFileDialog(over), QStringLiteral("fileNameEdit"));
    name->setText(file); // typed, the list of what begins so would take Enter
    QTest::keyClick(name, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return openFileDialog(over) == nullptr; }, longEnough_ms));
}

/// Clicks the button, and the entry in the menu that it opens.
inline void chooseInMenu(QPushButton* button, QMenu* menu, const std::function<bool(const QAction*)>& wanted)
{
    bool chosen = false;
    QTimer look; // the menu may have a loop of its own
    QObject::connect(&look, &QTimer::timeout, menu, [&] {
        if (!menu->isVisible())
            return;
        look.stop();
        const auto actions = menu->actions();
        const auto entry = std::find_if(actions.begin(), actions.end(), wanted);
        if (entry == actions.end())
            qFatal("there is no such entry");
        chosen = true;
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(*entry).center());
    });
    look.start(20);
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return chosen && !menu->isVisible(); }, longEnough_ms));
}

/// The same by the words of entries: each in the menu that the one before it opens.
inline void chooseInMenu(QPushButton* button, QMenu* menu, const QStringList& path)
{
    qsizetype chosen = 0;
    QMenu* shown = menu;
    QTimer look; // the menu may have a loop of its own
    QObject::connect(&look, &QTimer::timeout, menu, [&] {
        if (chosen == path.size() || !shown->isVisible())
            return;
        const auto actions = shown->actions();
        const auto entry = std::find_if(actions.begin(), actions.end(), [&](const QAction* action) {
            return action->text() == path[chosen];
        });
        if (entry == actions.end())
            qFatal("there is no entry %s", qPrintable(path[chosen]));
        ++chosen;
        QMenu* in = shown;
        if ((*entry)->menu())
            shown = (*entry)->menu();
        QTest::mouseClick(in, Qt::LeftButton, {}, in->actionGeometry(*entry).center());
    });
    look.start(20);
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return chosen == path.size() && !menu->isVisible(); }, longEnough_ms));
}

} // namespace gripscope::test::choosing
