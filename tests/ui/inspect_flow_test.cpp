// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_button.h"
#include "tests/support/test_registry.h"
#include "tests/ui/inspecting.h"
#include "ui/pages/inspect/inspect_batch.h"
#include "ui/settings/values/settings.h"
#include "ui/sound/sound_player.h"
#include "ui/widgets/outcome_view.h"
#include "ui/windows/scan_reader.h"
#include "ui/windows/window_guard.h"

#include <QCompleter>
#include <QLabel>
#include <QSignalSpy>
#include <QSpinBox>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;
using namespace gripscope::test::inspecting;

/// A shift on the Inspect page: scanner, the gripper's button, batches and sounds, from key to row.
class InspectFlowTest : public QObject {
    Q_OBJECT
private slots:
    void aScannedCodeChoosesTheTypeAndSqueezesNothing();
    void aScannedNameWithASpaceInItSqueezesNothing();
    void anUnknownCodeSaysSoAndChangesNothing();
    void typingNarrowsTheListAndNeedsNoWholeName();
    void aScanBeforeArmingArmsNothing();
    void theGrippersButtonSqueezesHereAndArmedOnly();
    void spaceAloneIsEnoughForTheNextPart();
    void aBatchCountsPartsAsExpectedUntilItIsWhole();
    void aBatchIsEndedByAPerson();
    void aBatchAndItsTypeGoOnAfterARestart();
    void eachOutcomeIsHeardUnlessSwitchedOff();
    void whatIsNotValidIsNeitherGoodNorBad();
};

void InspectFlowTest::aScannedCodeChoosesTheTypeAndSqueezesNothing()
{
    Armed armed;
    WindowFixture& f = armed.f;
    armed.setCode(u"B"_s, u"4006381333931"_s);
    for (const char* name : {"squeezeButton", "inspectionList", "ratesButton"}) {
        f.find<TypeChooser>("expectedCombo")->setExpected({});
        f.find<QWidget>(name)->setFocus();
        scan(f, u"4006381333931"_s);
        QCOMPARE(armed.expected(), u"B"_s);
        // Space is enough for the next part, wherever the focus was.
        QCOMPARE(focusOf(f), f.find<QPushButton>("squeezeButton"));
    }
    QTest::qWait(3 * ScanReader::longestGap_ms);
    QVERIFY(!armed.squeezed());
    squeezeBySpace(f);
    QVERIFY(f.find<VerdictPanel>("verdictPanel")->outcome() == InspectionOutcome::OtherType); // it is an A
    QCOMPARE(f.bench->inspection().result()->expectedType, u"B"_s);
}

void InspectFlowTest::aScannedNameWithASpaceInItSqueezesNothing()
{
    Armed armed;
    WindowFixture& f = armed.f;
    armed.setCode(u"B"_s, u"CAN 330 ML"_s);
    f.find<QPushButton>("squeezeButton")->setFocus();
    scan(f, u" CAN 330 ML "_s); // spaces before, within and behind
    QCOMPARE(armed.expected(), u"B"_s);
    QTest::keyClick(focusOf(f), Qt::Key_Return); // some scanners end with two
    QTest::qWait(3 * ScanReader::longestGap_ms);
    QVERIFY(!armed.squeezed());
}

void InspectFlowTest::anUnknownCodeSaysSoAndChangesNothing()
{
    Armed armed;
    WindowFixture& f = armed.f;
    expectType(f, u"A"_s);
    scan(f, u"9999999999994"_s);
    QCOMPARE(armed.expected(), u"A"_s);
    const auto* verdict = f.find<VerdictPanel>("verdictPanel");
    QVERIFY(verdict->headline().contains(u"9999999999994"_s));
    QVERIFY(verdict->accessibleDescription().contains(u"A is expected"_s));
    QVERIFY(!armed.squeezed());
    squeezeBySpace(f); // and work goes on
    QVERIFY(verdict->outcome() == InspectionOutcome::AsExpected);
}

void InspectFlowTest::typingNarrowsTheListAndNeedsNoWholeName()
{
    WindowFixture f;
    f.window->showPage(u"inspect"_s);
    bool done = false;
    f.bench->background().ask<void>(
        nullptr,
        [](Library& library) {
            const auto found = library.findType(u"C"_s);
            return library.renameType((*found)->id, u"Cola 330 ml"_s, {u"Mai"_s, u"a test"_s})
                .map([](const auto&) {});
        },
        [&done](const Expected<void>& answer) { done = answer.has_value(); });
    QTRY_VERIFY_WITH_TIMEOUT(done, gripscope::test::longEnough_ms);
    f.bench->tellLibraryChanged();
    auto* chooser = f.find<TypeChooser>("expectedCombo");
    QTRY_VERIFY_WITH_TIMEOUT(chooser->findData(u"Cola 330 ml"_s) > 0, gripscope::test::longEnough_ms);
    chooser->setFocus();
    chooser->lineEdit()->selectAll();
    QTest::keyClicks(chooser, u"330"_s);
    QCOMPARE(chooser->completer()->completionCount(), 1);
    QTest::keyClick(chooser, Qt::Key_Return);
    QCOMPARE(chooser->expected(), u"Cola 330 ml"_s);
    QCOMPARE(chooser->currentText(), u"Cola 330 ml"_s);
    // What is no type is said, and the field is as it was.
    chooser->setFocus();
    chooser->lineEdit()->selectAll();
    QTest::keyClicks(chooser, u"Fanta"_s);
    QTest::keyClick(chooser, Qt::Key_Return);
    QCOMPARE(chooser->currentText(), u"Cola 330 ml"_s);
    QVERIFY(f.find<VerdictPanel>("verdictPanel")->headline().contains(u"Fanta"_s));
}

void InspectFlowTest::aScanBeforeArmingArmsNothing()
{
    WindowFixture f;
    f.window->showPage(u"inspect"_s);
    auto* arm = f.find<QPushButton>("inspectArmButton");
    QTRY_VERIFY_WITH_TIMEOUT(arm->isEnabled(), gripscope::test::longEnough_ms);
    arm->setFocus();
    scan(f, u" B"_s);
    QTest::qWait(3 * ScanReader::longestGap_ms);
    QCOMPARE(f.find<TypeChooser>("expectedCombo")->expected(), u"B"_s);
    QVERIFY(!f.bench->connection().armed());
    // A person's Space on the button does arm.
    arm->setFocus();
    QTest::keyClick(arm, Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
}

void InspectFlowTest::theGrippersButtonSqueezesHereAndArmedOnly()
{
    WindowFixture f;
    const auto press = [&f] {
        virtual_button::press();
        QTest::qWait(300); // down and up again, and what follows from it has begun
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->inspection().state() == InspectSession::State::Ready,
                                 gripscope::test::longEnough_ms);
    };
    f.window->showPage(u"inspect"_s);
    press();
    QCOMPARE(f.bench->inspection().counts().total, 0);
    QVERIFY(!f.bench->connection().armed());
    QVERIFY(f.find<VerdictPanel>("verdictPanel")->accessibleDescription().contains(u"armed"_s));
    f.click(f.find<QPushButton>("inspectArmButton"));
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QPushButton>("squeezeButton")->isEnabled(),
                             gripscope::test::longEnough_ms);
    f.window->showPage(u"live"_s); // on another page it is nobody's
    press();
    QCOMPARE(f.bench->inspection().counts().total, 0);
    f.window->showPage(u"inspect"_s);
    press();
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().counts().total, 1, gripscope::test::longEnough_ms);
    press();
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().counts().total, 2, gripscope::test::longEnough_ms);
    f.click(f.find<QPushButton>("ratesButton")); // a dialog has a person's eyes
    QTRY_VERIFY(WindowGuard::asking());
    press();
    QCOMPARE(f.bench->inspection().counts().total, 2);
}

void InspectFlowTest::spaceAloneIsEnoughForTheNextPart()
{
    Armed armed;
    WindowFixture& f = armed.f;
    // Whatever was clicked in between: Space is for the next part, and presses nothing else.
    squeezeBySpace(f);
    f.click(f.find<QPushButton>("soundButton"));
    f.click(f.find<QPushButton>("soundButton"));
    squeezeBySpace(f);
    f.click(f.find<QPushButton>("ratesButton"));
    QTRY_VERIFY(WindowGuard::asking());
    QTest::keyClick(WindowGuard::asking(), Qt::Key_Return);
    QTRY_VERIFY(!WindowGuard::asking());
    squeezeBySpace(f);
    // Held down it is one press.
    const qint64 before = f.bench->inspection().counts().total;
    QWidget* focus = focusOf(f);
    QTest::keyPress(focus, Qt::Key_Space);
    for (int i = 0; i < 5; ++i) {
        QKeyEvent held(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, u" "_s, true);
        QCoreApplication::sendEvent(focusOf(f), &held);
        QTest::qWait(30);
    }
    QTest::keyRelease(focusOf(f), Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().counts().total, before + 1,
                              gripscope::test::longEnough_ms);
    QTest::qWait(300);
    QCOMPARE(f.bench->inspection().counts().total, before + 1);
    // After Stop it is armed again from the header, and Space is enough again.
    QTest::keyClick(f.window.get(), Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(!f.bench->connection().armed(), gripscope::test::longEnough_ms);
    f.bench->arm();
    squeezeBySpace(f);
}

namespace {

/// Begins a batch by click and keys.
void beginBatch(WindowFixture& f, const QString& name, int target)
{
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QPushButton>("beginBatchButton")->isEnabled(),
                             gripscope::test::longEnough_ms);
    f.click(f.find<QPushButton>("beginBatchButton"));
    auto* dialog = f.window->findChild<BatchDialog*>();
    QVERIFY(dialog);
    QVERIFY(QTest::qWaitForWindowExposed(dialog, gripscope::test::longEnough_ms));
    auto* accept = dialog->findChild<QPushButton*>(u"batchAccept"_s);
    QVERIFY(!accept->isEnabled()); // it needs a name
    auto* field = dialog->findChild<QLineEdit*>(u"batchNameField"_s);
    QTest::keyClicks(field, name);
    QTest::keyClick(field, Qt::Key_Return); // as a scanner ends: on to the number of parts
    QVERIFY(dialog->isVisible());
    auto* wanted = dialog->findChild<QSpinBox*>(u"batchTargetField"_s);
    QVERIFY(wanted->hasFocus());
    QTest::keyClicks(wanted, QString::number(target));
    QTest::mouseClick(accept, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QPushButton>("endBatchButton")->isVisible(),
                             gripscope::test::longEnough_ms);
}

} // namespace

void InspectFlowTest::aBatchCountsPartsAsExpectedUntilItIsWhole()
{
    Armed armed;
    WindowFixture& f = armed.f;
    QSignalSpy heard(f.find<SoundPlayer>("inspectSounds"), &SoundPlayer::playing);
    expectType(f, u"A"_s);
    beginBatch(f, u"4711"_s, 2);
    QCOMPARE(f.find<QLabel>("batchCount")->text(), u"0 of 2"_s);
    squeezeBySpace(f);
    QTRY_COMPARE_WITH_TIMEOUT(f.find<QLabel>("batchCount")->text(), u"1 of 2"_s,
                              gripscope::test::longEnough_ms);
    expectType(f, u"B"_s); // an A is another type now: it does not count
    squeezeBySpace(f);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("batchYield")->text().startsWith(u"50"_s),
                             gripscope::test::longEnough_ms);
    QCOMPARE(f.find<QLabel>("batchCount")->text(), u"1 of 2"_s);
    expectType(f, u"A"_s);
    squeezeBySpace(f);
    QTRY_COMPARE_WITH_TIMEOUT(f.find<QLabel>("batchName")->text(), u"Batch 4711 is complete"_s,
                              gripscope::test::longEnough_ms);
    QVERIFY(f.find<QPushButton>("beginBatchButton")->isVisible());
    const auto whole = std::count_if(heard.begin(), heard.end(), [](const QList<QVariant>& call) {
        return call.at(0).value<Sound>() == Sound::BatchWhole;
    });
    QCOMPARE(whole, 1);
    std::optional<std::vector<BatchRecord>> stored;
    f.bench->background().ask<std::vector<BatchRecord>>(
        nullptr, [](Library& library) { return library.batches(10); },
        [&stored](const Expected<std::vector<BatchRecord>>& found) { stored = found.value(); });
    QTRY_VERIFY_WITH_TIMEOUT(stored, gripscope::test::longEnough_ms);
    QCOMPARE(stored->size(), std::size_t(1));
    QCOMPARE(stored->front().counts.total, 3);
    QCOMPARE(stored->front().operatorName, u"Mai"_s);
    QVERIFY(stored->front().ended);
}

void InspectFlowTest::aBatchIsEndedByAPerson()
{
    WindowFixture f;
    f.window->showPage(u"inspect"_s);
    beginBatch(f, u"4711"_s, 400);
    f.click(f.find<QPushButton>("endBatchButton"));
    QTRY_VERIFY(f.window->findChild<QPushButton*>(u"endBatchAccept"_s));
    QVERIFY(f.bench->inspection().batch() && !f.bench->inspection().batch()->ended); // it asks first
    QTest::mouseClick(f.window->findChild<QPushButton*>(u"endBatchAccept"_s), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(f.find<QLabel>("batchName")->text(), u"Batch 4711 was ended"_s,
                              gripscope::test::longEnough_ms);
    QVERIFY(f.bench->inspection().batch()->ended);
}

void InspectFlowTest::aBatchAndItsTypeGoOnAfterARestart()
{
    Armed armed;
    WindowFixture& f = armed.f;
    expectType(f, u"A"_s);
    beginBatch(f, u"4711"_s, 400);
    squeezeBySpace(f);
    QString library;
    f.bench->background().ask<QString>(
        nullptr, [](Library& open) -> Expected<QString> { return open.file(); },
        [&library](const Expected<QString>& file) { library = *file; });
    QTRY_VERIFY_WITH_TIMEOUT(!library.isEmpty(), gripscope::test::longEnough_ms);
    f.window.reset();
    f.bench.reset();
    Workbench bench(library);
    MainWindow window(bench);
    window.show();
    const auto* count = window.findChild<QLabel*>(u"batchCount"_s);
    QTRY_COMPARE_WITH_TIMEOUT(count->text(), u"1 of 400"_s, gripscope::test::longEnough_ms);
    QCOMPARE(window.findChild<TypeChooser*>(u"expectedCombo"_s)->expected(), u"A"_s);
}

void InspectFlowTest::eachOutcomeIsHeardUnlessSwitchedOff()
{
    Armed armed;
    WindowFixture& f = armed.f;
    QSignalSpy heard(f.find<SoundPlayer>("inspectSounds"), &SoundPlayer::playing);
    const auto last = [&heard] { return heard.last().at(0).value<Sound>(); };
    expectType(f, u"A"_s);
    squeezeBySpace(f);
    QCOMPARE(heard.size(), 1); // once, though the page shows it many times
    QVERIFY(last() == Sound::AsExpected);
    expectType(f, u"C"_s);
    squeezeBySpace(f);
    QVERIFY(last() == Sound::OtherType);
    auto* button = f.find<QPushButton>("soundButton");
    QVERIFY(button->isChecked());
    QCOMPARE(button->accessibleName(), u"Sound on"_s);
    f.click(button);
    QCOMPARE(button->accessibleName(), u"Sound off"_s);
    QVERIFY(!f.bench->settings().get(setting::soundOnVerdict));
    const auto before = heard.size();
    squeezeBySpace(f);
    QCOMPARE(heard.size(), before);
}

void InspectFlowTest::whatIsNotValidIsNeitherGoodNorBad()
{
    Armed armed(u"virtual:?object=A&seed=8&fault=loss:0.35&speed=0"_s);
    WindowFixture& f = armed.f;
    expectType(f, u"A"_s);
    beginBatch(f, u"4711"_s, 5);
    f.bench->inspection().setEarlyEnd(false); // a short squeeze may by chance have lost little
    squeezeBySpace(f);
    QTRY_VERIFY(f.find<VerdictPanel>("verdictPanel")->outcome() == InspectionOutcome::NotValid);
    QCOMPARE(f.find<QPushButton>("squeezeButton")->text(), u"Squeeze again (Space)"_s);
    QVERIFY(f.find<QLabel>("notJudgedNote")->isVisible());
    QVERIFY(f.find<QLabel>("yieldLabel")->text().isEmpty());
    QCOMPARE(f.find<QLabel>("batchCount")->text(), u"0 of 5"_s);
    QCOMPARE(f.bench->inspection().counts().invalid, 1);
}

GRIPSCOPE_TEST(InspectFlowTest)
#include "inspect_flow_test.moc"
