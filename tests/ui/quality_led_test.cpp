// SPDX-License-Identifier: GPL-3.0-or-later
// What goes otherwise than planned while a study is led, by click and key.
#include "tests/support/test_registry.h"
#include "tests/ui/studying.h"
#include "ui/format/date_text.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/window_bars.h"
#include "ui/windows/question.h"

#include <algorithm>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::longEnough_ms;
using gripscope::test::unhurriedA;
using gripscope::test::WindowFixture;
using namespace gripscope::test::studying;

namespace {

/// Answers the question of this name, which has come up.
void answerStudyQuestion(WindowFixture& f, const char* name, const QString& reason)
{
    TextQuestion* question = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT(
        (question = f.window->findChild<TextQuestion*>(QLatin1StringView(name))) != nullptr, longEnough_ms);
    QTest::keyClick(question->field(), Qt::Key_Return); // without a reason nothing happens
    QVERIFY(question->isVisible());
    QTest::keyClicks(question->field(), reason);
    QTest::keyClick(question->field(), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(!f.window->findChild<TextQuestion*>(QLatin1StringView(name)), longEnough_ms);
    f.makeActive();
}

/// The window is built anew, as for another language; the program goes on.
void rebuildWindow(WindowFixture& f)
{
    f.window.reset();
    f.window = std::make_unique<MainWindow>(*f.bench);
    f.window->resize(1024, 640);
    f.window->show();
    f.makeActive();
    f.window->showPage(u"quality"_s);
}

/// Nothing in the jaws moves: no squeeze of it is valid.
void putInWhatIsStuck(WindowFixture& f)
{
    f.connectTo(u"virtual:?object=A&seed=5&speed=0&fault=stuck"_s);
    auto* arm = f.find<QPushButton>("studyArm");
    QTRY_VERIFY_WITH_TIMEOUT(arm->isVisible() && arm->isEnabled(), longEnough_ms);
    f.click(arm);
}

/// When the gauge study is due again is told in the status line, on Calibrate and in the list.
void isToldDue(WindowFixture& f, const QDate& due)
{
    const auto* line = f.window->findChild<StatusLine*>();
    const QString days = u"gauge study due in %1 days"_s.arg(QDate::currentDate().daysTo(due));
    QTRY_VERIFY2_WITH_TIMEOUT(line->text().contains(days), qPrintable(line->text()), longEnough_ms);
    const QString until = u"holds until "_s + dateText(due);
    f.window->showPage(u"calibrate"_s);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("studiesStatus")->text().contains(u"Gauge study: "_s + until),
                             longEnough_ms);
    f.window->showPage(u"quality"_s);
    f.clickWhenEnabled(f.find<QPushButton>("studyOutcomeBack"));
    const auto isListed = [&f, &until] {
        const auto standings = f.window->findChildren<QLabel*>(u"studyStanding"_s);
        return std::ranges::any_of(standings,
                                   [&](const QLabel* one) { return one->text().startsWith(until); });
    };
    QTRY_VERIFY_WITH_TIMEOUT(isListed(), longEnough_ms);
}

} // namespace

class QualityLedTest : public QObject {
    Q_OBJECT
private slots:
    void aPartIsLeftOutWithAReason()
    {
        WindowFixture f(false, unhurriedA);
        beginSmallStudy(f);
        squeezeNext(f);
        const QString part = nextPart(f);
        f.clickWhenEnabled(f.find<QPushButton>("studySkip"));
        answerStudyQuestion(f, "skipQuestion", u"it broke"_s);
        QTRY_COMPARE_WITH_TIMEOUT(study(f).progress().skipped, std::size_t(1), longEnough_ms);
        QTRY_VERIFY(f.find<QLabel>("studyLast")->text().contains(u"Part %1 was left out"_s.arg(part)));
        QVERIFY(f.find<QLabel>("studyProgress")->text().contains(u"Left out: 1"_s));
        QCOMPARE(study(f).study()->measurements.back().measured.reasons.front().describe(), u"it broke"_s);
        QCOMPARE(*study(f).nextRow(), std::size_t(2));
        QTest::keyClick(f.window->focusWidget(), Qt::Key_Z, Qt::ControlModifier); // it is found again
        QTRY_COMPARE_WITH_TIMEOUT(*study(f).nextRow(), std::size_t(1), longEnough_ms);
        QCOMPARE(nextPart(f), part);
    }
    void aStudyEndsEarlyWithWhatWasMeasured()
    {
        WindowFixture f(false, unhurriedA);
        f.bench->settings().set(setting::gaugeMonths, 6.0);
        beginSmallStudy(f);
        for (int i = 0; i < 7; ++i)
            squeezeNext(f);
        f.clickWhenEnabled(f.find<QPushButton>("studyEnd"));
        answerStudyQuestion(f, "endStudyQuestion", u"the shift is over"_s);
        const QString verdict = shownVerdict(f);
        QVERIFY2(verdict.contains(u"kinds of"_s) || verdict.contains(u"apart"_s), qPrintable(verdict));
        QCOMPARE((*study(f).result())->left, std::size_t(5));
        QVERIFY(!(*study(f).result())->gauge()->study.balanced);
        QCOMPARE(study(f).study()->record.endReason, u"the shift is over"_s);
        isToldDue(f, QDate::currentDate().addMonths(6));
    }
    void aBadSqueezeIsToldAndMadeAgain()
    {
        WindowFixture f(false, unhurriedA);
        beginSmallStudy(f);
        const QString part = nextPart(f);
        putInWhatIsStuck(f);
        pressSpaceOn(f, "studyAct");
        auto* last = f.find<QLabel>("studyLast");
        QTRY_VERIFY_WITH_TIMEOUT(last->text().startsWith(u"That squeeze does not count"_s), longEnough_ms);
        QVERIFY(!study(f).refusal().empty());
        QCOMPARE(study(f).progress().done, std::size_t(0));
        QVERIFY(f.find<QLabel>("studyPart")->text().contains(part));
        squeezeNext(f); // the same part again, as it should be
        QCOMPARE(study(f).progress().done, std::size_t(1));
        QVERIFY(f.find<QLabel>("studyProgress")->text().contains(u"Repeated: 1"_s));
        QVERIFY(!last->text().contains(u"does not count"_s));
    }
    void theLastSqueezeIsTakenBackInAWindowBuiltAnew()
    {
        WindowFixture f(false, unhurriedA);
        beginSmallStudy(f);
        squeezeNext(f);
        squeezeNext(f);
        rebuildWindow(f);
        QTRY_VERIFY(f.find<QLabel>("studyPart")->isVisible());
        QVERIFY(f.find<QLabel>("studyProgress")->text().contains(u"3 of 12"_s));
        f.clickWhenEnabled(f.find<QPushButton>("studyUndo"));
        QTRY_COMPARE_WITH_TIMEOUT(*study(f).nextRow(), std::size_t(1), longEnough_ms);
        QVERIFY(!f.window->findChild<TextQuestion*>()); // nobody asks why
        QTRY_VERIFY(f.find<QLabel>("studyLast")->text().contains(u"taken back"_s));
        squeezeNext(f);
        QCOMPARE(study(f).progress().done, std::size_t(2));
    }
    /// The program ended and was started again: the last squeeze of before is still the last one.
    void theLastSqueezeOfARunBeforeIsTakenBack()
    {
        WindowFixture f(false, unhurriedA);
        beginSmallStudy(f);
        squeezeNext(f);
        startAgain(f);
        goOnWithStudy(f);
        QTRY_VERIFY(f.find<QPushButton>("studyUndo")->isVisible());
        f.clickWhenEnabled(f.find<QPushButton>("studyUndo"));
        QTRY_COMPARE_WITH_TIMEOUT(*study(f).nextRow(), std::size_t(0), longEnough_ms);
        QCOMPARE(study(f).study()->measurements.size(), std::size_t(1)); // on record
    }
};

GRIPSCOPE_TEST(QualityLedTest)
#include "quality_led_test.moc"
