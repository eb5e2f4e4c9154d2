// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture.h"
#include "tests/devices/connected_program.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using LinkPhase = ConnectSession::State;

class ReconnectTest : public QObject {
    Q_OBJECT
private slots:
    void aVirtualGripperComesBackByItselfAndStreams()
    {
        ConnectedProgram program;
        QVERIFY(program.connectTo(u"virtual:?seed=5&fault=unplug:0.1,replug:0.05"_qs));
        QVERIFY(program.untilState(LinkPhase::Lost));
        QVERIFY(program.connection.awaiting());
        QVERIFY(program.connection.counters().samples > 0);
        QVERIFY(program.untilState(LinkPhase::Connected));
        QCOMPARE(program.connection.identity().serial, u"VG-5"_qs);
        QVERIFY(program.untilSamples(1));
        QCOMPARE(program.connection.reconnections(), 1);
    }

    void withoutReplugItStaysAway()
    {
        ConnectedProgram program;
        QVERIFY(program.connectTo(u"virtual:?fault=unplug:0.05"_qs));
        QVERIFY(program.untilState(LinkPhase::Lost));
        QVERIFY(!program.connection.awaiting());
    }

    void aSqueezeUnderWayIsLostWithWordsAndCanBeRepeated()
    {
        ConnectedProgram program;
        QVERIFY(program.connectTo(u"virtual:?speed=0&fault=unplug:0.45,replug:1"_qs));
        QVERIFY(program.arm());
        QVERIFY(program.squeeze()); // 0.31 s with its rest
        QCOMPARE(program.job.state(), SqueezeJob::State::Done);
        const std::vector<double> first = program.job.recording().position;
        QVERIFY(program.squeeze());
        QCOMPARE(program.job.state(), SqueezeJob::State::Failed);
        QCOMPARE(program.job.error()->code, ErrorCode::DeviceLost);
        QVERIFY(program.untilState(LinkPhase::Connected));
        QVERIFY(!program.connection.armed());
        QVERIFY(!program.squeeze()); // not before a person armed it again
        QVERIFY(program.arm());
        QVERIFY(program.squeeze());
        QCOMPARE(program.job.state(), SqueezeJob::State::Done);
        QVERIFY(program.job.recording().position != first); // it goes on, it does not begin anew
    }

    void eachLinkHasACaptureOfItsOwn()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"grip.gscap"_qs);
        ConnectedProgram program;
        QVERIFY(program.connectTo(u"virtual:?fault=unplug:0.1,replug:0.05&capture="_qs + file));
        QVERIFY(program.until([&] { return program.connection.reconnections() == 1; }));
        QVERIFY(program.untilSamples(1));
        program.connection.disconnect();
        QVERIFY(readCapture(file).has_value());
        QVERIFY(readCapture(folder.filePath(u"grip-2.gscap"_qs)).has_value());
    }
};

GRIPSCOPE_TEST(ReconnectTest)
#include "reconnect_test.moc"
