// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/history.h"
#include "tests/support/test_registry.h"
#include "tests/ui/inspecting.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/arming.h"

#include <QFile>
#include <QTemporaryDir>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::longEnough_ms;
using gripscope::test::WindowFixture;
using namespace gripscope::test::inspecting;

namespace {

constexpr int parts = 60;

/// Of the gripper's time, of which a part takes one second and more.
constexpr auto mishaps = "10 loss 0.4\n"
                         "40 loss 0\n"
                         "45 unplug\n"
                         "48 replug\n";

} // namespace

/// A shift with scanner and keys: nobody touches the mouse.
class TechnicianJourneyTest : public QObject {
    Q_OBJECT

    std::chrono::steady_clock::time_point m_now;
    int m_armed = 0;

    /// Ctrl+Shift+A, held.
    void armByKeys(WindowFixture& f)
    {
        const Qt::KeyboardModifiers both = Qt::ControlModifier | Qt::ShiftModifier;
        QTest::keyPress(f.window.get(), Qt::Key_A, both);
        m_now += ArmChord::duration;
        QVERIFY(QTest::qWaitFor([&] { return f.bench->connection().armed(); }, longEnough_ms));
        QTest::keyRelease(f.window.get(), Qt::Key_A, both);
        ++m_armed;
    }

    static bool isReady(WindowFixture& f)
    {
        return f.bench->connection().armed() && f.bench->inspection().state() == InspectSession::State::Ready;
    }

    /// Once the gripper is there, armed, and the page waits for a part.
    void getReady(WindowFixture& f)
    {
        QVERIFY(
            QTest::qWaitFor([&] { return f.bench->connection().state() == ConnectSession::State::Connected; },
                            longEnough_ms));
        if (!f.bench->connection().armed())
            armByKeys(f);
        (void)QTest::qWaitFor([&] { return isReady(f) || !f.bench->connection().armed(); }, longEnough_ms);
    }

private slots:
    void sixtyPartsWithScannerAndSpace()
    {
        const QTemporaryDir folder;
        QFile script(folder.filePath(u"mishaps.txt"_s));
        QVERIFY(script.open(QIODevice::WriteOnly) && script.write(mishaps) > 0);
        script.close();
        WindowFixture f(true, u"virtual:?object=A&seed=5&speed=0&script=%1"_s.arg(script.fileName()));
        f.window->showPage(u"inspect"_s);
        f.bench->settings().set(setting::partNumbers, true);
        f.bench->inspection().setEarlyEnd(false); // a short squeeze may by chance lose little
        f.find<ArmChord>("armChord")->setClock([this] { return m_now; });
        QTest::qWait(2 * ScanReader::longestGap_ms);
        scan(f, u"A"_s); // the type by its label
        QTRY_COMPARE(f.find<TypeChooser>("expectedCombo")->expected(), u"A"_s);

        bool wasAway = false;
        const auto watch = connect(f.bench.get(), &Workbench::connectionChanged, this, [&] {
            wasAway = wasAway || f.bench->connection().state() == ConnectSession::State::Lost;
        });
        int reports = 0;
        connect(&f.bench->messages(), &Messages::reported, f.window.get(), [&reports] { ++reports; });
        InspectSession& session = f.bench->inspection();
        int scanned = 0;
        for (int tries = 0; session.counts().total < parts; ++tries) {
            QVERIFY2(tries < 2 * parts, qPrintable(f.window->message()));
            getReady(f);
            if (!isReady(f))
                continue; // it went away between
            const qint64 before = session.counts().total;
            if (session.partNumber().isEmpty()) // kept where the squeeze before came to nothing
                scan(f, u"SN-%1"_s.arg(++scanned));
            QTest::qWait(2 * ScanReader::longestGap_ms); // keys that follow faster are a scanner's
            const auto* squeeze = f.find<QPushButton>("squeezeButton"); // put forward by the page itself
            (void)QTest::qWaitFor([&] { return focusOf(f) == squeeze || !isReady(f); }, longEnough_ms);
            const int reportsBefore = reports;
            QTest::keyClick(focusOf(f), Qt::Key_Space);
            const bool told = QTest::qWaitFor(
                [&] {
                    const bool over = session.state() == InspectSession::State::Ready && !session.storing();
                    // With four reports of ten lost even ten repeats may remain unanswered: one presses
                    // again.
                    return session.counts().total > before ||
                           (over && (!f.bench->connection().armed() || reports > reportsBefore));
                },
                longEnough_ms);
            const QWidget* focus = focusOf(f);
            QVERIFY2(told,
                     qPrintable(u"%1 parts, %2 invalid, state %3, focus %4, message: %5"_s.arg(before)
                                    .arg(session.counts().invalid)
                                    .arg(int(session.state()))
                                    .arg(focus ? focus->objectName() : QString(), f.window->message())));
        }
        QObject::disconnect(watch);

        QVERIFY(wasAway);
        QVERIFY2(m_armed >= 2, qPrintable(QString::number(m_armed))); // it comes back disarmed
        const InspectionCounts counts = session.counts();
        QCOMPARE(counts.total, qint64(parts));
        QVERIFY(counts.invalid >= 1);
        QVERIFY(counts.asExpected >= 10);
        std::optional<std::vector<HistoryEntry>> stored;
        f.bench->background().ask<std::vector<HistoryEntry>>(
            nullptr,
            [](Library& library) -> Expected<std::vector<HistoryEntry>> {
                HistoryQuery query;
                query.kind = SqueezeKind::Inspection;
                return library.historyKeys(query).and_then(
                    [&](const HistoryKeys& keys) { return library.historyEntries(keys.part(0, 2 * parts)); });
            },
            [&stored](const Expected<std::vector<HistoryEntry>>& found) { stored = found.value(); });
        QTRY_VERIFY_WITH_TIMEOUT(stored, longEnough_ms);
        QCOMPARE(stored->size(), std::size_t(parts));
        for (const HistoryEntry& entry : *stored) // each part its own number, whatever happened between
            QCOMPARE(entry.partNumber, u"SN-%1"_s.arg(entry.number));
    }
};

GRIPSCOPE_TEST(TechnicianJourneyTest)
#include "technician_journey_test.moc"
