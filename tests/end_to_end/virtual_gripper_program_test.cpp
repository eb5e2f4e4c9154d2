// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says before anything is plugged in; hid_vm.sh has it plug in.
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

ProgramRun run(const QStringList& arguments, const QString& folder = {})
{
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(QStringLiteral(GRIPSCOPE_BIN_DIR "/gripscope-virtual-gripper"), arguments);
    const bool ended = process.waitForFinished(60'000) && process.exitStatus() == QProcess::NormalExit;
    return {ended ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace

class VirtualGripperProgramTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase()
    {
#ifndef Q_OS_LINUX
        QSKIP("the program is made for Linux only");
#endif
        QVERIFY(QFile::exists(QStringLiteral(GRIPSCOPE_BIN_DIR "/gripscope-virtual-gripper")));
    }

    void helpNamesEveryFault()
    {
        const ProgramRun help = run({u"--help"_s});
        QCOMPARE(help.exit, 0);
        QVERIFY(help.err.isEmpty());
        for (const char* word :
             {"--script",   "loss",   "duplicate",     "crc",     "saturate", "stuck",  "units",
              "stall",      "resume", "clock",         "unplug",  "replug",   "deaf",   "hang-feature",
              "hang-write", "broken", "modprobe uhid", "object=", "seed=",    "noise=", "speed="})
            QVERIFY2(help.out.contains(word), word);
    }

    void whatMakesNoSenseIsTold_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("named");
        QTest::newRow("unknown option") << QStringList{u"--fast"_s} << u"--fast"_s;
        QTest::newRow("not virtual") << QStringList{u"hid:"_s} << u"only virtual:"_s;
        QTest::newRow("no time") << QStringList{u"virtual:?speed=0"_s} << u"speed above 0"_s;
        QTest::newRow("a capture") << QStringList{u"virtual:?capture=x"_s} << u"no capture"_s;
        QTest::newRow("unknown fault") << QStringList{u"virtual:?fault=fire"_s} << u"fault=fire"_s;
        QTest::newRow("twice the same")
            << QStringList{u"virtual:?object=A"_s, u"virtual:?object=B"_s} << u"VG-1"_s;
        QTest::newRow("no script") << QStringList{u"--script"_s} << u"--script"_s;
    }
    void whatMakesNoSenseIsTold()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, named);
        const ProgramRun done = run(arguments);
        QCOMPARE(done.exit, 2);
        QVERIFY(done.out.isEmpty());
        QVERIFY2(done.err.contains(named.toUtf8()), done.err.constData());
    }

    void aScriptIsReadBeforeAnythingIsPluggedIn()
    {
        const Workplace place;
        place.write(u"faults.txt"_s, "1 stall\n2 fire\n");
        const ProgramRun done = run({u"--script"_s, u"faults.txt"_s}, place.path({}));
        QCOMPARE(done.exit, 3);
        QVERIFY2(done.err.contains("faults.txt:2:3"), done.err.constData());
        QCOMPARE(run({u"--script"_s, u"/nowhere/x"_s}).exit, 3);
    }

    void whereTheKernelHasNoUhidItSaysWhatToDo()
    {
        if (QFile::exists(u"/dev/uhid"_s))
            QSKIP("/dev/uhid is there");
        const ProgramRun done = run({u"virtual:?seed=1"_s, u"virtual:?seed=2"_s});
        QCOMPARE(done.exit, 4);
        QVERIFY2(done.err.contains("sudo modprobe uhid"), done.err.constData());
    }
};

GRIPSCOPE_TEST(VirtualGripperProgramTest)
#include "virtual_gripper_program_test.moc"
