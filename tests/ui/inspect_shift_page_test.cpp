// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/batch.h"
#include "tests/support/test_registry.h"
#include "tests/ui/inspecting.h"
#include "ui/format/outcome_words.h"
#include "ui/pages/inspect/inspect_batch.h"
#include "ui/pages/inspect/inspect_parts.h"
#include "ui/settings/values/settings.h"
#include "ui/settings/values/shift_start.h"
#include "ui/widgets/fitted_label.h"
#include "ui/widgets/outcome_view.h"
#include "ui/windows/window_guard.h"

#include <QLabel>
#include <QRegularExpression>
#include <QSpinBox>
#include <QToolButton>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::longEnough_ms;
using gripscope::test::WindowFixture;
using namespace gripscope::test::inspecting;

/// What belongs to a shift on the Inspect page beside the squeezes: voids, counters, part numbers, the end of
/// a batch.
class InspectShiftPageTest : public QObject {
    Q_OBJECT
private slots:
    void theLastSqueezeIsVoidedByTwoPresses();
    void afterABatchSpaceAsksFirst();
    void aPartThatIsVoidedAfterTheEndDoesNotReopenTheBatch();
    void enterInTheCountBeginsTheBatch();
    void aNewShiftCountsFromZeroAndIsKept();
    void aCodeThatIsNoTypeIsThePartsNumber();
    void theExpectedTypeComesBackInANewWindow();
    void afterThreeInvalidOnesASupervisorIsCalled();
    void nothingExpectedIsNotAsExpected();
    void theRatesBesideAVerdictAreItsOwn();
    void aVerdictStepsBackWhenTheGripperIsGone();
    void countsAreReadFromAfar();
    void countsGrowWithTheWindow();
    void fromTheFitPageItIsAClickBack();
    void aSqueezeThatIsNotStoredYetSaysSo();
};

void InspectShiftPageTest::theLastSqueezeIsVoidedByTwoPresses()
{
    Armed armed;
    WindowFixture& f = armed.f;
    auto* button = f.find<QPushButton>("voidButton");
    QVERIFY(!button->isEnabled()); // there is none yet
    expectType(f, u"A"_s);
    squeezeBySpace(f);
    squeezeBySpace(f);
    QTRY_VERIFY_WITH_TIMEOUT(button->isEnabled(), longEnough_ms);
    f.click(button);
    auto* dialog = f.window->findChild<VoidDialog*>();
    QVERIFY(dialog);
    QVERIFY(QTest::qWaitForWindowExposed(dialog, longEnough_ms));
    QVERIFY(!dialog->findChild<QPushButton*>(u"voidAccept"_s)->isEnabled()); // it needs a reason
    QTest::mouseClick(dialog->findChild<QPushButton*>(u"voidTwice"_s), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().counts().voided, qint64(1), longEnough_ms);
    QCOMPARE(f.bench->inspection().counts().asExpected, qint64(1));
    QCOMPARE(f.find<QLabel>("goodCount")->text(), u"1 of 1"_s);
    QVERIFY(f.find<QLabel>("splitLabel")->text().contains(u"1 voided"_s));
    // Its verdict steps back, and the list has it struck.
    const auto* verdict = f.find<VerdictPanel>("verdictPanel");
    QTRY_VERIFY_WITH_TIMEOUT(!verdict->outcome(), longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(verdict->accessibleDescription().contains(u"VOIDED"_s), longEnough_ms);
    QVERIFY(!button->isEnabled());
    const auto* list = f.find<InspectionList>("inspectionList");
    QTRY_VERIFY_WITH_TIMEOUT(list->lineModel().lines().front().voided, longEnough_ms);
    QVERIFY(inWords(list->lineModel().lines().front()).contains(u"voided"_s));
    QTRY_VERIFY(!WindowGuard::asking());
    f.makeActive();
    squeezeBySpace(f); // and work goes on by Space
}

void InspectShiftPageTest::afterABatchSpaceAsksFirst()
{
    Armed armed;
    WindowFixture& f = armed.f;
    expectType(f, u"A"_s);
    f.bench->inspection().beginBatch({u"4711"_s, 1, u"A"_s, {}});
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->inspection().batch(), longEnough_ms);
    const auto* over = f.find<FittedLabel>("batchCompleteLabel");
    QVERIFY(!over->isVisible());
    squeezeBySpace(f);
    QTRY_VERIFY_WITH_TIMEOUT(over->isVisible(), longEnough_ms);
    QCOMPARE(over->text(), u"Batch 4711 is complete"_s);
    QVERIFY2(over->fontPixels() >= 28, qPrintable(QString::number(over->fontPixels())));
    // The next Space squeezes nothing: it asks.
    auto* squeeze = f.find<QPushButton>("squeezeButton");
    QTRY_VERIFY_WITH_TIMEOUT(squeeze->isEnabled(), longEnough_ms);
    QTest::qWait(2 * ScanReader::longestGap_ms);
    QTest::keyClick(focusOf(f), Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(WindowGuard::asking(), longEnough_ms);
    QCOMPARE(WindowGuard::asking()->objectName(), u"outsideBatchDialog"_s);
    QTest::keyClick(WindowGuard::asking(), Qt::Key_Return); // Enter changes nothing
    QTRY_VERIFY(!WindowGuard::asking());
    QCOMPARE(f.bench->inspection().counts().total, qint64(1));
    QVERIFY(over->isVisible());
    f.makeActive();
    f.click(squeeze);
    QTRY_VERIFY_WITH_TIMEOUT(WindowGuard::asking(), longEnough_ms);
    QTest::mouseClick(WindowGuard::asking()->findChild<QPushButton*>(u"outsideBatchAccept"_s),
                      Qt::LeftButton);
    QTRY_VERIFY(!WindowGuard::asking());
    QTRY_VERIFY(!over->isVisible());
    QVERIFY(f.bench->inspection().state() == InspectSession::State::Ready); // nothing moved by the answer
    QCOMPARE(f.bench->inspection().counts().total, qint64(1));
    f.makeActive();
    squeezeBySpace(f);
    QCOMPARE(f.bench->inspection().batch()->counts.total, qint64(1)); // outside of it, as was decided
}

void InspectShiftPageTest::aPartThatIsVoidedAfterTheEndDoesNotReopenTheBatch()
{
    Armed armed;
    WindowFixture& f = armed.f;
    expectType(f, u"A"_s);
    f.bench->inspection().beginBatch({u"4711"_s, 1, u"A"_s, {}});
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->inspection().batch(), longEnough_ms);
    squeezeBySpace(f);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<FittedLabel>("batchCompleteLabel")->isVisible(), longEnough_ms);
    f.bench->inspection().voidLast(u"squeezed twice"_s);
    QTRY_COMPARE_WITH_TIMEOUT(f.find<QLabel>("batchCount")->text(), u"0 of 1"_s, longEnough_ms);
    QTRY_COMPARE(f.find<FittedLabel>("batchCompleteLabel")->text(), u"Batch 4711 has ended"_s);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QPushButton>("squeezeButton")->isEnabled(), longEnough_ms);
    f.click(f.find<QPushButton>("squeezeButton")); // it still asks: the part would belong to no batch
    QTRY_VERIFY_WITH_TIMEOUT(WindowGuard::asking(), longEnough_ms);
    QCOMPARE(WindowGuard::asking()->objectName(), u"outsideBatchDialog"_s);
    QCOMPARE(f.bench->inspection().counts().voided, qint64(1));
}

void InspectShiftPageTest::enterInTheCountBeginsTheBatch()
{
    BatchDialog dialog(u"A"_s);
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog, longEnough_ms));
    auto* name = dialog.findChild<QLineEdit*>(u"batchNameField"_s);
    auto* target = dialog.findChild<QSpinBox*>(u"batchTargetField"_s);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    QTest::keyClicks(name, u"4711"_s);
    QTest::keyClick(name, Qt::Key_Return);
    QTest::keyClick(target, Qt::Key_Return); // the second one of a scanner
    QVERIFY(dialog.isVisible());
    QTest::qWait(2 * ScanReader::longestGap_ms);
    QTest::keyClicks(target, u"25"_s);
    QTest::keyClick(target, Qt::Key_Return);
    QVERIFY(!dialog.isVisible());
    QCOMPARE(dialog.result(), int(QDialog::Accepted));
    QCOMPARE(dialog.batch().target, qint64(25));
}

void InspectShiftPageTest::aNewShiftCountsFromZeroAndIsKept()
{
    Armed armed;
    WindowFixture& f = armed.f;
    expectType(f, u"A"_s);
    squeezeBySpace(f);
    const auto* good = f.find<QLabel>("goodCount");
    QTRY_COMPARE_WITH_TIMEOUT(good->text(), u"1 of 1"_s, longEnough_ms);
    QCOMPARE(f.find<QLabel>("periodLabel")->text(), u"All so far"_s);
    f.click(f.find<QPushButton>("newShiftButton"));
    QTRY_VERIFY(WindowGuard::asking());
    QTest::mouseClick(WindowGuard::asking()->findChild<QPushButton*>(u"newShiftAccept"_s), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(good->text(), u"0 of 0"_s, longEnough_ms);
    QCOMPARE(f.find<QLabel>("periodLabel")->text(), u"This shift"_s);
    f.makeActive();
    squeezeBySpace(f);
    QTRY_COMPARE_WITH_TIMEOUT(good->text(), u"1 of 1"_s, longEnough_ms);
    QVERIFY(f.find<QLabel>("typesLabel")->text().contains(u"A: 1 of 1"_s));
    QCOMPARE(f.bench->inspection().counts().total, qint64(2)); // nothing is lost
    // Where it began is kept, for this library alone.
    const QString kept = f.bench->settings().get(setting::shiftStart);
    QCOMPARE(ShiftStart::afterIn(f.bench->library().file(), kept), qint64(1));
    QCOMPARE(ShiftStart::afterIn(u"/another.gripscope"_s, kept), qint64(0));
    QCOMPARE(ShiftStart::afterIn(f.bench->library().file(), u"nonsense"_s), qint64(0));
}

void InspectShiftPageTest::aCodeThatIsNoTypeIsThePartsNumber()
{
    Armed armed;
    WindowFixture& f = armed.f;
    auto* field = f.find<QLineEdit>("partNumberField");
    QVERIFY(!field->isVisible());
    f.bench->settings().set(setting::partNumbers, true);
    QVERIFY(field->isVisible());
    scan(f, u"SN-0042"_s);
    QCOMPARE(field->text(), u"SN-0042"_s);
    scan(f, u"A"_s); // a type is still chosen by its name or code
    QCOMPARE(armed.expected(), u"A"_s);
    QCOMPARE(field->text(), u"SN-0042"_s);
    squeezeBySpace(f);
    QCOMPARE(f.bench->inspection().result()->partNumber, u"SN-0042"_s);
    QTRY_VERIFY(field->text().isEmpty()); // the next part has its own
    field->setFocus();
    QTest::keyClicks(field, u"SN 43"_s);
    QTest::keyClick(field, Qt::Key_Return);
    squeezeBySpace(f);
    QCOMPARE(f.bench->inspection().result()->partNumber, u"SN 43"_s);
}

void InspectShiftPageTest::theExpectedTypeComesBackInANewWindow()
{
    Armed armed;
    WindowFixture& f = armed.f;
    expectType(f, u"C"_s);
    f.window = std::make_unique<MainWindow>(*f.bench); // as after a start, or in another language
    f.window->show();
    QTRY_COMPARE_WITH_TIMEOUT(armed.expected(), u"C"_s, longEnough_ms);
    QCOMPARE(f.bench->inspection().expectedType(), u"C"_s);
    // One that is no longer there is not expected.
    f.bench->settings().set(setting::expectedType, u"Z"_s);
    f.window = std::make_unique<MainWindow>(*f.bench);
    f.window->show();
    QTest::qWait(100);
    QCOMPARE(armed.expected(), QString());
}

void InspectShiftPageTest::afterThreeInvalidOnesASupervisorIsCalled()
{
    Armed armed(u"virtual:?object=A&seed=8&fault=loss:0.35&speed=0"_s);
    WindowFixture& f = armed.f;
    f.bench->inspection().setEarlyEnd(false); // a short squeeze may by chance have lost little
    f.bench->settings().set(setting::invalidInARow, 2.0);
    const auto* verdict = f.find<VerdictPanel>("verdictPanel");
    squeezeBySpace(f);
    QTRY_COMPARE(verdict->headline(), u"Squeeze again"_s);
    squeezeBySpace(f);
    QTRY_COMPARE(verdict->headline(), u"Call your supervisor"_s);
    QVERIFY(verdict->outcome() == InspectionOutcome::NotValid);
    QVERIFY(verdict->accessibleDescription().contains(u'2'));
    QCOMPARE(f.find<QPushButton>("squeezeButton")->text(), u"Squeeze (Space)"_s);
}

void InspectShiftPageTest::nothingExpectedIsNotAsExpected()
{
    Armed armed;
    WindowFixture& f = armed.f;
    squeezeBySpace(f);
    const auto* list = f.find<InspectionList>("inspectionList");
    QTRY_COMPARE_WITH_TIMEOUT(list->lineModel().lines().size(), std::size_t(1), longEnough_ms);
    QVERIFY(!inWords(list->lineModel().lines().front()).contains(u"as expected"_s));
    QVERIFY(inWords(list->lineModel().lines().front()).contains(u"known type"_s));
    const auto says = [&f](const QString& words) {
        QStringList found;
        for (const QWidget* widget : f.page(u"inspect"_s)->findChildren<QWidget*>()) {
            const auto* label = qobject_cast<const QLabel*>(widget);
            const QString all = widget->accessibleName() + widget->accessibleDescription() +
                                widget->toolTip() + (label ? label->text() : QString());
            if (all.contains(QRegularExpression(u"\\b"_s + QRegularExpression::escape(words))))
                found << widget->objectName() + u": "_s + all;
        }
        return found.join(u'\n');
    };
    QTRY_VERIFY_WITH_TIMEOUT(
        says(u"1 of 1 were of the expected type, or of a known one"_s).contains(u"goodCount"_s),
        longEnough_ms);
    QVERIFY(!says(u"of a known type ("_s).isEmpty()); // the yield
    QVERIFY2(says(u"as expected"_s).isEmpty(), qPrintable(says(u"as expected"_s)));
    expectType(f, u"A"_s);
    squeezeBySpace(f);
    QTRY_COMPARE_WITH_TIMEOUT(list->lineModel().lines().size(), std::size_t(2), longEnough_ms);
    QVERIFY(inWords(list->lineModel().lines().front()).contains(u"as expected"_s));
}

void InspectShiftPageTest::theRatesBesideAVerdictAreItsOwn()
{
    Armed armed;
    WindowFixture& f = armed.f;
    StoredRates rates = f.bench->rates();
    rates.rates.falseReject = 0.025;
    f.bench->setRates(rates);
    squeezeBySpace(f);
    const auto held = [&f] {
        const auto* label = f.find<QLabel>("ratesLabel");
        return label->toolTip() + label->text();
    };
    QTRY_VERIFY(held().contains(u"2.5"_s));
    rates.rates.falseReject = 0.075;
    f.bench->setRates(rates);
    QVERIFY(f.find<VerdictPanel>("verdictPanel")->outcome());
    QVERIFY2(held().contains(u"2.5"_s) && !held().contains(u"7.5"_s), qPrintable(held()));
    squeezeBySpace(f);
    QTRY_VERIFY(held().contains(u"7.5"_s));
}

void InspectShiftPageTest::aVerdictStepsBackWhenTheGripperIsGone()
{
    Armed armed;
    WindowFixture& f = armed.f;
    expectType(f, u"A"_s);
    squeezeBySpace(f);
    const auto* verdict = f.find<VerdictPanel>("verdictPanel");
    QVERIFY(verdict->outcome());
    f.bench->connection().disconnect(); // by a person; nobody pulled the plug
    QTRY_VERIFY_WITH_TIMEOUT(!verdict->outcome(), longEnough_ms);
    QVERIFY2(verdict->accessibleDescription().startsWith(u"The last part: A"_s),
             qPrintable(verdict->accessibleDescription()));
    f.connectTo(gripscope::test::unhurriedA);
    QTest::qWait(100);
    QVERIFY(!verdict->outcome()); // nor does it come back with it
}

void InspectShiftPageTest::countsAreReadFromAfar()
{
    FittedLabel label(48);
    label.resize(272, 48);
    label.setText(u"19 of 20"_s);
    const int few = label.fontPixels();
    QVERIFY2(few > metrics::fontNumber, qPrintable(QString::number(few)));
    label.setText(u"119,000 of 1,000,000 parts"_s); // what is longer gives way, and stays inside
    QVERIFY(label.fontPixels() < few);
    QVERIFY(QFontMetricsF(Theme::font(label.fontPixels(), true)).horizontalAdvance(label.text()) <= 272);
}

void InspectShiftPageTest::countsGrowWithTheWindow()
{
    WindowFixture f(true, {});
    f.window->showPage(u"inspect"_s);
    const auto* good = f.find<FittedLabel>("goodCount");
    const auto* side = f.find<QWidget>("inspectSummary");
    const auto at = [&](const QSize& size) {
        f.window->resize(size);
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
        return f.window->size() == size;
    };
    QVERIFY(at({1024, 640}));
    QCOMPARE(side->width(), 304);
    QCOMPARE(good->height(), 48);
    const int small = good->fontPixels();
    QVERIFY(at({2048, 1280}));
    const double share = double(side->width()) / f.page(u"inspect"_s)->width();
    QVERIFY2(share > 0.22 && share < 0.25, qPrintable(QString::number(share)));
    QVERIFY2(good->fontPixels() > 1.5 * small, qPrintable(QString::number(good->fontPixels())));
    QVERIFY(at({3000, 1600}));
    QCOMPARE(side->width(), 520);
    QCOMPARE(good->height(), 96);
    QVERIFY(at({3000, 640})); // wide and low: the list keeps its room
    QVERIFY(good->height() < 60);
    QVERIFY(at({1024, 640})); // and the way back is open
    QCOMPARE(side->width(), 304);
}

void InspectShiftPageTest::fromTheFitPageItIsAClickBack()
{
    Armed armed;
    WindowFixture& f = armed.f;
    squeezeBySpace(f);
    auto* list = f.find<InspectionList>("inspectionList");
    QTRY_COMPARE_WITH_TIMEOUT(list->lineModel().lines().size(), std::size_t(1), longEnough_ms);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualRect(list->model()->index(0, 0)).center());
    QTRY_COMPARE_WITH_TIMEOUT(f.window->currentPage()->id(), u"fit"_s, longEnough_ms);
    auto* back = f.find<QToolButton>("fitBack");
    QVERIFY(back->isVisible());
    QCOMPARE(back->toolTip(), u"Back to Inspect (Alt+Left)"_s);
    f.click(back);
    QCOMPARE(f.window->currentPage()->id(), u"inspect"_s);
}

void InspectShiftPageTest::aSqueezeThatIsNotStoredYetSaysSo()
{
    Armed armed;
    WindowFixture& f = armed.f;
    const auto* verdict = f.find<VerdictPanel>("verdictPanel");
    const auto marked = [verdict] { return verdict->accessibleDescription().contains(u"not stored yet"_s); };
    expectType(f, u"A"_s);
    squeezeBySpace(f);
    QTRY_VERIFY_WITH_TIMEOUT(!marked(), longEnough_ms);
    const QString file = f.bench->library().file();
    QVERIFY(QFile::rename(file, file + u".away"_s));
    auto* squeeze = f.find<QPushButton>("squeezeButton");
    QTRY_COMPARE_WITH_TIMEOUT(focusOf(f), static_cast<QWidget*>(squeeze), longEnough_ms);
    QTest::qWait(2 * ScanReader::longestGap_ms);
    QTest::keyClick(focusOf(f), Qt::Key_Space);
    const InspectSession& session = f.bench->inspection();
    QTRY_VERIFY_WITH_TIMEOUT(session.result() && session.unstored() == 1 && session.lastError(),
                             longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(marked(), longEnough_ms);
    QCOMPARE(verdict->headline(), u"A"_s); // the verdict is there all the same
    QVERIFY(QFile::rename(file + u".away"_s, file));
    QTRY_VERIFY_WITH_TIMEOUT(session.unstored() == 0 && !marked(), longEnough_ms);
    QCOMPARE(session.counts().total, qint64(2));
}

GRIPSCOPE_TEST(InspectShiftPageTest)
#include "inspect_shift_page_test.moc"
