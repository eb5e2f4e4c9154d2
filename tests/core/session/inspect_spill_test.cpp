// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/spill/inspection_spill.h"
#include "tests/core/library/child_process.h"
#include "tests/core/library/full_disk.h"
#include "tests/core/library/raw_database.h"
#include "tests/core/session/inspection_run.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <set>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

using Tell = std::function<void(char)>;

/// A child that inspects, and says by bytes how far it is.
class Inspector {
public:
    explicit Inspector(const std::function<bool(InspectionRun&, const Tell& tell)>& work, const QString& file)
    {
        if (pipe(m_ends) != 0)
            qFatal("no pipe");
        m_process = startChild([&] {
            InspectionRun run(file);
            const auto tell = [this](char byte) {
                if (write(m_ends[1], &byte, 1) != 1)
                    _exit(1);
            };
            if (!run.ready() || !work(run, tell))
                _exit(1);
            pause();
        });
        close(m_ends[1]);
    }
    ~Inspector()
    {
        if (m_process > 0)
            static_cast<void>(kill());
        close(m_ends[0]);
    }
    Inspector(const Inspector&) = delete;
    Inspector& operator=(const Inspector&) = delete;

    /// Whether it told anything, before it ended.
    bool waitForOne() { return next() != 0; }
    /// What it told next; 0 when it ended.
    char next()
    {
        char byte = 0;
        return read(m_ends[0], &byte, 1) == 1 ? byte : '\0';
    }
    /// Without warning; how many more it had told.
    int kill()
    {
        ::kill(m_process, SIGKILL);
        waitpid(m_process, nullptr, 0);
        m_process = -1;
        int more = 0;
        while (waitForOne())
            ++more;
        return more;
    }

private:
    int m_ends[2] = {-1, -1};
    pid_t m_process = -1;
};

/// Judged, shown, and stored or at least in the spill file.
bool inspectSafely(InspectionRun& run, const Recording& recording)
{
    return run.inspection.judgeRecording(recording, u"file.csv"_s).has_value() && run.until([&] {
        return run.inspection.result() && run.inspection.unstored() == run.inspection.spilled();
    });
}

} // namespace

/// Inspections whose program, disk or library goes away at the wrong moment.
class InspectSpillTest : public QObject {
    Q_OBJECT
private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;

    /// What a next program finds, in the order of their numbers.
    QStringList storedByTheNext()
    {
        InspectionRun next(m_file);
        if (!next.ready())
            return {};
        if (const auto error = next.inspection.lastError())
            qWarning("%s", qPrintable(error->describe()));
        RawDatabase raw(m_file);
        return raw.column(u"SELECT id FROM inspections ORDER BY number"_s);
    }
    void verifyOnceInOrder(const QStringList& ids, int expected)
    {
        QCOMPARE(ids.size(), expected);
        QStringList sorted = ids;
        sorted.sort();
        QCOMPARE(ids, sorted); // keys are in time order
        QCOMPARE(std::set<QString>(ids.begin(), ids.end()).size(), std::size_t(expected));
        RawDatabase raw(m_file);
        QCOMPARE(raw.run(u"SELECT COUNT(*) FROM inspections i JOIN recordings r ON r.grasp_id = i.grasp_id"_s)
                     .toInt(),
                 expected);
    }

private slots:
    void initTestCase()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        enrolTypes(m_folder->filePath(u"enrolled.db"_s), {{u"A"_s, canA}, {u"C"_s, canC}}, 5);
    }
    void init()
    {
        static int run = 0;
        m_file = m_folder->filePath(u"run-%1.db"_s.arg(++run));
        QVERIFY(QFile::copy(m_folder->filePath(u"enrolled.db"_s), m_file));
    }
    void cleanup() { QFile::remove(InspectionSpill::file(m_file, 1)); }

    void aKillBeforeTheCommitLosesNothing_data()
    {
        QTest::addColumn<QString>("what");
        QTest::newRow("library locked") << u"locked"_s;
        QTest::newRow("file removed") << u"removed"_s;
        QTest::newRow("disk full") << u"full"_s;
    }
    void aKillBeforeTheCommitLosesNothing()
    {
        QFETCH(QString, what);
        const Recording recording = squeezeOf(canA, 1);
        int before = 0, waiting = 0;
        const QString away = m_file + u".away"_s;
        {
            Inspector inspector(
                [&](InspectionRun& run, const Tell& tell) {
                    std::unique_ptr<RawDatabase> lock;
                    std::unique_ptr<FullDisk> full;
                    if (what == u"locked") {
                        lock = std::make_unique<RawDatabase>(m_file);
                        lock->run(u"BEGIN IMMEDIATE"_s);
                    } else if (what == u"removed") {
                        if (!QFile::rename(m_file, away))
                            return false;
                    } else {
                        // Until the log is longer than what goes into the spill file.
                        while (QFileInfo(m_file + u"-wal"_s).size() < 150'000) {
                            if (!inspectSafely(run, recording) || !run.ready())
                                return false;
                            tell('b');
                        }
                        full =
                            std::make_unique<FullDisk>(rlim_t(QFileInfo(m_file + u"-wal"_s).size()) + 4096);
                    }
                    for (std::size_t i = 1; i <= 3; ++i) {
                        if (!inspectSafely(run, recording) || run.inspection.spilled() != i ||
                            run.inspection.result()->keeping != InspectSession::Keeping::Waiting)
                            return false;
                        tell('w');
                    }
                    pause(); // with the lock held
                    return true;
                },
                m_file);
            for (char told = inspector.next(); told != 0 && waiting < 3;) {
                ++(told == 'b' ? before : waiting);
                told = waiting < 3 ? inspector.next() : '\0';
            }
            QCOMPARE(inspector.kill(), 0);
            QCOMPARE(waiting, 3);
        }
        if (what == u"removed")
            QVERIFY(QFile::rename(away, m_file));
        verifyOnceInOrder(storedByTheNext(), before + 3);
        verifyOnceInOrder(storedByTheNext(), before + 3); // and not again by the one after it
        QVERIFY(!QFile::exists(InspectionSpill::file(m_file, 1)));
    }
    void killsAtRandomMomentsOfTwoHundredInspectionsLoseNone()
    {
        const Recording recording = squeezeOf(canA, 1);
        QRandomGenerator random(7);
        int told = 0, stored = 0;
        while (told < 200) {
            Inspector inspector(
                [&](InspectionRun& run, const Tell& tell) {
                    for (int i = 0; i < 40; ++i) {
                        if (!inspectSafely(run, recording))
                            return false;
                        tell('s');
                    }
                    return true;
                },
                m_file);
            int now = 0;
            for (const int some = 1 + random.bounded(30); now < some && inspector.waitForOne(); ++now) {
            }
            QVERIFY(now > 0);
            QTest::qSleep(random.bounded(40)); // another moment each time, no wait for anything
            now += inspector.kill();
            told += now;
            const QStringList ids = storedByTheNext();
            // All that was told, and at most one of this round that was about to be.
            QVERIFY2(ids.size() == stored + now || ids.size() == stored + now + 1,
                     qPrintable(u"%1 told, %2 stored"_s.arg(now).arg(ids.size() - stored)));
            stored = int(ids.size());
        }
        verifyOnceInOrder(storedByTheNext(), stored);
    }
    void withoutASafePlaceThereIsNoSqueezeUntilThereIs()
    {
        const QString place = InspectionSpill::file(m_file, 1);
        QVERIFY(QDir().mkpath(place)); // a folder: nothing can be set aside there
        auto now = std::chrono::steady_clock::time_point() + std::chrono::hours(1);
        {
            InspectionRun run(m_file);
            run.inspection.setClock([&now] { return now; });
            QVERIFY(run.ready());
            QVERIFY(run.inspection.lastError());
            const auto refused = run.inspection.judgeRecording(squeezeOf(canA, 1), u"file.csv"_s);
            QVERIFY(!refused);
            QVERIFY(refused.error().describe().contains(place));
            QVERIFY(!run.inspection.squeeze());
            QVERIFY(QDir().rmdir(place));
            QVERIFY(run.until([&] {
                now += std::chrono::seconds(1);
                return !run.inspection.lastError();
            }));
            QVERIFY(inspectSafely(run, squeezeOf(canA, 1)));
        }
        verifyOnceInOrder(storedByTheNext(), 1);
    }
    void classifyingAloneSetsNothingAside()
    {
        InspectionRun run(m_file);
        run.inspection.setStoring(false);
        QVERIFY(run.ready());
        QVERIFY(run.inspection.judgeRecording(squeezeOf(canA, 1), u"file.csv"_s));
        QVERIFY(run.ready());
        QVERIFY(!QFile::exists(InspectionSpill::file(m_file, 1)));
    }
    void oneOfABatchThatABackupDoesNotKnowIsStoredWithoutIt()
    {
        const QString backup = m_file + u".backup"_s;
        QVERIFY(QFile::copy(m_file, backup));
        {
            Inspector inspector(
                [&](InspectionRun& run, const Tell& tell) {
                    run.inspection.beginBatch({u"4711"_s, 10, {}, {}});
                    if (!run.until([&] { return !run.inspection.changingBatch(); }))
                        return false;
                    RawDatabase lock(m_file);
                    lock.run(u"BEGIN IMMEDIATE"_s);
                    if (!inspectSafely(run, squeezeOf(canA, 1)))
                        return false;
                    tell('s');
                    pause();
                    return true;
                },
                m_file);
            QVERIFY(inspector.waitForOne());
            QCOMPARE(inspector.kill(), 0);
        }
        for (const QString& suffix : {QString(), u"-wal"_s, u"-shm"_s})
            QFile::remove(m_file + suffix);
        QVERIFY(QFile::copy(backup, m_file));
        verifyOnceInOrder(storedByTheNext(), 1);
    }
};

GRIPSCOPE_TEST(InspectSpillTest)
#include "inspect_spill_test.moc"
