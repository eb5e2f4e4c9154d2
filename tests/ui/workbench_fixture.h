// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/main_window.h"
#include "ui/pages/page.h"
#include "ui/theme/theme.h"
#include "ui/workbench.h"

#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace gripscope::test {

/// The whole window on the virtual gripper with a library of its own, as a person meets it.
class WindowFixture {
public:
    explicit WindowFixture(bool examples = true,
                           const QString& address = QStringLiteral("virtual:?object=A&seed=5"))
    {
        Theme::instance().apply(ThemeKind::Light);
        bench = std::make_unique<Workbench>(m_folder.filePath(QStringLiteral("test.gripscope")));
        bench->setOperatorName(QStringLiteral("Mai"));
        if (examples) {
            loaded = false;
            bench->ask<void>(
                nullptr, [](Library& library) { return library.loadExampleTypes(); },
                [this](const Expected<void>& done) { loaded = done.has_value(); });
        }
        window = std::make_unique<MainWindow>(*bench);
        window->resize(1024, 640);
        window->show();
        makeActive();
        if (!QTest::qWaitFor([this] { return loaded; }, 20000))
            qFatal("the examples were not loaded");
        bench->tellLibraryChanged();
        if (!address.isEmpty())
            connectTo(address);
        const bool ready = QTest::qWaitFor(
            [this, examples] {
                return bench->inspection().state() == InspectSession::State::Ready &&
                       bench->inspection().types().size() == (examples ? 4U : 0U);
            },
            20000);
        if (!ready)
            qFatal("the library was not read");
    }

    void connectTo(const QString& address)
    {
        bench->connectTo(address);
        if (!QTest::qWaitFor(
                [this] { return bench->connection().state() == ConnectSession::State::Connected; }, 20000))
            qFatal("the virtual gripper did not answer");
    }

    /// An inactive window keeps the focus it had, and keys would go astray. The offscreen platform, unlike
    /// others, leaves no window active when a dialog closes.
    void makeActive() const
    {
        window->activateWindow();
        if (!QTest::qWaitForWindowActive(window.get()))
            qFatal("the window did not become active");
    }

    template <typename T>
    [[nodiscard]] T* find(const char* name) const
    {
        T* widget = window->findChild<T*>(QString::fromLatin1(name));
        if (!widget)
            qFatal("there is no widget %s", name);
        return widget;
    }

    [[nodiscard]] Page* page(const QString& id) const
    {
        for (Page* one : window->pages())
            if (one->id() == id)
                return one;
        return nullptr;
    }

    static void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }

private:
    QTemporaryDir m_folder;

public:
    bool loaded = true;
    std::unique_ptr<Workbench> bench;
    std::unique_ptr<MainWindow> window;
};

} // namespace gripscope::test
