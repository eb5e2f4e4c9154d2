// SPDX-License-Identifier: GPL-3.0-or-later
// A verdict on a measurement in doubt, as the Inspect page shows it: never as a clean one.
#include "core/signal/recording/stream_account.h"
#include "tests/core/signal/measured_can.h"
#include "tests/support/test_registry.h"
#include "tests/ui/inspecting.h"
#include "ui/sound/sound_player.h"
#include "ui/widgets/inspection_widgets.h"
#include "ui/widgets/outcome_view.h"

#include <QLabel>
#include <QRegularExpression>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;
using namespace gripscope::test::inspecting;
using test::MeasuredCan;

namespace {

using Change = std::function<void(Recording&)>;

Recording squeezeOf_A()
{
    Recording recording = MeasuredCan().make();
    recording.status.assign(recording.size(), StatusArmed | StatusMoving);
    for (std::size_t i = 0; i < recording.size(); ++i)
        recording.sequence.push_back(i);
    return recording;
}

Change clockFastBy(double ppm)
{
    return [ppm](Recording& recording) {
        recording.provenance[streamAccountKey()] =
            u"clock_compared=1 clock_ppm=%1 clock_uncertainty_ppm=90"_s.arg(ppm);
    };
}

void overdue(Recording& recording)
{
    recording.provenance[u"force_calibration"_s] = u"on 2019-01-01"_s;
    recording.provenance[u"force_calibration_days_left"_s] = u"-2151"_s;
}

void losingSome(Recording& recording)
{
    for (std::size_t i = recording.size() - 20; i > 50; i -= 50) {
        const auto at = std::ptrdiff_t(i);
        recording.time_s.erase(recording.time_s.begin() + at);
        recording.force.erase(recording.force.begin() + at);
        recording.position.erase(recording.position.begin() + at);
        recording.sequence.erase(recording.sequence.begin() + at);
        recording.status.erase(recording.status.begin() + at);
    }
}

/// Pixels of exactly this colour: solid parts and the middle of letters.
int pixelsOf(const QImage& image, const QColor& color)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixelColor(x, y).rgb() == color.rgb() ? 1 : 0;
    return count;
}

QImage painted(VerdictPanel& panel)
{
    return panel.grab().toImage();
}

/// The page shows the verdict on `recording`, and the library has it.
void judge(const WindowFixture& f, const Recording& recording)
{
    InspectSession& session = f.bench->inspection();
    const qint64 before = session.counts().total;
    QVERIFY(session.judgeRecording(recording, u"a test"_s));
    QTRY_COMPARE_WITH_TIMEOUT(session.counts().total, before + 1, gripscope::test::longEnough_ms);
    const auto* list = f.find<InspectionList>("inspectionList");
    QTRY_VERIFY_WITH_TIMEOUT(list->lineModel().lines().size() == std::size_t(before + 1),
                             gripscope::test::longEnough_ms);
}

} // namespace

Q_DECLARE_METATYPE(Change)

class InspectSuspectTest : public QObject {
    Q_OBJECT
private slots:
    void doubtsAreSeenAndNamed_data();
    void doubtsAreSeenAndNamed();
    void noColourIsSharedWithACleanVerdict_data();
    void noColourIsSharedWithACleanVerdict();
    void everyOutcomeLooksOtherwiseInDoubt_data();
    void everyOutcomeLooksOtherwiseInDoubt();
    void aGripperThatLosesReportsIsDoubted();
    void itSoundsLikeNoOther();
};

void InspectSuspectTest::doubtsAreSeenAndNamed_data()
{
    QTest::addColumn<Change>("change");
    QTest::addColumn<bool>("suspect");
    QTest::addColumn<bool>("invalid");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, const Change& change, bool suspect, bool invalid,
                        const QString& reason) {
        QTest::newRow(name) << change << suspect << invalid << reason;
    };
    row("clean", [](Recording&) {}, false, false, {});
    row("calibration overdue", overdue, true, false,
        u"Suspect: The calibration of the force was overdue by 2151 days. Calibrate it"_s);
    row("2 % lost", losingSome, true, false, u"samples are missing"_s);
    row("clock 0.5 % fast", clockFastBy(5000), true, false, u"clock is 0.5 % fast"_s);
    row("clock 5.5 % fast", clockFastBy(55000), false, true, u"clock is 5.5 % fast"_s);
    row(
        "fault bit", [](Recording& r) { r.status[9] |= StatusFault; }, false, true, u"fault of its own"_s);
    row(
        "stuck", [](Recording& r) { std::fill(r.position.begin(), r.position.end(), r.position[0]); }, false,
        true, u"position channel is stuck"_s);
    row(
        "clipped",
        [](Recording& r) {
            for (double& force : r.force)
                force = std::min(force, 25.0);
        },
        false, true, u"end of its sensor's range"_s);
}

void InspectSuspectTest::doubtsAreSeenAndNamed()
{
    QFETCH(Change, change);
    QFETCH(bool, suspect);
    QFETCH(bool, invalid);
    QFETCH(QString, reason);
    WindowFixture f;
    f.window->showPage(u"inspect"_s);
    Recording recording = squeezeOf_A();
    change(recording);
    judge(f, recording);
    const auto* panel = f.find<VerdictPanel>("verdictPanel");
    const QString why = f.find<QLabel>("reasonLabel")->text();
    QCOMPARE(panel->suspect(), suspect);
    QCOMPARE(panel->outcome() == InspectionOutcome::NotValid, invalid);
    QVERIFY2(why.contains(reason), qPrintable(why));
    QVERIFY2(!why.contains(u"not_identifiable"_s), qPrintable(why));
    for (const QString& words : {why, f.find<QLabel>("reasonLabel")->toolTip()}) {
        QStringList sentences = words.split(QRegularExpression(u"(?<=[.:]) "_s), Qt::SkipEmptyParts);
        const auto said = sentences.size();
        QVERIFY2(sentences.removeDuplicates() == 0, qPrintable(words));
        QVERIFY(said > 0 || words.isEmpty());
    }
    if (!invalid)
        QCOMPARE(panel->headline(), u"A"_s);
    QCOMPARE(panel->accessibleDescription().contains(u"SUSPECT"_s), suspect);
    const InspectionLine& line = f.find<InspectionList>("inspectionList")->lineModel().lines().front();
    QCOMPARE(line.suspect, suspect);
    QCOMPARE(inWords(line).contains(u"suspect"_s), suspect);
    QCOMPARE(f.bench->inspection().counts().invalid, invalid ? 1 : 0);
    QCOMPARE(f.bench->inspection().counts().asExpected, invalid ? 0 : 1);
}

void InspectSuspectTest::noColourIsSharedWithACleanVerdict_data()
{
    QTest::addColumn<ThemeKind>("kind");
    QTest::newRow("light") << ThemeKind::Light;
    QTest::newRow("dark") << ThemeKind::Dark;
    QTest::newRow("contrast") << ThemeKind::HighContrast;
}

void InspectSuspectTest::noColourIsSharedWithACleanVerdict()
{
    QFETCH(ThemeKind, kind);
    WindowFixture f;
    f.window->showPage(u"inspect"_s);
    Theme::instance().apply(kind);
    const ThemeTokens& t = Theme::instance().tokens();
    auto* panel = f.find<VerdictPanel>("verdictPanel");
    judge(f, squeezeOf_A());
    const QImage clean = painted(*panel);
    Recording doubtful = squeezeOf_A();
    overdue(doubtful);
    judge(f, doubtful);
    const QImage suspect = painted(*panel);
    QVERIFY(pixelsOf(clean, t.asExpected) > 500);
    QCOMPARE(pixelsOf(clean, t.suspect), 0);
    QVERIFY(pixelsOf(suspect, t.suspect) > 5000); // the frame and the sign, not letters only
    QCOMPARE(pixelsOf(suspect, t.asExpected), 0);
    // Stripes too: told apart without colour. Between the sign and the headline nothing else is painted.
    const QColor stripe = suspectStripes().color();
    QVERIFY(pixelsOf(suspect, stripe) > 500);
    QCOMPARE(pixelsOf(clean, stripe), 0);
    // The list and the last 20 as well.
    const QImage strip = f.window->findChild<YieldStrip*>()->grab().toImage();
    QVERIFY(pixelsOf(strip, t.suspect) > 50);
    QTRY_VERIFY(pixelsOf(f.find<InspectionList>("inspectionList")->viewport()->grab().toImage(), t.suspect) >
                50);
}

void InspectSuspectTest::everyOutcomeLooksOtherwiseInDoubt_data()
{
    noColourIsSharedWithACleanVerdict_data();
}

void InspectSuspectTest::everyOutcomeLooksOtherwiseInDoubt()
{
    QFETCH(ThemeKind, kind);
    Theme::instance().apply(kind);
    VerdictPanel panel;
    panel.resize(640, 200);
    std::vector<QImage> seen;
    for (const InspectionOutcome outcome :
         {InspectionOutcome::AsExpected, InspectionOutcome::OtherType, InspectionOutcome::Unknown,
          InspectionOutcome::Inconclusive, InspectionOutcome::NotValid, InspectionOutcome::DoesNotConform})
        for (const bool suspect : {false, true}) {
            panel.showOutcome(outcome, u"A"_s, u"words"_s, suspect);
            seen.push_back(painted(panel));
            const QColor own = Theme::instance().outcomeColor(outcome, suspect);
            QVERIFY(pixelsOf(seen.back(), own) > 500);
            if (suspect)
                QCOMPARE(pixelsOf(seen.back(), Theme::instance().outcomeColor(outcome)), 0);
        }
    for (std::size_t i = 0; i < seen.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(seen[i] != seen[j]);
    Theme::instance().apply(ThemeKind::Light);
}

void InspectSuspectTest::aGripperThatLosesReportsIsDoubted()
{
    Armed armed(u"virtual:?object=A&seed=8&fault=loss:0.05"_s);
    armed.f.bench->inspection().setEarlyEnd(false); // one that ends soon may by chance lose little
    squeezeBySpace(armed.f);
    const auto* panel = armed.f.find<VerdictPanel>("verdictPanel");
    QVERIFY(panel->suspect());
    QVERIFY2(armed.f.find<QLabel>("reasonLabel")->text().startsWith(u"Suspect: "_s),
             qPrintable(armed.f.find<QLabel>("reasonLabel")->text()));
}

void InspectSuspectTest::itSoundsLikeNoOther()
{
    for (const InspectionOutcome outcome : {InspectionOutcome::AsExpected, InspectionOutcome::OtherType,
                                            InspectionOutcome::Unknown, InspectionOutcome::Inconclusive}) {
        QVERIFY(soundOf(outcome, true) == Sound::Suspect);
        QVERIFY(samplesOf(tonesOf(Sound::Suspect)) != samplesOf(tonesOf(soundOf(outcome))));
    }
    QVERIFY(soundOf(InspectionOutcome::NotValid, true) == Sound::NotValid);
}

GRIPSCOPE_TEST(InspectSuspectTest)
#include "inspect_suspect_test.moc"
