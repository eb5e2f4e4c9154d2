// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patient_limits.h"
#include "tests/support/test_registry.h"
#include "ui/context/workbench.h"
#include "ui/pages/page.h"
#include "ui/shell/main_window.h"
#include "ui/theme/theme.h"
#include "ui/windows/question.h"

#include <QElapsedTimer>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <memory>

namespace gripscope::test {

/// A gripper for tests that squeeze and do not look at the stream between squeezes: time passes for it only
/// as the program asks for samples, so that nothing is ever too late on a busy computer (see
/// VirtualTransport). Beside busy neighbours one in real time is disarmed by its watchdog now and then, as it
/// should be.
inline const QString unhurriedA = QStringLiteral("virtual:?object=A&seed=5&speed=0");

/// The whole window on the virtual gripper with a library of its own, as a person meets it.
class WindowFixture {
public:
    /// `limits`: of the link to the gripper; those of a patient one where a test is not about them.
    explicit WindowFixture(bool examples = true,
                           const QString& address = QStringLiteral("virtual:?object=A&seed=5"),
                           const LinkLimits& limits = patientLimits())
    {
        Theme::instance().apply(ThemeKind::Light);
        bench = std::make_unique<Workbench>(m_folder.filePath(QStringLiteral("test.gripscope")));
        bench->setOperatorName(QStringLiteral("Mai"));
        bench->setLinkLimits(limits);
        if (examples) {
            loaded = false;
            bench->background().ask<void>(
                nullptr, [](Library& library) { return library.loadExampleTypes(); },
                [this](const Expected<void>& done) { loaded = done.has_value(); });
        }
        window = std::make_unique<MainWindow>(*bench);
        window->resize(1024, 640);
        window->show();
        makeActive();
        if (!QTest::qWaitFor([this] { return loaded; }, longEnough_ms))
            qFatal("the examples were not loaded");
        bench->tellLibraryChanged();
        if (!address.isEmpty())
            connectTo(address);
        const bool ready = QTest::qWaitFor(
            [this, examples] {
                return bench->inspection().state() == InspectSession::State::Ready &&
                       bench->inspection().types().size() == (examples ? 4U : 0U);
            },
            longEnough_ms);
        if (!ready)
            qFatal("the library was not read");
    }

    void connectTo(const QString& address)
    {
        bench->connectTo(address);
        if (!QTest::qWaitFor(
                [this] { return bench->connection().state() == ConnectSession::State::Connected; },
                longEnough_ms))
            qFatal("the virtual gripper did not answer");
    }

    /// An inactive window keeps the focus it had, and keys would go astray. The offscreen platform, unlike
    /// others, leaves no window active when a dialog closes.
    void makeActive() const
    {
        window->activateWindow();
        if (!QTest::qWaitForWindowActive(window.get(), longEnough_ms))
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

    /// For what has to be squeezed in real time: arms the gripper, does `begin`, waits for `done`. Where the
    /// squeeze falls in the gripper's noise and how long it gets is up to the computer then, so that one in
    /// some may be in doubt, and beside busy neighbours the gripper's watchdog may end it: as a person would,
    /// again then. False when nothing came of it ten times.
    [[nodiscard]] bool inRealTime(const std::function<void()>& begin, const std::function<bool()>& done) const
    {
        constexpr int tries = 10;
        constexpr int storing_ms = 5000; // a squeeze that is over is judged and stored in less
        for (int i = 0; i < tries; ++i) {
            if (!bench->connection().armed())
                bench->arm();
            if (!QTest::qWaitFor([this] { return bench->connection().armed(); }, longEnough_ms))
                return false;
            if (done())
                return true;
            begin();
            QElapsedTimer idle;
            const auto ended = [&] {
                if (bench->squeezing() || bench->inspection().state() == InspectSession::State::Judging ||
                    bench->enrollment().activity() == EnrollSession::Activity::Identifying)
                    idle.invalidate();
                else if (!idle.isValid())
                    idle.start();
                return done() || (idle.isValid() && idle.hasExpired(storing_ms));
            };
            const bool over = QTest::qWaitFor(ended, longEnough_ms);
            if (done())
                return true;
            if (!over)
                return false;
        }
        return false;
    }

    /// Answers the question why something is changed, which comes up by itself.
    void sayWhy(const QString& reason = QStringLiteral("asked for by quality")) const
    {
        const auto question = [this] {
            return window->findChild<TextQuestion*>(QStringLiteral("whyQuestion"));
        };
        if (!QTest::qWaitFor([&question] { return question() != nullptr; }, longEnough_ms))
            qFatal("nobody asked why");
        QTest::keyClicks(question()->field(), reason);
        QTest::keyClick(question()->field(), Qt::Key_Return);
        if (!QTest::qWaitFor([&question] { return question() == nullptr; }, longEnough_ms))
            qFatal("the reason was not taken");
    }

    static void clickWhenEnabled(QWidget* widget)
    {
        QTRY_VERIFY(widget->isVisible() && widget->isEnabled());
        click(widget);
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
