// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/audit/audit_trail.h"
#include "core/library/people/people_register.h"
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/context/sign_in.h"
#include "ui/people/sign_in_dialog.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace gripscope::test {

/// The window on a library with a supervisor, Sam (PIN 2468135790), and an operator, Olli (password "ein
/// langes Wort"); nobody has signed in.
class PeopleWindow : public WindowFixture {
public:
    explicit PeopleWindow(const QString& address = {}) : WindowFixture(true, address)
    {
        answer<void>([](Library& library) -> Expected<void> {
            const auto sam = library.people().add(QStringLiteral("Sam"), Role::Supervisor,
                                                  Secret(QStringLiteral("2468135790")));
            if (!sam)
                return tl::unexpected(sam.error());
            const auto grant = library.people().authorise(sam->id, Secret(QStringLiteral("2468135790")),
                                                          Permission::ManagePeople);
            if (!grant)
                return tl::unexpected(grant.error());
            library.actAs({{}, {}, *grant});
            return library.people()
                .add(QStringLiteral("Olli"), Role::Operator, Secret(QStringLiteral("ein langes Wort")))
                .map([](const Person&) {});
        });
        bench->signIn().reload();
        if (!QTest::qWaitFor([this] { return bench->signIn().people().size() == 2; }, longEnough_ms))
            qFatal("the people were not read");
    }

    /// What the library says, waited for.
    template <typename T>
    T answer(std::function<Expected<T>(Library&)> work) const
    {
        std::optional<Expected<T>> got;
        bench->background().ask<T>(nullptr, std::move(work),
                                   [&got](Expected<T> value) { got = std::move(value); });
        if (!QTest::qWaitFor([&got] { return got.has_value(); }, longEnough_ms) || !*got)
            qFatal("the library did not answer");
        if constexpr (!std::is_void_v<T>)
            return std::move(**got);
    }
    /// The newest entry of the audit trail.
    [[nodiscard]] AuditEntry newestEntry() const
    {
        const auto entries = answer<std::vector<AuditEntry>>([](Library& library) {
            return library.auditTrail().entries({{}, {}, 1, 0});
        });
        return entries.empty() ? AuditEntry() : entries.front();
    }

    [[nodiscard]] SignInDialog* dialog() const { return window->findChild<SignInDialog*>(); }
    /// Types into the dialog that is open, and presses its button.
    void typeSecret(const QString& name, const QString& secret) const
    {
        QVERIFY(QTest::qWaitFor([this] { return dialog() != nullptr; }, longEnough_ms));
        dialog()->findChild<QComboBox*>(QStringLiteral("personField"))->setCurrentText(name);
        auto* field = dialog()->findChild<QLineEdit*>(QStringLiteral("secretField"));
        QTest::keyClicks(field, secret);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void authorise() const
    {
        typeSecret(QStringLiteral("Sam"), QStringLiteral("2468135790"));
        QVERIFY(QTest::qWaitFor([this] { return dialog() == nullptr; }, longEnough_ms));
    }
    /// As the person would, by the menu of the header.
    void signIn(const QString& name, const QString& secret) const
    {
        auto* asked = new SignInDialog(*bench, std::nullopt, window.get());
        asked->open();
        typeSecret(name, secret);
        QVERIFY(QTest::qWaitFor([this] { return dialog() == nullptr; }, longEnough_ms));
        QVERIFY(bench->signIn().current());
    }
    void signInOlli() const { signIn(QStringLiteral("Olli"), QStringLiteral("ein langes Wort")); }
};

} // namespace gripscope::test
