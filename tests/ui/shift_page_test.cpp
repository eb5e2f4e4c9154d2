// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/gripper_adjustment.h"
#include "tests/support/test_registry.h"
#include "tests/ui/shifting.h"
#include "tests/ui/studying.h"
#include "ui/charts/course_plot.h"
#include "ui/charts/interval_plot.h"
#include "ui/pages/quality/shift/shift_views.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::longEnough_ms;
using gripscope::test::unhurriedA;
using gripscope::test::WindowFixture;
using namespace gripscope::test::shifting;
using ShiftState = StudySession::State;

/// What moved, and types on another gripper, by click and key.
class ShiftPageTest : public QObject {
    Q_OBJECT
private slots:
    void withoutInspectionsTheViewSaysSo();
    void whatMovedIsShownWithTheWayToGo();
    void aTransferIsLedThroughTheEndOfTheProgramToItsAcceptance();
    void tooFewAWrongPartAndGivingUp();
};

void ShiftPageTest::withoutInspectionsTheViewSaysSo()
{
    WindowFixture f(true, unhurriedA);
    openView(f, "openDrift");
    auto* cause = f.find<QLabel>("driftCause");
    QTRY_VERIFY_WITH_TIMEOUT(cause->isVisible() && cause->text().contains(u"No inspection"_s), longEnough_ms);
    QVERIFY(!f.find<CoursePlot>("driftCourse")->isVisible());
    auto* go = f.find<QPushButton>("driftGo");
    QVERIFY(go->isVisible() && go->text().contains(u"Inspect"_s));
    f.click(f.find<QPushButton>("driftBack"));
    QTRY_VERIFY(f.find<QPushButton>("openDrift")->isVisible());
}

void ShiftPageTest::whatMovedIsShownWithTheWayToGo()
{
    WindowFixture f(true, unhurriedA);
    constexpr int asEnrolled = 6, all = 22;
    judgeMovedParts(f, all, asEnrolled);
    openView(f, "openDrift");
    const auto* view = f.window->findChild<DriftView*>();
    QTRY_VERIFY_WITH_TIMEOUT(view->look().has_value(), longEnough_ms);
    QVERIFY(f.find<QLabel>("driftCause")->text().contains(u"product or the gripper"_s)); // one type only
    QVERIFY(f.find<QLabel>("driftWords")->text().contains(u"A has moved"_s));
    QVERIFY(f.find<QLabel>("driftSince")->text().contains(u"inspection"_s));
    QVERIFY(view->look()->change);
    QVERIFY(std::abs(view->look()->change->before - asEnrolled) <= 2);
    const CourseChart& course = f.find<CoursePlot>("driftCourse")->chart();
    QCOMPARE(course.points.size(), std::size_t(all));
    QVERIFY(course.change && course.change->value > 15);
    QCOMPARE(f.find<IntervalPlot>("driftShifts")->chart().rows.size(), std::size_t(1));
    auto* table = f.find<QTableWidget>("driftTable");
    QCOMPARE(table->rowCount(), 1);
    QVERIFY(table->item(0, 2)->text().contains(u" to "_s));
    auto* newest = f.find<QComboBox>("driftNewest");
    newest->setFocus();
    QTest::keyClick(newest, Qt::Key_Up); // the newest 100
    QTRY_VERIFY(newest->currentIndex() == 0);
    auto* go = f.find<QPushButton>("driftGo");
    f.clickWhenEnabled(go);
    QTRY_VERIFY(f.page(u"inspect"_s)->isVisible());
}

void ShiftPageTest::aTransferIsLedThroughTheEndOfTheProgramToItsAcceptance()
{
    WindowFixture f(true, unhurriedA);
    beginTransfer(f, 3);
    QVERIFY(f.find<QLabel>("transferTrial")->text().contains(u"1 of 3"_s));
    auto* finish = f.find<QPushButton>("transferFinish");
    QVERIFY(!finish->isEnabled());
    squeezeOne(f);
    squeezeOne(f);
    QVERIFY(isLookedAt(f, 2));
    QVERIFY(!finish->isEnabled()); // one of each says nothing
    gripscope::test::studying::startAgain(f);
    f.window->showPage(u"quality"_s);
    QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<QPushButton*>(u"goOnWithStudy"_s), longEnough_ms);
    f.clickWhenEnabled(f.find<QPushButton>("goOnWithStudy"));
    QTRY_VERIFY_WITH_TIMEOUT(transferStudy(f).state() == ShiftState::Waiting, longEnough_ms);
    QTRY_VERIFY(f.find<QLabel>("transferPart")->isVisible());
    while (transferStudy(f).nextRow())
        squeezeOne(f);
    QVERIFY(isLookedAt(f, 6));
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QPushButton>("transferFinish")->isEnabled(), longEnough_ms);
    f.clickWhenEnabled(f.find<QPushButton>("transferFinish"));
    auto* accept = f.find<QPushButton>("transferAccept");
    QTRY_VERIFY_WITH_TIMEOUT(accept->isVisible() && accept->isEnabled(), longEnough_ms);
    QVERIFY(f.find<QLabel>("transferCheck")->text().contains(u"Residual check"_s));
    QCOMPARE(f.find<IntervalPlot>("transferPlot")->chart().rows.size(), std::size_t(5));
    QCOMPARE(f.find<QTableWidget>("transferTable")->rowCount(), 3);
    f.click(accept);
    f.sayWhy(u"second line"_s);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("transferStanding")->text().contains(u"In force"_s),
                             longEnough_ms);
    QVERIFY(!accept->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->inspection().adjustment().has_value(), longEnough_ms);
    QCOMPARE(f.bench->inspection().adjustment()->record.adjustment.types, (QStringList{u"A"_s, u"C"_s}));
    f.window->showPage(u"inspect"_s);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("adjustmentLabel")->isVisible(), longEnough_ms);
    f.window->showPage(u"quality"_s);
    f.clickWhenEnabled(f.find<QPushButton>("transferOutcomeBack"));
    openView(f, "beginTransfer");
}

void ShiftPageTest::tooFewAWrongPartAndGivingUp()
{
    WindowFixture f(true, unhurriedA);
    beginTransfer(f, 2);
    squeezeOne(f);
    f.clickWhenEnabled(f.find<QPushButton>("transferUndo"));
    QTRY_COMPARE_WITH_TIMEOUT(transferStudy(f).progress().done, std::size_t(0), longEnough_ms);
    QVERIFY(f.find<QLabel>("transferLast")->text().contains(u"taken back"_s));
    f.clickWhenEnabled(f.find<QPushButton>("transferSkip"));
    answer(f, "skipQuestion", u"no part of it here"_s);
    QTRY_COMPARE_WITH_TIMEOUT(transferStudy(f).progress().skipped, std::size_t(1), longEnough_ms);
    while (transferStudy(f).nextRow())
        squeezeOne(f);
    QVERIFY(isLookedAt(f, 3));
    QVERIFY(f.find<QLabel>("transferAdvice")->text().contains(u"Too few squeezes"_s));
    QVERIFY(!f.find<QPushButton>("transferFinish")->isEnabled());
    f.clickWhenEnabled(f.find<QPushButton>("transferGiveUp"));
    answer(f, "giveUpQuestion", u"the parts are gone"_s);
    auto* verdict = f.find<QLabel>("transferVerdict");
    QTRY_VERIFY_WITH_TIMEOUT(verdict->isVisible() && verdict->text().contains(u"the parts are gone"_s),
                             longEnough_ms);
    QVERIFY(!f.find<QPushButton>("transferAccept")->isVisible());
    f.click(f.find<QPushButton>("transferOutcomeBack"));
    QTRY_VERIFY(f.find<QPushButton>("beginTransfer")->isVisible());
    QVERIFY(!f.bench->inspection().adjustment());
}

GRIPSCOPE_TEST(ShiftPageTest)
#include "shift_page_test.moc"
