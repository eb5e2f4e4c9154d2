// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_record.h"
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/format/reference_words.h"
#include "ui/models/calibration_models.h"
#include "ui/pages/calibrate/calibrate_parts.h"
#include "ui/shell/window_bars.h"

#include <QAbstractItemModelTester>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

ReferenceCheckRecord exampleCheck(CheckVerdict verdict)
{
    ReferenceCheckRecord check;
    check.reference.name = u"Spring S-12"_s;
    check.reference.stated[2] = ReferenceQuantity{10000, 20, 300};
    check.verdict = verdict;
    check.made = QDateTime::currentDateTimeUtc().addSecs(-3 * 3600 - 60);
    check.operatorName = u"Ada"_s;
    if (verdict != CheckVerdict::NotValid)
        check.measured[2] = MeasuredQuantity{10030, 20};
    return check;
}

} // namespace

/// The check on a reference spring, from stating it to the row in the library and what follows for parts; can
/// A of the virtual gripper is the spring.
class CalibrateCheckTest : public QObject {
    Q_OBJECT
    static void showChecks(WindowFixture& f)
    {
        f.window->showPage(u"calibrate"_s);
        auto* tabs = f.find<QTabBar>("calibrateTabs");
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(1).center());
    }
    static void stateSpring(WindowFixture& f, double stiffness)
    {
        f.click(f.find<QPushButton>("referenceEdit"));
        auto* dialog = f.find<ReferenceDialog>("referenceDialog");
        auto* keep = dialog->findChild<QPushButton*>(u"referenceKeep"_s);
        QVERIFY(!keep->isEnabled());
        QTest::keyClicks(dialog->findChild<QLineEdit*>(u"referenceName"_s), u"Spring S-12"_s);
        dialog->findChild<QDoubleSpinBox*>(u"referenceValue2"_s)->setValue(stiffness);
        dialog->findChild<QDoubleSpinBox*>(u"referenceTolerance2"_s)->setValue(10);
        QTRY_VERIFY(keep->isEnabled());
        f.click(keep);
        f.sayWhy();
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().calibration().reference(), longEnough_ms);
    }
    static std::vector<ReferenceCheckRecord> stored(WindowFixture& f)
    {
        using Checks = std::vector<ReferenceCheckRecord>;
        std::optional<Checks> found;
        f.bench->background().ask<Checks>(
            nullptr, [](Library& library) { return library.referenceChecks(u"VG-5"_s, 9); },
            [&](Expected<Checks> checks) { found = checks.value(); });
        if (!QTest::qWaitFor([&] { return found.has_value(); }, longEnough_ms))
            qFatal("the library did not answer");
        return *found;
    }
    static QString statusLine(WindowFixture& f) { return f.window->findChild<StatusLine*>()->text(); }

private slots:
    void aPersonStatesASpringArmsAndChecks()
    {
        WindowFixture f(false, gripscope::test::unhurriedA);
        showChecks(f);
        auto* act = f.find<QPushButton>("checkAct");
        QVERIFY(!act->isEnabled()); // on what?
        stateSpring(f, 9990);
        auto* standing = f.find<QLabel>("checkStanding");
        QTRY_VERIFY_WITH_TIMEOUT(standing->text().startsWith(u"Due"_s), longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(statusLine(f).contains(u"spring check due"_s), longEnough_ms);
        QCOMPARE(act->text(), u"Arm"_s);
        f.click(act);
        QTRY_VERIFY_WITH_TIMEOUT(act->text().startsWith(u"Check now"_s), longEnough_ms);
        QTest::keyClick(f.page(u"calibrate"_s), Qt::Key_Space);
        QTRY_COMPARE_WITH_TIMEOUT(f.find<QTableView>("checkList")->model()->rowCount(), 1, longEnough_ms);
        const auto checks = stored(f);
        QCOMPARE(checks.size(), std::size_t(1));
        QVERIFY2(checks[0].verdict == CheckVerdict::Passed,
                 qPrintable(checks[0].obstacle + standing->text() + f.find<QLabel>("checkOutcome")->text()));
        QCOMPARE(checks[0].operatorName, u"Mai"_s);
        QVERIFY(standing->text().startsWith(u"Passed"_s));
        QVERIFY2(f.find<QLabel>("checkOutcome")->text().contains(u"En "_s),
                 qPrintable(f.find<QLabel>("checkOutcome")->text()));
        QTRY_VERIFY_WITH_TIMEOUT(statusLine(f).contains(u"spring check this hour"_s), longEnough_ms);
        QVERIFY(!f.bench->squeezing());
    }

    void aFailedCheckIsToldWhereverTheGripperIsConnected()
    {
        WindowFixture f(false, gripscope::test::unhurriedA);
        showChecks(f);
        stateSpring(f, 8000);
        auto* act = f.find<QPushButton>("checkAct");
        f.click(act);
        QTRY_VERIFY_WITH_TIMEOUT(act->text().startsWith(u"Check now"_s), longEnough_ms);
        f.click(act);
        auto* standing = f.find<QLabel>("checkStanding");
        QTRY_VERIFY2_WITH_TIMEOUT(standing->text().startsWith(u"Failed"_s), qPrintable(standing->text()),
                                  longEnough_ms);
        QVERIFY(stored(f).at(0).verdict == CheckVerdict::Failed);
        f.connectTo(u"virtual:?object=A&seed=5"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.window->message().contains(u"reference spring"_s), longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(statusLine(f).contains(u"spring check failed"_s), longEnough_ms);
    }

    void spaceStaysWithTheCheck()
    {
        WindowFixture f(false, gripscope::test::unhurriedA);
        showChecks(f);
        stateSpring(f, 9990);
        QTRY_VERIFY_WITH_TIMEOUT(f.window->message().contains(u"reference spring"_s), longEnough_ms);
        auto* act = f.find<QPushButton>("checkAct");
        f.click(act);
        QTRY_VERIFY_WITH_TIMEOUT(act->text().startsWith(u"Check now"_s), longEnough_ms);
        f.click(act);
        const auto* list = f.find<QTableView>("checkList")->model();
        QTRY_COMPARE_WITH_TIMEOUT(list->rowCount(), 1, longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(act->text().startsWith(u"Check again"_s), longEnough_ms);
        // What it was due for is done, and nobody reads that it was never made.
        QTRY_VERIFY_WITH_TIMEOUT(!f.window->message().contains(u"reference spring"_s), longEnough_ms);
        // While it was stored its button was off; the next Space is still for the next check.
        QTRY_COMPARE_WITH_TIMEOUT(f.window->focusWidget(), static_cast<QWidget*>(act), longEnough_ms);
        QTest::keyClick(f.window->focusWidget(), Qt::Key_Space);
        QTRY_COMPARE_WITH_TIMEOUT(list->rowCount(), 2, longEnough_ms);
        QCOMPARE(f.window->currentPage()->id(), u"calibrate"_s);
    }

    void anotherTabOrPageStopsTheCheck()
    {
        WindowFixture f(false);
        showChecks(f);
        stateSpring(f, 9990);
        auto* act = f.find<QPushButton>("checkAct");
        f.click(act);
        QTRY_VERIFY_WITH_TIMEOUT(act->text().startsWith(u"Check now"_s), longEnough_ms);
        f.click(act);
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->squeezing(), longEnough_ms);
        f.find<QTabBar>("calibrateTabs")->setCurrentIndex(0);
        QTRY_VERIFY_WITH_TIMEOUT(!f.bench->squeezing(), longEnough_ms);
        QVERIFY(stored(f).empty());
    }

    void howItStandsIsSaidInWords()
    {
        const QDateTime now = QDateTime::currentDateTimeUtc();
        const auto with = [](CheckVerdict verdict) {
            ReferenceStanding standing;
            standing.reference = exampleCheck(verdict).reference;
            standing.last = exampleCheck(verdict);
            return std::optional(standing);
        };
        QCOMPARE(ReferenceWords::brief(with(CheckVerdict::Passed), now), u"spring check 3 h ago"_s);
        QCOMPARE(ReferenceWords::brief(with(CheckVerdict::Failed), now), u"spring check failed"_s);
        QCOMPARE(ReferenceWords::brief(with(CheckVerdict::Passed), now.addDays(3)), u"spring check due"_s);
        QVERIFY(ReferenceWords::brief(std::nullopt, now).isEmpty());
        // An error of 0.3 % where 0.56 % are uncertain; one of 2.9 % is within the tolerance but surprising.
        ReferenceCheckRecord check = exampleCheck(CheckVerdict::Passed);
        QCOMPARE(ReferenceWords::error(check, 2), u"+0.3 %, En 0.5"_s);
        QVERIFY(ReferenceWords::outcome(check).startsWith(u"Passed.\n"_s));
        check.measured[2]->value = 10290;
        QVERIFY(ReferenceWords::outcome(check).contains(u"Calibrate soon"_s));
        QCOMPARE(ReferenceWords::error(check, 0), u"–"_s);
    }

    void theModelKeepsTheRules()
    {
        ReferenceCheckModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setChecks({exampleCheck(CheckVerdict::Passed), exampleCheck(CheckVerdict::NotValid)});
        QCOMPARE(model.rowCount(), 2);
        QVERIFY(model.says(ReferenceCheckModel::Column::Stiffness));
        QVERIFY(!model.says(ReferenceCheckModel::Column::Mass));
        QCOMPARE(model.index(1, int(ReferenceCheckModel::Column::Stiffness)).data().toString(), u"–"_s);
        model.setChecks({});
    }
};

GRIPSCOPE_TEST(CalibrateCheckTest)
#include "calibrate_check_test.moc"
