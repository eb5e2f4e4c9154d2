// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/mqtt_words.h"
#include "devices/line/mqtt/result_sender.h"
#include "tests/support/patience.h"
#include "tests/support/test_registry.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// A program that answers as chronyc does.
QString program(const QTemporaryDir& folder, const QByteArray& script)
{
    QFile file(folder.filePath(u"chronyc"_s));
    if (!file.open(QIODevice::WriteOnly) || file.write("#!/bin/sh\n" + script) < 0 ||
        !file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner))
        qFatal("no program");
    return file.fileName();
}

} // namespace

class ClockWatchTest : public QObject {
    Q_OBJECT
private slots:
    void whatChronySaysIsKnownAndAskedOnceAMinute()
    {
        const QTemporaryDir folder;
        const QString asked = folder.filePath(u"asked"_s);
        ClockWatch watch(
            program(folder, "[ \"$*\" = '-n tracking' ] || exit 1\necho >>'" + asked.toLocal8Bit() +
                                "'\necho 'System time : 3.5 seconds slow of NTP time'\n"
                                "echo 'Root delay : 0.2 seconds'\n"
                                "echo 'Root dispersion : 0.1 seconds'\necho 'Leap status : Normal'\n"));
        QVERIFY(!watch.standing());
        watch.poll();
        QTRY_VERIFY_WITH_TIMEOUT(watch.standing().has_value(), int(patience.count()));
        QCOMPARE(watch.standing()->offset_s, -3.5);
        QCOMPARE(watch.standing()->dispersion_s, 0.2);
        watch.poll();
        QTest::qWait(50);
        QCOMPARE(QFile(asked).size(), 1);
        MqttLink link;
        link.on = link.connected = true;
        link.clock = watch.standing();
        QVERIFY(!mqttWords(link).well);
        QVERIFY(mqttWords(link).problems.at(0).describe().contains(u"-3.5 s off"_s));
        link.clock->offset_s = 0.02;
        QVERIFY(mqttWords(link).well);
    }
    void withoutChronyNothingIsKnown()
    {
        const QTemporaryDir folder;
        ClockWatch none(folder.filePath(u"nothing"_s));
        ClockWatch refuses(program(folder, "echo '506 Cannot talk to daemon'\nexit 1\n"));
        none.poll();
        refuses.poll();
        QTest::qWait(200);
        QVERIFY(!none.standing() && !refuses.standing());
    }
    /// One that hangs is no concern of who ends.
    void aProgramThatHangsIsLeft()
    {
        const QTemporaryDir folder;
        QElapsedTimer clock;
        {
            ClockWatch watch(program(folder, "exec sleep 100\n"));
            watch.poll();
            QTest::qWait(100);
            clock.start();
        }
        QVERIFY(clock.elapsed() < 50'000); // half of what it would be
    }
};

GRIPSCOPE_TEST(ClockWatchTest)
#include "clock_watch_test.moc"
