// SPDX-License-Identifier: GPL-3.0-or-later
// A power cut, a crash, a kill: whatever was told as added is in the library afterwards, and the library
// opens.
#include "core/library/library.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <QElapsedTimer>
#include <QSet>
#include <QThread>

#include <random>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

class KilledEnrollmentTest : public QObject {
    Q_OBJECT
private:
    static constexpr int kills = 20;
    static constexpr int squeezes = 12;
    Workplace m_work;
    QStringList m_files;

    QStringList enrollment(const QString& library) const
    {
        return QStringList{u"enroll"_s, u"--library"_s, library, u"--type"_s, u"A"_s} + m_files;
    }
    static QSet<QString> announced(const QByteArray& messages)
    {
        QSet<QString> files;
        // a line that was cut off in its middle was not told
        for (const QByteArray& line : messages.left(messages.lastIndexOf('\n') + 1).split('\n'))
            if (line.startsWith("added "))
                files << QString::fromUtf8(line.mid(6));
        return files;
    }
    struct Contents {
        bool whole = false; ///< it opens, and every squeeze in it is complete
        QStringList sources;
    };
    Contents stored(const QString& name) const
    {
        Expected<std::unique_ptr<Library>> library = Library::open(m_work.path(name));
        if (!library)
            return {};
        Contents contents{true, {}};
        const auto types = (*library)->types();
        if (!types)
            return {};
        for (const TypeRecord& type : *types) {
            const auto grasps = (*library)->grasps(type.id);
            if (!grasps)
                return {};
            for (const GraspRecord& grasp : *grasps) {
                const Expected<Recording> recording = (*library)->recording(grasp.id);
                if (!recording || recording->size() == 0 || !grasp.parameters)
                    return {};
                contents.sources << grasp.source;
            }
        }
        return contents;
    }

private slots:
    void initTestCase()
    {
        for (int i = 1; i <= squeezes; ++i) {
            m_files << u"squeeze%1.csv"_s.arg(i);
            QCOMPARE(m_work
                         .cli({u"record"_s, u"--device"_s, u"virtual:?seed=%1&speed=0"_s.arg(i),
                               u"--seconds"_s, u"1"_s, u"--arm"_s, u"-o"_s, m_files.last()})
                         .exit,
                     0);
        }
    }
    void everythingToldAsAddedIsThereAfterAKill()
    {
        QElapsedTimer timer;
        timer.start();
        QCOMPARE(m_work.cli(enrollment(u"whole.db"_s)).exit, 0);
        const qint64 whole_us = timer.nsecsElapsed() / 1000;
        QCOMPARE(stored(u"whole.db"_s).sources.size(), qsizetype(squeezes));

        // A random number of squeezes in, then a random part of what one squeeze takes: any moment, whatever
        // else this computer is doing.
        std::mt19937_64 random(20240501);
        const auto below = [&random](qint64 limit) {
            return static_cast<qint64>(random() % static_cast<std::uint64_t>(limit));
        };
        int cutShort = 0;
        for (int i = 0; i < kills; ++i) {
            const QString name = u"killed%1.db"_s.arg(i);
            QProcess process;
            m_work.prepare(process, enrollment(name));
            process.setReadChannel(QProcess::StandardError);
            process.start();
            QVERIFY(process.waitForStarted());
            QByteArray messages;
            const auto before = below(squeezes);
            while (messages.count('\n') < before && process.waitForReadyRead(30'000))
                messages += process.readAllStandardError();
            QThread::usleep(static_cast<unsigned long>(below(2 * whole_us / squeezes)));
            process.kill(); // SIGKILL
            QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished(30'000));
            cutShort += process.exitStatus() == QProcess::CrashExit;
            messages += process.readAllStandardError();

            const QSet<QString> told = announced(messages);
            const Contents there = stored(name);
            QVERIFY(there.whole);
            const QSet<QString> found(there.sources.begin(), there.sources.end());
            QCOMPARE(found.size(), there.sources.size()); // none twice
            QVERIFY2(found.contains(told), qPrintable(name));
            // At most one more than was told: the one whose message the kill cut off.
            QVERIFY(there.sources.size() <= told.size() + 1);
        }
        QVERIFY(cutShort > kills / 2); // or this tested nothing
    }
    void anEnrolmentGoesOnAfterAKill()
    {
        QStringList rest = m_files;
        for (const QString& source : stored(u"killed0.db"_s).sources)
            rest.removeAll(source);
        // All of them: those that are there already are told, and none is there twice.
        const ProgramRun run = m_work.cli(enrollment(u"killed0.db"_s));
        QCOMPARE(run.exit, rest.size() == m_files.size() ? 0 : 6);
        QCOMPARE(announced(run.err), QSet<QString>(rest.begin(), rest.end()));
        QCOMPARE(stored(u"killed0.db"_s).sources.size(), qsizetype(squeezes));
    }
};

GRIPSCOPE_TEST(KilledEnrollmentTest)
#include "killed_enrollment_test.moc"
