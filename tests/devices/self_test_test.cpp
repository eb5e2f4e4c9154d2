// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/inspection/device_facts.h"
#include "devices/inspection/self_test.h"
#include "tests/devices/port_helpers.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using LineOutcome = SelfTestLine::Outcome;

class SelfTestTest : public QObject {
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    struct Run {
        DeviceFactory factory;
        ConnectSession connection{factory};
        SelfTest test{connection};

        bool begin(const QString& address) { return connection.connectTo(address) && test.start(); }
        bool poll()
        {
            connection.poll();
            test.poll();
            return test.state() == SelfTest::State::Done;
        }
        bool finish(const QString& address)
        {
            return begin(address) && waitFor([this] { return poll(); });
        }
        [[nodiscard]] SelfTestLine line(const QString& id) const
        {
            for (const SelfTestLine& line : test.lines())
                if (line.id == id)
                    return line;
            return {};
        }
    };
    QString scripted(const QString& name, const QByteArray& script)
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(script) != script.size())
            qFatal("no script");
        return u"virtual:?script="_s + file.fileName();
    }

private slots:
    void aGoodGripperPassesWithoutMoving()
    {
        Run run;
        bool moved = false;
        run.connection.addListener([&](const std::vector<Sample>& batch) {
            for (const Sample& sample : batch)
                moved = moved || (sample.status & (StatusMoving | StatusArmed)) != 0;
        });
        QVERIFY(run.finish(u"virtual:"_s));
        QVERIFY(!moved);
        QCOMPARE(run.test.lines().size(), std::size_t(8));
        // The clock and the rate are told by this computer's, which may be busy; the others are not.
        for (const SelfTestLine& line : run.test.lines())
            if (line.id != u"clock"_s && line.id != u"rate"_s)
                QVERIFY2(line.outcome == LineOutcome::Passed, qPrintable(line.name + u": "_s + line.figure));
        QVERIFY(std::abs(*run.line(u"rate"_s).value - 2000) < 200);
        QVERIFY(run.line(u"clock"_s).value);
        QVERIFY(std::abs(*run.line(u"force_noise"_s).value - 0.02) < 0.004);
    }

    void eachFaultFailsItsLine()
    {
        // Side by side, since each takes two seconds.
        struct Case {
            QByteArray script;
            QString failed;
            std::unique_ptr<Run> run = std::make_unique<Run>();
        };
        std::vector<Case> cases;
        const std::pair<QByteArray, QString> faults[] = {
            {"0 loss 0.05\n", u"sequence"_s}, {"0 duplicate 0.05\n", u"sequence"_s},
            {"0 crc 0.05\n", u"sequence"_s},  {"1 stall\n1.5 resume\n", u"sequence"_s},
            {"1 clock +0.5\n", u"clock"_s},   {"0 broken\n", u"status"_s},
            {"0 deaf stop\n", u"stop"_s}};
        for (const auto& [script, failed] : faults) {
            cases.emplace_back();
            cases.back().script = script;
            cases.back().failed = failed;
            QVERIFY(cases.back().run->begin(scripted(QString::number(cases.size()), script)));
        }
        QVERIFY(waitFor([&] {
            bool done = true;
            for (const Case& fault : cases)
                done = fault.run->poll() && done;
            return done;
        }));
        for (const Case& fault : cases) {
            QVERIFY2(!fault.run->test.passed(), fault.script.constData());
            const SelfTestLine line = fault.run->line(fault.failed);
            QVERIFY2(line.outcome == LineOutcome::Failed, (fault.script + line.figure.toUtf8()).constData());
            QVERIFY(!line.figure.isEmpty() && !line.advice.isEmpty());
        }
    }

    void aStuckSensorIsNotPassed()
    {
        Run run;
        QVERIFY(run.finish(u"virtual:?fault=stuck"_s));
        QVERIFY(run.line(u"position_noise"_s).outcome == LineOutcome::NotTested);
        QVERIFY(run.line(u"position_noise"_s).advice.contains(u"stuck"_s));
    }

    void aGripperThatGoesAwayIsTold()
    {
        Run run;
        QVERIFY(run.finish(u"virtual:?fault=unplug:0.5"_s));
        QVERIFY(!run.test.passed());
        QCOMPARE(run.test.lines().size(), std::size_t(1));
        QVERIFY(run.test.lines().front().outcome == LineOutcome::Failed);
    }

    void needsAGripperThatDoesNotSqueeze()
    {
        Run run;
        QVERIFY(!run.test.start());
    }

    void linesSayFigureAndLimit()
    {
        SelfTestEvidence evidence;
        evidence.identity.sampleTime_s = 0.001;
        evidence.identity.commandable = true;
        evidence.before.newestArrival = LinkCounters::TimePoint(std::chrono::seconds(1));
        evidence.after.newestArrival = LinkCounters::TimePoint(std::chrono::seconds(3));
        for (int i = 0; i < 2000; ++i)
            evidence.samples.push_back({std::uint64_t(i), 0.001 * i, i % 2 * 0.5, 0.1 * (i % 50), 0});
        evidence.after.reports = 1000;
        QCOMPARE(rateLine(evidence).figure, u"1000 samples in 500 reports a second"_s);
        QVERIFY(rateLine(evidence).outcome == LineOutcome::Passed);
        evidence.identity.sampleTime_s = 0.00102;
        QVERIFY(rateLine(evidence).outcome == LineOutcome::Failed);
        QVERIFY(forceNoiseLine(evidence).outcome == LineOutcome::Passed);    // half a count
        QVERIFY(positionNoiseLine(evidence).outcome == LineOutcome::Failed); // fourteen counts
        evidence.after.clocks.clock = RateDifference{-1500, 200};
        QVERIFY(clockLine(evidence).outcome == LineOutcome::Failed);
        evidence.after.clocks.clock = RateDifference{-1500, 800}; // it may be less
        QVERIFY(clockLine(evidence).outcome == LineOutcome::Passed);
        evidence.after.clocks.clock = RateDifference{12, 80};
        QCOMPARE(clockLine(evidence).figure, u"+12 ppm"_s);
        QVERIFY(stopLine(evidence).outcome == LineOutcome::Failed);
        evidence.identity.commandable = false;
        QVERIFY(stopLine(evidence).outcome == LineOutcome::NotTested);
    }

    void theVirtualGrippersDescriptorIsThatOfTheProtocol()
    {
        QVERIFY(!findDeviceFacts(u"virtual:"_s, u"VG-1"_s).descriptor.empty());
        QVERIFY(findDeviceFacts(u"replay:x.csv"_s, {}).descriptor.empty());
        QVERIFY(findDeviceFacts(u"nonsense"_s, {}).node.isEmpty());
    }
};

GRIPSCOPE_TEST(SelfTestTest)
#include "self_test_test.moc"
