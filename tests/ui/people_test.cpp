// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/people_window.h"
#include "ui/pages/inspect/inspect_parts.h"
#include "ui/people/authorize.h"
#include "ui/people/people_dialogs.h"
#include "ui/settings/settings_link.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/connect_menu.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QTableWidget>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::PeopleWindow;
using gripscope::test::WindowFixture;

namespace {

void type(PersonForm* form, const char* field, const QString& text)
{
    auto* line = form->findChild<QLineEdit*>(QString::fromLatin1(field));
    line->clear();
    QTest::keyClicks(line, text);
}

void pressAdd(PersonForm* form)
{
    QTest::mouseClick(form->findChild<QPushButton*>(u"personAccept"_s), Qt::LeftButton);
}

/// The entry of the menu behind the operator, chosen as by hand.
void chooseInMenu(const WindowFixture& f, const char* action)
{
    f.click(f.find<QPushButton>("operatorChip"));
    auto* menu = f.find<QMenu>("operatorMenu");
    QTRY_VERIFY(menu->isVisible());
    auto* entry = menu->findChild<QAction*>(QString::fromLatin1(action));
    QVERIFY(entry);
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
}

} // namespace

/// People are added, sign in and out, and what needs a supervisor asks for one: from click to row.
class PeopleTest : public QObject {
    Q_OBJECT
private slots:
    void theFirstPersonIsASupervisorAndRolesAreInForceThen()
    {
        const WindowFixture f(false, {});
        QVERIFY(f.find<QLineEdit>("operatorField")->isVisible());
        chooseInMenu(f, "peopleAction");
        QTRY_VERIFY(f.window->findChild<PeopleDialog*>());
        f.click(f.find<QPushButton>("addPersonButton"));
        QTRY_VERIFY(f.window->findChild<PersonForm*>());
        auto* form = f.window->findChild<PersonForm*>();
        auto* role = form->findChild<QComboBox*>(u"roleField"_s);
        QCOMPARE(role->count(), 1);
        QCOMPARE(role->currentText(), u"supervisor"_s);
        type(form, "nameField", u"Sam"_s);
        type(form, "secretField", u"12345"_s);
        type(form, "againField", u"12346"_s);
        pressAdd(form);
        QVERIFY(form->findChild<QLabel*>(u"personState"_s)->text().contains(u"not the same"_s));
        type(form, "againField", u"12345"_s);
        pressAdd(form);
        QTRY_VERIFY_WITH_TIMEOUT(form->findChild<QLabel*>(u"personState"_s)->text().contains(u"too short"_s),
                                 gripscope::test::longEnough_ms);
        QCOMPARE(form->name(), u"Sam"_s); // what was typed is still there, but for the secret
        QVERIFY(form->findChild<QLineEdit*>(u"secretField"_s)->text().isEmpty());
        type(form, "secretField", u"123456"_s);
        type(form, "againField", u"123456"_s);
        pressAdd(form);
        QTRY_VERIFY_WITH_TIMEOUT(!f.window->findChild<PersonForm*>(), gripscope::test::longEnough_ms);
        auto* table = f.find<QTableWidget>("peopleTable");
        QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, gripscope::test::longEnough_ms);
        QCOMPARE(table->item(0, 0)->text(), u"Sam"_s);
        QCOMPARE(table->item(0, 1)->text(), u"supervisor"_s);
        QVERIFY(f.bench->signIn().inForce());
        QVERIFY(!f.find<QLineEdit>("operatorField")->isVisible());
        QCOMPARE(f.find<QPushButton>("operatorChip")->text(), u"Sign in"_s);
        QVERIFY(f.bench->operatorName().isEmpty());
    }
    void theSupervisorAddsChangesAndDeactivatesOthers()
    {
        PeopleWindow f;
        f.signIn(u"Sam"_s, u"2468135790"_s);
        chooseInMenu(f, "peopleAction");
        QTRY_VERIFY(f.window->findChild<PeopleDialog*>());
        f.click(f.find<QPushButton>("addPersonButton"));
        QTRY_VERIFY(f.window->findChild<PersonForm*>());
        auto* form = f.window->findChild<PersonForm*>();
        QCOMPARE(form->findChild<QComboBox*>(u"roleField"_s)->currentText(), u"operator"_s);
        type(form, "nameField", u"Ada"_s);
        type(form, "secretField", u"654321"_s);
        type(form, "againField", u"654321"_s);
        pressAdd(form);
        auto* table = f.find<QTableWidget>("peopleTable");
        QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 3, gripscope::test::longEnough_ms);
        QTRY_VERIFY(!f.window->findChild<PersonForm*>());
        table->selectRow(0);
        QCOMPARE(table->item(0, 0)->text(), u"Ada"_s);
        f.click(f.find<QPushButton>("roleButton"));
        f.sayWhy(u"the night shift"_s);
        QTRY_COMPARE_WITH_TIMEOUT(table->item(0, 1)->text(), u"supervisor"_s, gripscope::test::longEnough_ms);
        QCOMPARE(f.newestEntry().reason, u"the night shift"_s);
        f.click(f.find<QPushButton>("activeButton"));
        QTRY_COMPARE_WITH_TIMEOUT(table->item(2, 2)->text(), u"deactivated"_s,
                                  gripscope::test::longEnough_ms);
        // Sam is the last supervisor then.
        table->selectRow(1);
        QCOMPARE(table->item(1, 0)->text(), u"Sam"_s);
        f.click(f.find<QPushButton>("activeButton"));
        QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("peopleState")->text().contains(u"last supervisor"_s),
                                 gripscope::test::longEnough_ms);
        QVERIFY(f.bench->signIn().current());
    }
    void peopleSignInAndOut()
    {
        PeopleWindow f;
        chooseInMenu(f, "signInAction");
        f.typeSecret(u"Olli"_s, u"not the word"_s);
        auto* state = f.dialog()->findChild<QLabel*>(u"signInState"_s);
        QTRY_VERIFY_WITH_TIMEOUT(state->text().startsWith(u"That is not the PIN or password of Olli."_s),
                                 gripscope::test::longEnough_ms);
        QVERIFY(state->text().contains(u"4"_s));
        QCOMPARE(f.newestEntry().action, u"sign_in.failed"_s);
        f.typeSecret(u"Olli"_s, u"ein langes Wort"_s);
        QTRY_VERIFY_WITH_TIMEOUT(!f.dialog(), gripscope::test::longEnough_ms);
        QCOMPARE(f.bench->operatorName(), u"Olli"_s);
        QCOMPARE(f.find<QPushButton>("operatorChip")->text(), u"Olli"_s);
        chooseInMenu(f, "signOutAction");
        QTRY_COMPARE(f.bench->operatorName(), QString());
        QCOMPARE(f.newestEntry().action, u"sign_out"_s);
        QCOMPARE(f.newestEntry().person, u"Olli"_s);
    }
    void whoDoesNothingIsSignedOut()
    {
        PeopleWindow f;
        f.signInOlli();
        f.bench->signIn().setIdleLimit(std::chrono::milliseconds(1));
        QTRY_VERIFY_WITH_TIMEOUT(!f.bench->signIn().current(), gripscope::test::longEnough_ms);
        QVERIFY(f.window->message().contains(u"Olli was signed out"_s));
        QCOMPARE(f.newestEntry().details, u"{\"idle\":true}"_s);
    }
    void whoIsDeactivatedElsewhereIsSignedOutHere()
    {
        PeopleWindow f;
        f.signInOlli();
        f.answer<void>([](Library& library) -> Expected<void> {
            const auto sam = library.people().named(u"Sam"_s);
            const auto olli = library.people().named(u"Olli"_s);
            const auto grant =
                library.people().authorise(sam->id, Secret(u"2468135790"_s), Permission::ManagePeople);
            library.actAs({{}, {}, *grant});
            return library.people().setActive(olli->id, false);
        });
        f.bench->signIn().reload();
        QTRY_VERIFY_WITH_TIMEOUT(!f.bench->signIn().current(), gripscope::test::longEnough_ms);
    }
    void nothingIsJudgedForNobodyWhereThatIsSet()
    {
        const PeopleWindow f;
        const SettingsLink link(*f.bench);
        const auto refused = [&f] { return f.bench->inspection().policy().nobodySignedIn; };
        QVERIFY(!refused());
        f.bench->settings().set(setting::onlySignedIn, true);
        f.bench->settings().set(setting::refuseOverdue, true);
        f.bench->settings().set(setting::mostLostShare, 0.02);
        QVERIFY(refused());
        QVERIFY(f.bench->inspection().policy() == (JudgingPolicy{true, 0.02, true}));
        f.signInOlli();
        QTRY_VERIFY_WITH_TIMEOUT(!refused(), gripscope::test::longEnough_ms);
        f.bench->signIn().signOut();
        QVERIFY(refused());
    }
    void ratesAskForASupervisorOnce()
    {
        PeopleWindow f;
        f.signInOlli();
        f.window->showPage(u"inspect"_s);
        const double before = f.bench->rates().rates.falseReject;
        const auto change = [&f](double percent) {
            f.click(f.find<QPushButton>("ratesButton"));
            auto* dialog = f.find<RatesDialog>("ratesDialog");
            dialog->findChild<QDoubleSpinBox*>(u"falseRejectField"_s)->setValue(percent);
            f.click(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok));
            QTRY_VERIFY_WITH_TIMEOUT(!f.window->findChild<RatesDialog*>(), gripscope::test::longEnough_ms);
            f.sayWhy(u"the customer's drawing"_s);
        };
        change(2);
        QTRY_VERIFY(f.dialog());
        f.dialog()->reject();
        QTRY_VERIFY(!f.dialog());
        QCOMPARE(f.bench->rates().rates.falseReject, before);
        QVERIFY(f.newestEntry().action != u"rates.changed"_s);
        change(2);
        f.authorise();
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->rates().rates.falseReject, 0.02, gripscope::test::longEnough_ms);
        const AuditEntry entry = f.newestEntry();
        QCOMPARE(entry.action, u"rates.changed"_s);
        QCOMPARE(entry.person, u"Sam"_s);
        QCOMPARE(entry.reason, u"the customer's drawing"_s);
        QCOMPARE(entry.details,
                 u"{\"false_reject\":{\"from\":%1,\"to\":0.02},\"operator\":\"Olli\"}"_s.arg(before));
        change(3); // once is once
        QTRY_VERIFY(f.dialog());
        QCOMPARE(f.bench->rates().rates.falseReject, 0.02);
    }
    void anOperatorCannotConsent()
    {
        PeopleWindow f;
        bool done = false;
        authorize(*f.bench, f.window.get(), Permission::ChangeSettings, [&done] { done = true; });
        QTRY_VERIFY(f.dialog());
        QCOMPARE(f.dialog()->findChild<QComboBox*>(u"personField"_s)->count(), 1); // Sam alone
        f.typeSecret(u"Sam"_s, u"ein langes Wort"_s);
        auto* state = f.dialog()->findChild<QLabel*>(u"signInState"_s);
        QTRY_VERIFY_WITH_TIMEOUT(!state->text().isEmpty(), gripscope::test::longEnough_ms);
        QVERIFY(!done);
        f.authorise();
        QVERIFY(done);
    }
    void aSupervisorWhoIsSignedInIsNotAsked()
    {
        PeopleWindow f;
        f.signIn(u"Sam"_s, u"2468135790"_s);
        bool done = false;
        authorize(*f.bench, f.window.get(), Permission::ChangeSettings, [&done] { done = true; });
        QVERIFY(done && !f.dialog());
    }
    void onesOwnSecretNeedsNoSupervisor()
    {
        PeopleWindow f;
        f.signInOlli();
        chooseInMenu(f, "peopleAction");
        QTRY_VERIFY(f.window->findChild<PeopleDialog*>());
        auto* table = f.find<QTableWidget>("peopleTable");
        QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 2, gripscope::test::longEnough_ms);
        table->selectRow(0);
        f.click(f.find<QPushButton>("secretButton"));
        QTRY_VERIFY(f.window->findChild<PersonForm*>());
        auto* form = f.window->findChild<PersonForm*>();
        type(form, "secretField", u"a new password"_s);
        type(form, "againField", u"a new password"_s);
        pressAdd(form);
        QTRY_VERIFY_WITH_TIMEOUT(!f.window->findChild<PersonForm*>(), gripscope::test::longEnough_ms);
        QCOMPARE(f.newestEntry().action, u"person.secret"_s);
        QCOMPARE(f.newestEntry().person, u"Olli"_s);
    }
};

GRIPSCOPE_TEST(PeopleTest)
#include "people_test.moc"
