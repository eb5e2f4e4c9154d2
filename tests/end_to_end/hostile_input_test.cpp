// SPDX-License-Identifier: GPL-3.0-or-later
// Files and arguments that were made to do harm, given to the command line itself: it answers in words, at
// once.
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <sys/stat.h>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class HostileInputTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

private slots:
    void everyReaderRefusesAPipeAndAnEndlessFile_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("identify") << QStringList{u"identify"_s};
        QTest::newRow("cluster") << QStringList{u"cluster"_s, u"--features"_s, u"m,b,k"_s, u"--clusters"_s,
                                                u"2"_s};
        QTest::newRow("calibrate") << QStringList{u"calibrate"_s};
        QTest::newRow("profile check") << QStringList{u"profile"_s, u"check"_s};
        QTest::newRow("replay") << QStringList{u"replay"_s};
        QTest::newRow("types list") << QStringList{u"types"_s, u"list"_s, u"--library"_s};
    }
    void everyReaderRefusesAPipeAndAnEndlessFile()
    {
        QFETCH(QStringList, arguments);
        QCOMPARE(mkfifo(qPrintable(m_work.path(u"pipe"_s)), 0600), 0);
        QFile sparse(m_work.path(u"sparse.csv"_s));
        QVERIFY(sparse.open(QIODevice::WriteOnly) && sparse.resize(10'000'000'000));
        for (const QString& name : {u"pipe"_s, u"/dev/zero"_s, u"sparse.csv"_s}) {
            const ProgramRun run = m_work.cli(arguments + QStringList{name});
            QVERIFY2(run.exit >= 2 && run.exit <= 5, qPrintable(name));
            QVERIFY2(run.err.size() > 10 && run.err.size() < 2000, run.err.left(2000).constData());
        }
        QFile::remove(m_work.path(u"pipe"_s));
    }
    void aMessageIsNotAsLongAsTheLineItIsAbout()
    {
        m_work.write(u"line.csv"_s,
                     "# sample_time_s: 0.1\nforce,position\n" + QByteArray(50'000'000, '7') + '\n');
        const ProgramRun run = m_work.cli({u"identify"_s, u"line.csv"_s});
        QCOMPARE(run.exit, 3);
        QVERIFY(run.err.contains("65536"));
        QVERIFY(run.err.size() < 1000);
    }
    void numbersBeyondReasonAreUsageErrors_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const QStringList simulate{u"simulate"_s, u"--object"_s, u"1,1,1"_s, u"-o"_s, u"x.csv"_s};
        const QStringList record{u"record"_s, u"--device"_s, u"virtual:?speed=0"_s, u"-o"_s, u"x.csv"_s};
        QTest::newRow("a million years") << record + QStringList{u"--seconds"_s, u"1e12"_s};
        QTest::newRow("endless") << record + QStringList{u"--seconds"_s, u"inf"_s};
        QTest::newRow("no time") << record + QStringList{u"--seconds"_s, u"nan"_s};
        QTest::newRow("samples") << simulate + QStringList{u"--samples"_s, u"1e15"_s};
        QTest::newRow("more samples") << simulate + QStringList{u"--samples"_s, u"99999999999999999999"_s};
        QTest::newRow("sample time") << simulate + QStringList{u"--sample-time"_s, u"1e-22"_s};
        QTest::newRow("peak") << simulate + QStringList{u"--peak"_s, u"1e300"_s};
        QTest::newRow("what grows beyond")
            << simulate + QStringList{u"--object"_s, u"1e-30,0,0"_s, u"--peak"_s, u"1e29"_s};
        QTest::newRow("prune") << QStringList{u"captures"_s, u"prune"_s, u"--limit"_s, u"1e30"_s};
        QTest::newRow("watch") << QStringList{u"profile"_s,  u"watch"_s,     u"--device"_s,
                                              u"virtual:"_s, u"--seconds"_s, u"1e300"_s};
    }
    void numbersBeyondReasonAreUsageErrors()
    {
        QFETCH(QStringList, arguments);
        const ProgramRun run = m_work.cli(arguments);
        QCOMPARE(run.exit, 2);
        QVERIFY(!run.err.isEmpty());
    }
    void aRecordingLongerThanAnyIsRefusedBeforeItBegins()
    {
        const ProgramRun run = m_work.cli({u"record"_s, u"--device"_s, u"virtual:?speed=0"_s, u"-o"_s,
                                           u"x.csv"_s, u"--seconds"_s, u"80000"_s});
        QVERIFY(run.exit >= 2 && run.exit <= 4);
        QVERIFY(run.err.contains("what a recording can hold"));
    }
    void nothingFromAFileSteersTheTerminal()
    {
        const QByteArray evil = "\x1b]0;owned\x07\x1b[31m\xc2\x9b"
                                "31m\xe2\x80\xae";
        m_work.write(u"names.csv"_s, "# sample_time_s: 0.1\n" + evil + ",position\n1,2\n");
        m_work.write(QString::fromUtf8("f" + evil + ".csv"), "nothing\n");
        for (const QStringList& arguments :
             {QStringList{u"identify"_s, u"names.csv"_s},
              QStringList{u"identify"_s, QString::fromUtf8("f" + evil + ".csv")},
              QStringList{u"identify"_s, u"--json"_s, QString::fromUtf8("f" + evil + ".csv")},
              QStringList{u"record"_s, u"--device"_s, QString::fromUtf8(evil), u"-o"_s, u"x"_s},
              QStringList{QString::fromUtf8(evil)}}) {
            const ProgramRun run = m_work.cli(arguments);
            QVERIFY(run.exit > 0);
            for (const QByteArray& steering :
                 {QByteArray("\x1b"), QByteArray("\x07"), QByteArray("\xc2\x9b"), QByteArray("\xe2\x80\xae")})
                QVERIFY2(!run.out.contains(steering) && !run.err.contains(steering),
                         run.err.toPercentEncoding(" ").constData());
        }
    }
};

GRIPSCOPE_TEST(HostileInputTest)
#include "hostile_input_test.moc"
