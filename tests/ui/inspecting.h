// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/widgets/inspection_widgets.h"
#include "ui/windows/scan_reader.h"

#include <QApplication>
#include <QLineEdit>
#include <QPushButton>

// What a technician does on the Inspect page, by real events.
namespace gripscope::test::inspecting {

using namespace Qt::StringLiterals;

/// Where keys go.
inline QWidget* focusOf(const WindowFixture& f)
{
    return f.window->focusWidget();
}

inline void expectType(WindowFixture& f, const QString& name)
{
    auto* chooser = f.find<TypeChooser>("expectedCombo");
    QVERIFY(chooser->findData(name) >= 0);
    chooser->setFocus();
    chooser->lineEdit()->selectAll();
    QTest::keyClicks(chooser, name);
    // The offscreen platform activates the list that pops up, a moment later: that is to come before the
    // list is gone, or it would take the focus.
    QTest::qWait(20);
    QTest::keyClick(chooser, Qt::Key_Return);
    QCOMPARE(chooser->expected(), name);
}

/// Space wherever the focus is, until the verdict is in the library.
inline void squeezeBySpace(WindowFixture& f)
{
    auto* squeeze = f.find<QPushButton>("squeezeButton");
    QTRY_VERIFY_WITH_TIMEOUT(squeeze->isEnabled(), longEnough_ms);
    QTRY_COMPARE_WITH_TIMEOUT(focusOf(f), static_cast<QWidget*>(squeeze),
                              longEnough_ms); // put forward by the page itself
    const qint64 before = f.bench->inspection().counts().total;
    QTest::qWait(2 * ScanReader::longestGap_ms); // keys that follow faster are a scanner's
    QTest::keyClick(focusOf(f), Qt::Key_Space);
    const bool stored =
        QTest::qWaitFor([&] { return f.bench->inspection().counts().total == before + 1; }, longEnough_ms);
    const QWidget* focus = focusOf(f);
    QVERIFY2(stored,
             qPrintable(u"armed: %1, focus: %2 %3, message: %4"_s.arg(f.bench->connection().armed())
                            .arg(QString::fromLatin1(focus ? focus->metaObject()->className() : "none"),
                                 focus ? focus->objectName() : QString(), f.window->message())));
}

/// As a scanner does: fast, and Enter behind it.
inline void scan(WindowFixture& f, const QString& text)
{
    QWidget* focus = focusOf(f);
    QTest::keyClicks(focus, text);
    QTest::keyClick(focus, Qt::Key_Return);
}

/// A window on the Inspect page, armed.
struct Armed {
    WindowFixture f;
    explicit Armed(const QString& address = unhurriedA) : f(true, address)
    {
        f.window->showPage(u"inspect"_s);
        f.click(f.find<QPushButton>("inspectArmButton"));
        if (!QTest::qWaitFor([this] { return f.find<QPushButton>("squeezeButton")->isEnabled(); },
                             longEnough_ms))
            qFatal("the gripper was not armed");
    }
    void setCode(const QString& type, const QString& code)
    {
        bool done = false;
        f.bench->background().ask<void>(
            nullptr,
            [type, code](Library& library) {
                const auto found = library.findType(type);
                return library.setTypeCode((*found)->id, code, {u"Mai"_s, u"a test"_s}).map([](const auto&) {
                });
            },
            [&done](const Expected<void>& answer) { done = answer.has_value(); });
        QTRY_VERIFY_WITH_TIMEOUT(done, longEnough_ms);
        f.bench->tellLibraryChanged();
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->inspection().state() == InspectSession::State::Ready &&
                                     !f.bench->inspection().types().at(1).code.isEmpty(),
                                 longEnough_ms);
    }
    [[nodiscard]] bool squeezed() const
    {
        return f.bench->inspection().state() != InspectSession::State::Ready ||
               f.bench->inspection().counts().total > 0;
    }
    [[nodiscard]] QString expected() const { return f.find<TypeChooser>("expectedCombo")->expected(); }
};

} // namespace gripscope::test::inspecting
