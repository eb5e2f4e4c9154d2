// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connect_session.h"
#include "core/session/squeeze_job.h"
#include "devices/replay/capture.h"
#include "tests/devices/port_helpers.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using State = ConnectSession::State;

namespace {

/// A session on a virtual gripper, driven as a program drives it.
struct Program {
    DeviceFactory factory;
    ConnectSession connection{factory};
    SqueezeJob job{connection};

    bool until(const std::function<bool()>& condition)
    {
        return waitFor([&] {
            connection.poll();
            job.poll();
            return condition();
        });
    }
    bool connectTo(const QString& address)
    {
        return connection.connectTo(address).has_value() &&
               until([&] { return connection.state() == State::Connected; });
    }
    bool arm()
    {
        return connection.arm(u"tester"_qs).has_value() && until([&] { return connection.armed(); });
    }
    bool squeeze(double seconds = 0.2)
    {
        Recipe recipe;
        recipe.seconds = seconds;
        return job.start(recipe, 1).has_value() && until([&] {
                   return job.state() == SqueezeJob::State::Done || job.state() == SqueezeJob::State::Failed;
               });
    }
};

} // namespace

class ReconnectTest : public QObject {
    Q_OBJECT
private slots:
    void aVirtualGripperComesBackByItselfAndStreams()
    {
        Program program;
        QVERIFY(program.connectTo(u"virtual:?seed=5&fault=unplug:0.1,replug:0.05"_qs));
        QVERIFY(program.until([&] { return program.connection.state() == State::Lost; }));
        QVERIFY(program.connection.awaiting());
        const std::uint64_t before = program.connection.counters().samples;
        QVERIFY(before > 0);
        QVERIFY(program.until([&] { return program.connection.state() == State::Connected; }));
        QCOMPARE(program.connection.identity().serial, u"VG-5"_qs);
        QVERIFY(program.until([&] { return program.connection.counters().samples > before; }));
        QCOMPARE(program.connection.reconnections(), 1);
    }

    void withoutReplugItStaysAway()
    {
        Program program;
        QVERIFY(program.connectTo(u"virtual:?fault=unplug:0.05"_qs));
        QVERIFY(program.until([&] { return program.connection.state() == State::Lost; }));
        QVERIFY(!program.connection.awaiting());
    }

    void aSqueezeUnderWayIsLostWithWordsAndCanBeRepeated()
    {
        Program program;
        QVERIFY(program.connectTo(u"virtual:?speed=0&fault=unplug:0.45,replug:1"_qs));
        QVERIFY(program.arm());
        QVERIFY(program.squeeze()); // 0.31 s with its rest
        QCOMPARE(program.job.state(), SqueezeJob::State::Done);
        const std::vector<double> first = program.job.recording().position;
        QVERIFY(program.squeeze());
        QCOMPARE(program.job.state(), SqueezeJob::State::Failed);
        QCOMPARE(program.job.error()->code, ErrorCode::DeviceLost);
        QVERIFY(program.until([&] { return program.connection.state() == State::Connected; }));
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
        Program program;
        QVERIFY(program.connectTo(u"virtual:?fault=unplug:0.1,replug:0.05&capture="_qs + file));
        QVERIFY(program.until([&] { return program.connection.reconnections() == 1; }));
        const std::uint64_t before = program.connection.counters().samples;
        QVERIFY(program.until([&] { return program.connection.counters().samples > before; }));
        program.connection.disconnect();
        QVERIFY(readCapture(file).has_value());
        QVERIFY(readCapture(folder.filePath(u"grip-2.gscap"_qs)).has_value());
    }
};

GRIPSCOPE_TEST(ReconnectTest)
#include "reconnect_test.moc"
