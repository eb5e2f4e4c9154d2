// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/report.h"
#include "devices/replay/capture_reader.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <csignal>
#include <sys/types.h>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

// The command line in the midst of a squeeze, asked to end; what it sent is in the capture of its gripper.

class AskedToEndTest : public QObject {
    Q_OBJECT
    Workplace m_work;

    /// The reports that were written, in order; from the first stop on.
    QList<protocol::ReportId> sentFromStop(const QString& capture) const
    {
        QList<protocol::ReportId> out;
        Expected<CaptureReader> reader = CaptureReader::open(capture);
        if (!reader)
            return out;
        for (;;) {
            const auto record = reader->next();
            if (!record || !*record)
                return out;
            if ((*record)->kind != CaptureKind::Output)
                continue;
            const auto id = static_cast<protocol::ReportId>((*record)->bytes.front());
            if (!out.isEmpty() || id == protocol::ReportId::Stop)
                out << id;
        }
    }

private slots:
    void stopsItsGripperAndWaitsForIt_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("Ctrl-C") << SIGINT;
        QTest::newRow("shutdown") << SIGTERM;
        QTest::newRow("the terminal closed") << SIGHUP;
    }
    void stopsItsGripperAndWaitsForIt()
    {
        QFETCH(int, signal);
        const QString capture = m_work.path(u"signal%1.gscap"_s.arg(signal));
        QProcess process;
        m_work.prepare(process, {u"record"_s, u"--device"_s, u"virtual:?capture="_s + capture, u"--seconds"_s,
                                 u"15"_s, u"--arm"_s, u"-o"_s, u"squeeze.csv"_s});
        process.setReadChannel(QProcess::StandardError); // where a person is told
        process.start();
        QByteArray told;
        while (!told.contains("Squeezing")) {
            QVERIFY2(process.waitForReadyRead(60'000), told.constData());
            told += process.readAllStandardError();
        }
        QCOMPARE(kill(static_cast<pid_t>(process.processId()), signal), 0);
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 4);
        QVERIFY(!QFile::exists(m_work.path(u"squeeze.csv"_s)));
        using enum protocol::ReportId;
        QCOMPARE(sentFromStop(capture), (QList<protocol::ReportId>{Stop, Stop, Stop}));
    }

    void aGripperThatGoesOnIsToldAndNothingIsWritten()
    {
        // Proved to have a watchdog, and then it has none and hears no Stop. 35 N are above what this program
        // allows (33 N and a twentieth), and below where the gripper stops by itself (1 N more).
        m_work.write(u"stubborn.txt"_s, "3.0 no-watchdog\n3.0 deaf stop\n3.0 deaf disarm\n5.0 load 5\n");
        const ProgramRun run =
            m_work.cli({u"record"_s, u"--device"_s, u"virtual:?script="_s + m_work.path(u"stubborn.txt"_s),
                        u"--seconds"_s, u"8"_s, u"--arm"_s, u"-o"_s, u"stubborn.csv"_s});
        QCOMPARE(run.exit, 4);
        QVERIFY2(run.err.contains("did not obey Stop. Switch off its power."), run.err.constData());
        QVERIFY(!QFile::exists(m_work.path(u"stubborn.csv"_s)));
    }
};

GRIPSCOPE_TEST(AskedToEndTest)
#include "asked_to_end_test.moc"
