// SPDX-License-Identifier: GPL-3.0-or-later
// What every subcommand does alike: help, usage errors, exit codes.
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class CommandLineTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

private slots:
    void nothingToDoIsAUsageErrorThatHelps()
    {
        const ProgramRun run = m_work.cli({});
        QCOMPARE(run.exit, 2);
        QVERIFY(run.out.isEmpty());
        QVERIFY(run.err.contains("identify"));
    }
    void helpIsThereForEveryCommand_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("demo") << QStringList{u"seed"_s};
        QTest::newRow("devices") << QStringList{};
        QTest::newRow("record") << QStringList{u"device"_s, u"seconds"_s, u"excitation"_s,
                                               u"peak"_s,   u"bias"_s,    u"bit"_s,
                                               u"arm"_s,    u"output"_s,  u"force-file"_s};
        QTest::newRow("simulate") << QStringList{
            u"object"_s,  u"excitation"_s,  u"peak"_s,     u"bias"_s, u"bit"_s,
            u"samples"_s, u"sample-time"_s, u"noise-sd"_s, u"seed"_s, u"hold"_s};
        QTest::newRow("identify") << QStringList{u"estimator"_s, u"hold"_s,         u"initial-state"_s,
                                                 u"offset"_s,    u"force-column"_s, u"position-unit"_s,
                                                 u"csv"_s,       u"time-column"_s,  u"decimal-comma"_s};
        QTest::newRow("cluster") << QStringList{u"features"_s, u"clusters"_s, u"method"_s, u"scaling"_s,
                                                u"seed"_s,     u"restarts"_s, u"truth"_s};
        QTest::newRow("enroll") << QStringList{u"library"_s, u"type"_s, u"sample-time"_s};
        QTest::newRow("classify") << QStringList{u"library"_s,         u"false-reject"_s, u"wrong-type"_s,
                                                 u"stranger-accept"_s, u"confidence"_s,   u"robust"_s,
                                                 u"refuse-overdue"_s,  u"most-lost"_s};
        QTest::newRow("types rename")
            << QStringList{u"library"_s, u"type"_s, u"to"_s, u"reason"_s, u"operator"_s};
        QTest::newRow("types guide") << QStringList{u"library"_s, u"type"_s};
        QTest::newRow("reproduce-paper") << QStringList{};
        QTest::newRow("design") << QStringList{u"object"_s,   u"peak"_s,    u"bias"_s,
                                               u"limit"_s,    u"seconds"_s, u"sample-time"_s,
                                               u"noise-sd"_s, u"scatter"_s, u"output"_s};
        QTest::newRow("study") << QStringList{u"runs"_s, u"seed"_s, u"threads"_s};
        QTest::newRow("study efficiency")
            << QStringList{u"runs"_s, u"seed"_s, u"estimators"_s, u"settings"_s, u"threads"_s};
        QTest::newRow("study early") << QStringList{u"runs"_s, u"stated-error"_s, u"strangers"_s};
    }
    void helpIsThereForEveryCommand()
    {
        QFETCH(QStringList, options);
        const QString command = QLatin1String(QTest::currentDataTag());
        const ProgramRun run = m_work.cli(command.split(u' ') << u"--help"_s);
        QCOMPARE(run.exit, 0);
        QVERIFY(run.err.isEmpty());
        QVERIFY(run.out.startsWith("Usage: gripscope-cli " + command.toUtf8() + " [options]"));
        QVERIFY(run.out.contains("--json"));
        for (const QString& option : options)
            QVERIFY2(run.out.contains("--" + option.toUtf8()), qPrintable(option));
        QVERIFY(m_work.cli({u"--help"_s}).out.contains(command.section(u' ', 0, 0).toUtf8()));
    }
    void aFileThatIsNoRecordingIsNotOverwritten()
    {
        const QStringList simulate{u"simulate"_s, u"--object"_s, u"1,1,1"_s,
                                   u"--json"_s,   u"-o"_s,       u"x.csv"_s};
        const QStringList record{u"record"_s, u"--device"_s, u"virtual:"_s, u"--seconds"_s,
                                 u"0.2"_s,    u"--json"_s,   u"-o"_s,       u"x.csv"_s};
        const auto bytes = [this] {
            QFile file(m_work.path(u"x.csv"_s));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        for (const QStringList& command : {simulate, record}) {
            m_work.write(u"x.csv"_s, "thesis, the only copy\n");
            const ProgramRun refused = m_work.cli(command);
            QCOMPARE(refused.exit, 5);
            const QString words = refused.json()[u"error"_s][u"message"_s].toString();
            QVERIFY2(words.contains(u"no recording of Gripscope"_s) && words.contains(u"--force"_s),
                     qPrintable(words));
            QCOMPARE(bytes(), "thesis, the only copy\n");
            QCOMPARE(m_work.cli(command + QStringList{u"--force"_s}).exit, 0);
            QVERIFY(bytes().startsWith("# gripscope-recording"));
            QCOMPARE(m_work.cli(command).exit, 0); // a script that runs again
            m_work.write(u"x.csv"_s, {});          // a name that mktemp made
            QCOMPARE(m_work.cli(command).exit, 0);
        }
    }
    void everyCommandIsInTheManual()
    {
        QFile page(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/resources/manual/commands.md"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QByteArray text = page.readAll();
        const QByteArray help = m_work.cli({u"--help"_s}).out;
        int commands = 0;
        const QByteArray list = help.mid(help.indexOf("Commands:\n") + 10);
        for (const QByteArray& line : list.left(list.indexOf("\n\n")).split('\n')) {
            const QByteArray name = line.trimmed().split(' ').first();
            QVERIFY2(text.contains('`' + name + '`'), name.constData());
            ++commands;
        }
        QVERIFY(commands > 15);
    }
    void theHelpSaysHowManyDocumentsThereAre_data()
    {
        QTest::addColumn<bool>("aLineEach");
        QTest::newRow("identify") << true;
        QTest::newRow("replay") << true;
        QTest::newRow("classify") << false;
    }
    void theHelpSaysHowManyDocumentsThereAre()
    {
        QFETCH(bool, aLineEach);
        const QString command = QLatin1String(QTest::currentDataTag());
        const QByteArray help = m_work.cli({command, u"--help"_s}).out.simplified(); // lines are broken
        QCOMPARE(help.contains("Writes a JSON document for each file, a line each,"), aLineEach);
        QCOMPARE(help.contains("Writes a JSON document to standard output"), !aLineEach);
    }
    void whatCannotBeUnderstoodIsExit2_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("hint");
        const auto row = [](const char* name, const QStringList& arguments, const QByteArray& hint) {
            QTest::newRow(name) << arguments << hint;
        };
        row("mistyped command", {u"identfy"_s}, "identify");
        row("unknown command", {u"frobnicate"_s}, "--help");
        row("unknown option", {u"identify"_s, u"--no-such-option"_s}, "no-such-option");
        row("mistyped option", {u"demo"_s, u"--sed"_s, u"1"_s}, "--seed");
        row("no file", {u"identify"_s}, "FILE");
        row("file where none belongs", {u"devices"_s, u"x"_s}, "x");
        row("value missing", {u"demo"_s, u"--seed"_s}, "seed");
        row("not a number", {u"demo"_s, u"--seed"_s, u"one"_s}, "one");
        row("not a choice", {u"identify"_s, u"--hold"_s, u"soh"_s, u"x.csv"_s}, "zoh, foh");
        row("no such estimator", {u"identify"_s, u"--estimator"_s, u"oee"_s, u"x.csv"_s}, "arx-mean-force");
        row("sample time of zero", {u"identify"_s, u"--sample-time"_s, u"0"_s, u"x.csv"_s}, "sample-time");
        row("levels of nothing",
            {u"simulate"_s, u"--object"_s, u"1,1,1"_s, u"--excitation"_s, u"levels"_s, u"-o"_s, u"x.csv"_s},
            "--force-file");
        row("two forces",
            {u"simulate"_s, u"--object"_s, u"1,1,1"_s, u"--excitation"_s, u"step"_s, u"--force-file"_s,
             u"f.csv"_s, u"-o"_s, u"x.csv"_s},
            "another one");
        row("no type", {u"enroll"_s, u"x.csv"_s}, "--type");
        row("a share that is none", {u"classify"_s, u"--most-lost"_s, u"2"_s, u"x.csv"_s}, "--most-lost");
        row("a rate that is none", {u"classify"_s, u"--false-reject"_s, u"2"_s, u"x.csv"_s}, "");
        row("no device", {u"record"_s, u"-o"_s, u"x.csv"_s}, "--device");
        row("an address that is none", {u"record"_s, u"--device"_s, u"usb:1"_s, u"-o"_s, u"x.csv"_s},
            "virtual:");
        row("no output", {u"simulate"_s, u"--object"_s, u"1,1,1"_s}, "-o");
        row("an object that is none", {u"simulate"_s, u"--object"_s, u"1,1"_s, u"-o"_s, u"x.csv"_s}, "m,b,k");
        row("no object to design for", {u"design"_s}, "--object");
        row("no room below the crush limit",
            {u"design"_s, u"--object"_s, u"1,1,1"_s, u"--limit"_s, u"1"_s, u"--bias"_s, u"2"_s,
             u"--seconds"_s, u"50"_s, u"--sample-time"_s, u"0.05"_s},
            "limit");
        row("no such study", {u"study"_s, u"efficency"_s}, "efficiency");
        row("an estimator the study lacks", {u"study"_s, u"efficiency"_s, u"--estimators"_s, u"ols"_s},
            "arx-mean-force");
        row("an option of another study", {u"study"_s, u"recognition"_s, u"--estimators"_s, u"oe"_s},
            "estimators");
        row("no such setting", {u"study"_s, u"efficiency"_s, u"--settings"_s, u"E"_s}, "A-prbs-90-200");
        row("no cluster", {u"cluster"_s, u"t.csv"_s, u"--clusters"_s, u"0"_s}, "clusters");
    }
    void whatCannotBeUnderstoodIsExit2()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, hint);
        const ProgramRun run = m_work.cli(arguments);
        QCOMPARE(run.exit, 2);
        QVERIFY(run.out.isEmpty());
        QVERIFY2(run.err.contains(hint), run.err.constData());
    }
    void aServersAddressWithAPasswordIsRefusedAndNotShown()
    {
        m_work.write(u"r.csv"_s, "u,y\n1,2\n2,3\n");
        const ProgramRun run =
            m_work.cli({u"classify"_s, u"--library"_s, u"postgresql://me:Geheim1@host/name"_s, u"r.csv"_s});
        QCOMPARE(run.exit, 5);
        QVERIFY2(run.err.contains(".pgpass") && !run.err.contains("Geheim1"), run.err.constData());
    }
    void aServerThatDoesNotAnswerIsNamed()
    {
        const ProgramRun run =
            m_work.cli({u"types"_s, u"list"_s, u"--library"_s, u"postgresql://me@127.0.0.1:1/name"_s});
        QCOMPARE(run.exit, 5);
        QVERIFY2(run.err.contains("no server answers at 127.0.0.1:1"), run.err.constData());
    }
    void theVirtualGripperIsAlwaysAmongTheDevices()
    {
        const QJsonObject document = m_work.cli({u"devices"_s, u"--json"_s}).json();
        const QJsonArray devices = document[u"devices"].toArray();
        QVERIFY(!devices.isEmpty());
        const QJsonObject first = devices[0].toObject();
        QCOMPARE(first[u"address"].toString(), u"virtual:"_s);
        for (const auto key : {"serial", "name", "state"})
            QVERIFY(first.contains(QLatin1String(key)));
    }
    void severalThingsAmissTellTheLowestNumber()
    {
        // an invalid measurement (6), a file that is not there (3)
        QByteArray constant = "u,y\n";
        for (int i = 0; i < 100; ++i)
            constant += "1,1\n";
        m_work.write(u"constant.csv"_s, constant);
        const QStringList reading{u"--force-column"_s, u"u"_s,   u"--position-column"_s, u"y"_s,
                                  u"--sample-time"_s,  u"0.05"_s};
        QCOMPARE(m_work.cli(QStringList{u"identify"_s, u"constant.csv"_s} + reading).exit, 6);
        QCOMPARE(m_work.cli(QStringList{u"identify"_s, u"constant.csv"_s, u"missing.csv"_s} + reading).exit,
                 3);
        QCOMPARE(m_work.cli(QStringList{u"identify"_s, u"missing.csv"_s, u"constant.csv"_s} + reading).exit,
                 3);
    }
    void aLibraryThatCannotBeOpenedIsExit5()
    {
        m_work.write(u"noise.db"_s, QByteArray(8192, 'x'));
        m_work.write(u"r.csv"_s, "u,y\n1,2\n2,3\n");
        QCOMPARE(m_work.cli({u"classify"_s, u"--library"_s, u"missing.db"_s, u"r.csv"_s}).exit, 5);
        QVERIFY(!QFile::exists(m_work.path(u"missing.db"_s))); // asking must not make one
        QCOMPARE(m_work.cli({u"classify"_s, u"--library"_s, u"noise.db"_s, u"r.csv"_s}).exit, 5);
        const ProgramRun run = m_work.cli(
            {u"enroll"_s, u"--json"_s, u"--library"_s, u"no/folder/x.db"_s, u"--type"_s, u"A"_s, u"r.csv"_s});
        QCOMPARE(run.exit, 5);
        QCOMPARE(run.json()[u"error"][u"code"].toString(), u"storage_open"_s);
    }
};

GRIPSCOPE_TEST(CommandLineTest)
#include "command_line_test.moc"
