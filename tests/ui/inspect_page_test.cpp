// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/inspecting.h"
#include "ui/pages/inspect/inspect_parts.h"
#include "ui/widgets/inspection_widgets.h"
#include "ui/widgets/outcome_view.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRadioButton>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::unhurriedA;
using gripscope::test::WindowFixture;
using namespace gripscope::test::inspecting;

/// The Inspect page by click and key, with the virtual gripper.
class InspectPageTest : public QObject {
    Q_OBJECT
private slots:
    void sayWhatToDoBeforeTheFirstSqueeze();
    void emptyLibrarySaysEnrollFirst();
    void typesWithoutApprovalAreSaidToBeThat();
    void squeezeIsOnlyThereWhenArmed();
    void anExpectedPartIsAsExpected();
    void anotherTypeIsNamed();
    void aStrangerIsUnknown();
    void lostReportsAreNotTheParts();
    void theListFollowsTheInspections();
    void ratesAreSetByClickAndHold();
    void aDecidedSqueezeIsShortAndLeavesTheGripperArmed();
    void whatWasShownSoFarIsCounted();
};

void InspectPageTest::sayWhatToDoBeforeTheFirstSqueeze()
{
    WindowFixture f(true, unhurriedA);
    f.window->showPage(u"inspect"_s);
    const auto* verdict = f.find<VerdictPanel>("verdictPanel");
    QTRY_COMPARE(verdict->headline(), u"Not armed"_s);
    QVERIFY(!verdict->outcome());
    f.bench->arm();
    QTRY_COMPARE_WITH_TIMEOUT(verdict->headline(), u"Ready"_s, gripscope::test::longEnough_ms);
    f.bench->connection().disconnect();
    QTRY_COMPARE_WITH_TIMEOUT(verdict->headline(), u"No gripper"_s, gripscope::test::longEnough_ms);
}

void InspectPageTest::emptyLibrarySaysEnrollFirst()
{
    WindowFixture f(false);
    f.window->showPage(u"inspect"_s);
    QTRY_COMPARE(f.find<VerdictPanel>("verdictPanel")->headline(), u"No types yet"_s);
}

void InspectPageTest::typesWithoutApprovalAreSaidToBeThat()
{
    WindowFixture f(true, unhurriedA);
    f.window->showPage(u"inspect"_s);
    bool done = false;
    f.bench->background().ask<void>(
        nullptr,
        [](Library& library) -> Expected<void> {
            const ChangeNote note{{}, u"test"_s};
            ASSIGN_OR_RETURN(const auto types, library.types());
            for (const TypeRecord& type : types) {
                RETURN_IF_ERROR(library.retireType(type.id, note));
                RETURN_IF_ERROR(library.reinstateType(type.id, note));
            }
            return {};
        },
        [&done](const Expected<void>& changed) { done = changed.has_value(); });
    QTRY_VERIFY_WITH_TIMEOUT(done, gripscope::test::longEnough_ms);
    f.bench->tellLibraryChanged();
    QTRY_COMPARE_WITH_TIMEOUT(f.find<VerdictPanel>("verdictPanel")->headline(), u"No approved type"_s,
                              gripscope::test::longEnough_ms);
    QVERIFY(!f.find<QPushButton>("squeezeButton")->isVisible());
    QCOMPARE(f.bench->inspection().types().size(), std::size_t(4));
}

void InspectPageTest::squeezeIsOnlyThereWhenArmed()
{
    WindowFixture f(true, unhurriedA);
    f.window->showPage(u"inspect"_s);
    auto* squeeze = f.find<QPushButton>("squeezeButton");
    auto* arm = f.find<QPushButton>("inspectArmButton");
    QVERIFY(!squeeze->isEnabled());
    QVERIFY(arm->isVisible());
    f.page(u"inspect"_s)->setFocus();
    QTest::keyClick(f.page(u"inspect"_s), Qt::Key_Space);
    // The page hands Space to what it put forward, the Arm button: that arms, and squeezes nothing.
    QTRY_VERIFY_WITH_TIMEOUT(squeeze->isEnabled(), gripscope::test::longEnough_ms);
    QVERIFY(f.bench->connection().armed());
    QTest::qWait(200);
    QVERIFY(f.bench->inspection().state() == InspectSession::State::Ready && !f.bench->squeezing());
    QVERIFY(!arm->isVisible());
}

void InspectPageTest::anExpectedPartIsAsExpected()
{
    WindowFixture f(true, unhurriedA);
    f.window->showPage(u"inspect"_s);
    expectType(f, u"A"_s);
    f.click(f.find<QPushButton>("inspectArmButton"));
    squeezeBySpace(f);
    const auto* verdict = f.find<VerdictPanel>("verdictPanel");
    QVERIFY(verdict->outcome() == InspectionOutcome::AsExpected);
    QCOMPARE(verdict->headline(), u"A"_s);
    const QString reason = f.find<QLabel>("reasonLabel")->text();
    QVERIFY(!reason.isEmpty());
    QCOMPARE(reason.count(u". "_s), 0); // one sentence
    QCOMPARE(f.bench->inspection().counts().asExpected, 1);
    // The Fit page has it without being asked.
    QVERIFY(f.bench->navigator().fitSubject());
    QCOMPARE(f.bench->navigator().fitSubject()->title, u"Inspection 1"_s);
}

void InspectPageTest::anotherTypeIsNamed()
{
    WindowFixture f(true, u"virtual:?object=C&seed=8&speed=0"_s);
    f.window->showPage(u"inspect"_s);
    expectType(f, u"A"_s);
    f.click(f.find<QPushButton>("inspectArmButton"));
    squeezeBySpace(f);
    const auto* verdict = f.find<VerdictPanel>("verdictPanel");
    QVERIFY(verdict->outcome() == InspectionOutcome::OtherType);
    QCOMPARE(verdict->headline(), u"C"_s);
    QVERIFY(verdict->accessibleDescription().contains(u"expected A"_s));
}

void InspectPageTest::aStrangerIsUnknown()
{
    WindowFixture f(true, u"virtual:?object=0.05,80,7000&seed=8&speed=0"_s);
    f.window->showPage(u"inspect"_s);
    f.click(f.find<QPushButton>("inspectArmButton"));
    squeezeBySpace(f);
    QVERIFY(f.find<VerdictPanel>("verdictPanel")->outcome() == InspectionOutcome::Unknown);
}

void InspectPageTest::lostReportsAreNotTheParts()
{
    WindowFixture f(true, u"virtual:?object=A&seed=8&fault=loss:0.35&speed=0"_s);
    f.window->showPage(u"inspect"_s);
    f.click(f.find<QPushButton>("inspectArmButton"));
    f.bench->inspection().setEarlyEnd(false); // a short one may by chance have lost little
    squeezeBySpace(f);
    const auto* verdict = f.find<VerdictPanel>("verdictPanel");
    QVERIFY(verdict->outcome() == InspectionOutcome::NotValid);
    QCOMPARE(verdict->headline(), u"Squeeze again"_s);
    QVERIFY(f.find<QLabel>("reasonLabel")->text().contains(u"samples are missing"_s));
}

void InspectPageTest::theListFollowsTheInspections()
{
    WindowFixture f(true, unhurriedA);
    f.window->showPage(u"inspect"_s);
    auto* list = f.find<InspectionList>("inspectionList");
    const QAbstractItemModelTester tester(list->model(),
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    f.click(f.find<QPushButton>("inspectArmButton"));
    squeezeBySpace(f);
    squeezeBySpace(f);
    QTRY_COMPARE_WITH_TIMEOUT(list->model()->rowCount(), 2, gripscope::test::longEnough_ms);
    QCOMPARE(list->model()->index(0, 0).data(InspectionListModel::NumberRole).toLongLong(), 2);
    // A click on a line opens its squeeze, read back from the library, on the Fit page; so does Enter.
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualRect(list->model()->index(1, 0)).center());
    QTRY_COMPARE_WITH_TIMEOUT(f.window->currentPage()->id(), u"fit"_s, gripscope::test::longEnough_ms);
    QCOMPARE(f.bench->navigator().fitSubject()->title, u"Inspection 1"_s);
    f.window->showPage(u"inspect"_s);
    list->setFocus();
    list->setCurrentIndex(list->model()->index(0, 0));
    QTest::keyClick(list, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(f.window->currentPage()->id(), u"fit"_s, gripscope::test::longEnough_ms);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->navigator().fitSubject()->title, u"Inspection 2"_s,
                              gripscope::test::longEnough_ms);
}

void InspectPageTest::ratesAreSetByClickAndHold()
{
    WindowFixture f;
    f.window->showPage(u"inspect"_s);
    const auto* label = f.find<QLabel>("ratesLabel");
    const auto open = [&f] {
        f.click(f.find<QPushButton>("ratesButton"));
        auto* dialog = f.window->findChild<RatesDialog*>(u"ratesDialog"_s);
        return QTest::qWaitForWindowExposed(dialog, gripscope::test::longEnough_ms) ? dialog : nullptr;
    };
    const auto press = [](RatesDialog* dialog, QDialogButtonBox::StandardButton which) {
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(which), Qt::LeftButton);
    };
    RatesDialog* dialog = open();
    QVERIFY(dialog);
    auto* field = dialog->findChild<QDoubleSpinBox*>(u"falseRejectField"_s);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QLocale().toString(0.5));
    QTest::mouseClick(dialog->findChild<QRadioButton*>(u"confidenceButton"_s), Qt::LeftButton, {}, {8, 8});
    QTest::mouseClick(dialog->findChild<QCheckBox*>(u"earlyEndBox"_s), Qt::LeftButton, {}, {8, 8});
    press(dialog, QDialogButtonBox::Ok);
    QVERIFY(f.bench->rates().rates.falseReject != 0.005); // nothing before the reason
    f.sayWhy();
    QCOMPARE(f.bench->rates().rates.falseReject, 0.005);
    QCOMPARE(f.bench->rates().rates.wrongType, 0.001);
    QCOMPARE(f.bench->rates().rates.confidence, std::optional<double>(0.95));
    QVERIFY(!f.bench->rates().earlyEnd);
    QTRY_VERIFY(label->toolTip().contains(u"0.5"_s) || label->text().contains(u"0.5"_s));
    QTRY_VERIFY(!f.window->findChild<RatesDialog*>(u"ratesDialog"_s));
    // What is not accepted changes nothing.
    dialog = open();
    QVERIFY(dialog);
    press(dialog, QDialogButtonBox::RestoreDefaults);
    press(dialog, QDialogButtonBox::Cancel);
    QCOMPARE(f.bench->rates().rates.falseReject, 0.005);
}

void InspectPageTest::aDecidedSqueezeIsShortAndLeavesTheGripperArmed()
{
    WindowFixture f;
    f.window->showPage(u"inspect"_s);
    expectType(f, u"A"_s);
    auto* squeeze = f.find<QPushButton>("squeezeButton");
    QVERIFY(f.inRealTime([squeeze] { WindowFixture::clickWhenEnabled(squeeze); },
                         [&f] { return f.bench->inspection().counts().asExpected > 0; }));
    const auto& result = f.bench->inspection().result();
    QVERIFY(result);
    QCOMPARE(result->verdict.type, u"A"_s);
    QVERIFY(f.bench->connection().armed()); // the next part needs no arming
    // A machine too busy to look in time squeezes on, and that is all.
    if (result->earlyEnd)
        QVERIFY(result->seconds < 1);
    else
        QVERIFY(result->seconds > 0.9);
}

void InspectPageTest::whatWasShownSoFarIsCounted()
{
    WindowFixture f(true, unhurriedA);
    f.window->showPage(u"inspect"_s);
    const auto* shown = f.find<QLabel>("shownLabel");
    QVERIFY(shown->isHidden());
    expectType(f, u"A"_s);
    f.click(f.find<QPushButton>("inspectArmButton"));
    squeezeBySpace(f);
    // 0 of 1: at most 95 %.
    QTRY_VERIFY_WITH_TIMEOUT(shown->text().contains(u"0 of 1, so at most 95"_s),
                             gripscope::test::longEnough_ms);
    expectType(f, u"B"_s);
    QTRY_VERIFY(shown->isHidden()); // nothing was shown of that one
}

GRIPSCOPE_TEST(InspectPageTest)
#include "inspect_page_test.moc"
