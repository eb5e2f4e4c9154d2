// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions that are kept: bounded, in parts, with hashes; and disks that are full, slow or gone.
#include "devices/replay/capture_folder.h"
#include "devices/replay/capture_reader.h"
#include "devices/replay/capture_transport.h"
#include "tests/devices/watched_transport.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using Condition = CaptureFolder::Condition;
using Clock = std::chrono::steady_clock;

namespace {

const std::vector<std::uint8_t> report(64, 7);

/// A squeeze of the virtual gripper whose reports go to `destination`, and how the capture fared.
struct CapturedSqueezeRun {
    explicit CapturedSqueezeRun(const CaptureDestination& destination, double speed = 0)
    {
        OpenPort gripper(std::make_unique<DevicePort>(u"virtual:"_qs, [&] {
            return std::make_shared<CapturingTransport>(Watched::transport(speed), destination, monitor);
        }));
        state = gripper.squeeze(usualForce(2000));
        gripper.port->drain(gripper.samples);
        samples = gripper.samples.size();
        counters = gripper.port->counters();
        const auto before = Clock::now();
        gripper.port->close();
        closing = Clock::now() - before;
    }

    std::shared_ptr<CaptureMonitor> monitor = std::make_shared<CaptureMonitor>();
    SqueezeState state = SqueezeState::Idle;
    std::size_t samples = 0;
    LinkCounters counters;
    Clock::duration closing{};
};

/// A part of a folder, made up: `squeezes` below 0 is one that was not closed.
void addPart(const CaptureFolder& folder, const QString& name, qsizetype bytes, qint64 squeezes)
{
    QFile file(folder.filePath(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(bytes, 'x'));
    if (squeezes >= 0)
        QVERIFY(folder.list({name, bytes, QString(64, u'0'), squeezes}).has_value());
}

QStringList names(const std::vector<CaptureFolder::Part>& parts)
{
    QStringList out;
    for (const CaptureFolder::Part& part : parts)
        out << part.name;
    return out;
}

/// A busy computer may close the files a little after the port.
bool allClosed(const CaptureFolder& folder)
{
    return waitFor([&] {
        const std::vector<CaptureFolder::Part> parts = folder.parts();
        return !parts.empty() && std::all_of(parts.begin(), parts.end(),
                                             [](const CaptureFolder::Part& part) { return part.closed(); });
    });
}

/// The kinds of the records of a part.
std::vector<CaptureKind> kinds(const QString& file)
{
    std::vector<CaptureKind> out;
    const std::vector<CaptureRecord> records = readCapture(file).value();
    for (const CaptureRecord& record : records)
        out.push_back(record.kind);
    return out;
}

} // namespace

class KeptCapturesTest : public QObject {
    Q_OBJECT
private slots:
    void aSessionIsKeptClosedAndListed()
    {
        const QTemporaryDir place;
        const CaptureFolder folder(place.filePath(u"captures"_qs));
        DeviceFactory factory;
        factory.keepSessions(KeepSessions{folder.path(), {}, true});
        OpenPort gripper(factory.create(u"virtual:?speed=0"_qs).value());
        QCOMPARE(gripper.squeeze(usualForce(200)), SqueezeState::Finished);
        const QString session = gripper.port->identity().keptSession;
        gripper.port->close();

        QVERIFY(allClosed(folder));
        const std::vector<CaptureFolder::Part> parts = folder.parts();
        QCOMPARE(names(parts), QStringList{session + u".part0001.gscap"_qs});
        QVERIFY(parts.front().closed());
        QVERIFY(folder.check(parts.front()).condition == Condition::Whole);
        QVERIFY(!factory.captureStatus().problem);
        QCOMPARE(factory.captureStatus().session, session);
        QCOMPARE(factory.captureStatus().droppedRecords, std::uint64_t(0));
    }

    void whatWasChangedSinceIsFound()
    {
        const QTemporaryDir place;
        const CaptureDestination to{{}, place.path(), u"virtual:"_qs};
        QCOMPARE(CapturedSqueezeRun(to).state, SqueezeState::Finished);
        const CaptureFolder folder(place.path());
        QVERIFY(allClosed(folder));
        QFile file(folder.filePath(folder.parts().front().name));
        QVERIFY(file.open(QIODevice::ReadWrite) && file.seek(file.size() / 2));
        char byte = 0;
        QVERIFY(file.peek(&byte, 1) == 1);
        byte = static_cast<char>(byte ^ 1);
        QVERIFY(file.write(&byte, 1) == 1);
        file.close();
        QVERIFY(folder.check(folder.parts().front()).condition == Condition::Changed);
    }

    void whatWasNotClosedIsSaidToBeSoWithItsWholeRecords()
    {
        const QTemporaryDir place;
        const CaptureFolder folder(place.path());
        QFile file(folder.filePath(u"s.part0001.gscap"_qs));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(captureHeader() + encodeRecord(1, CaptureKind::Input, report) +
                   encodeRecord(2, CaptureKind::Input, report).left(30));
        file.close();
        const CaptureFolder::Checked checked = folder.check(folder.parts().front());
        QVERIFY(checked.condition == Condition::NotClosed);
        QVERIFY2(checked.words.contains(u"1 whole records, 30 bytes"_qs), qPrintable(checked.words));
    }

    void aLongSessionGoesOnInFurtherPartsThatReadAsOne()
    {
        const QTemporaryDir place;
        CaptureDestination to{{}, place.path(), u"virtual:"_qs};
        to.limits.partBytes = 1; // each time the disk is visited
        const auto monitor = std::make_shared<CaptureMonitor>();
        const auto writer = CaptureWriter::create(to, monitor).value();
        writer->add(CaptureKind::Feature, report);
        for (std::uint64_t i = 1; i <= 3; ++i) {
            writer->add(CaptureKind::Input, std::vector<std::uint8_t>{static_cast<std::uint8_t>(i)});
            QVERIFY(waitFor([&] { return monitor->status().records == i + 1; }));
        }
        QVERIFY(writer->finishBy(Clock::now() + patience));
        const CaptureFolder folder(place.path());
        const std::vector<CaptureFolder::Part> parts = folder.parts();
        QVERIFY(parts.size() >= 3); // four, when the feature had gone before
        for (const CaptureFolder::Part& part : parts) {
            QVERIFY(folder.check(part).condition == Condition::Whole);
            const auto part_kinds = kinds(folder.filePath(part.name));
            QVERIFY(part_kinds[0] == CaptureKind::Note && part_kinds[1] == CaptureKind::Feature);
        }
        std::vector<std::uint8_t> inputs;
        const std::vector<CaptureRecord> records = readCapture(folder.filePath(parts.front().name)).value();
        for (const CaptureRecord& record : records)
            if (record.kind == CaptureKind::Input)
                inputs.push_back(record.bytes.front());
        QVERIFY((inputs == std::vector<std::uint8_t>{1, 2, 3}));
    }

    void theOldestWithoutASqueezeGoFirst()
    {
        const QTemporaryDir place;
        const CaptureFolder folder(place.path());
        addPart(folder, u"a.part0001.gscap"_qs, 100, 2);
        addPart(folder, u"b.part0001.gscap"_qs, 100, 0);
        addPart(folder, u"c.part0001.gscap"_qs, 100, -1);
        addPart(folder, u"d.part0001.gscap"_qs, 100, 0);
        addPart(folder, u"e.part0001.gscap"_qs, 100, 1);
        QCOMPARE(names(folder.prune(500).removed), QStringList());
        QCOMPARE(names(folder.prune(420).removed), QStringList{u"b.part0001.gscap"_qs});
        // Those with squeezes only when they alone are too much, oldest first; of those not closed one cannot
        // know.
        QCOMPARE(names(folder.prune(150, u"e.part0001.gscap"_qs).removed),
                 (QStringList{u"d.part0001.gscap"_qs, u"a.part0001.gscap"_qs, u"c.part0001.gscap"_qs}));
        const std::vector<CaptureFolder::Part> left = folder.parts();
        QCOMPARE(names(left), QStringList{u"e.part0001.gscap"_qs});
        QVERIFY(left.front().closed());
        QCOMPARE(left.front().squeezes, std::optional<qint64>(1));
    }

    void newPartsMakeRoomForThemselves()
    {
        const QTemporaryDir place;
        const CaptureFolder folder(place.path());
        addPart(folder, u"1.part0001.gscap"_qs, 3000, 0);
        addPart(folder, u"1.part0002.gscap"_qs, 3000, 1);
        CaptureDestination to{{}, place.path(), u"virtual:"_qs};
        to.limits.totalBytes = 5000;
        to.limits.partBytes = 1000;
        const auto monitor = std::make_shared<CaptureMonitor>();
        const auto writer = CaptureWriter::create(to, monitor).value();
        writer->add(CaptureKind::Input, report);
        QVERIFY(writer->finishBy(Clock::now() + patience));
        const QStringList left = names(folder.parts());
        QCOMPARE(left.size(), 2);
        QVERIFY(left.contains(u"1.part0002.gscap"_qs));
        const std::vector<CapturePruning> told = monitor->takePrunings();
        QCOMPARE(told.size(), std::size_t(1));
        QCOMPARE(told[0].folder, place.path());
        QCOMPARE(told[0].parts, QStringList{u"1.part0001.gscap"_qs});
        QCOMPARE(told[0].bytes, 3000);
        QVERIFY(monitor->takePrunings().empty()); // once
    }

    void aFullDiskCostsTheCaptureAndNothingElse()
    {
        QVERIFY(QFile::exists(u"/dev/full"_qs));
        const CapturedSqueezeRun run({u"/dev/full"_qs, {}, u"virtual:"_qs});
        QCOMPARE(run.state, SqueezeState::Finished);
        QCOMPARE(run.samples, std::size_t(100 + 2000 + 120));
        QCOMPARE(run.counters.droppedSamples, std::uint64_t(0));
        const CaptureStatus status = run.monitor->status();
        QVERIFY(status.problem && status.problem->code == ErrorCode::FileUnwritable);
        QCOMPARE(status.records, std::uint64_t(0));
        QVERIFY(status.droppedRecords >= run.counters.reports);
    }

    void aDiskThatHangsIsLeftBehind()
    {
        std::signal(SIGPIPE, SIG_IGN); // when the pipe closes at the end
        const QTemporaryDir place;
        const QByteArray pipe = place.filePath(u"pipe"_qs).toLocal8Bit();
        QCOMPARE(::mkfifo(pipe.constData(), 0600), 0);
        const int reader = ::open(pipe.constData(), O_RDONLY | O_NONBLOCK); // which never reads
        QVERIFY(reader >= 0);
        CaptureDestination to{QString::fromLocal8Bit(pipe), {}, u"virtual:"_qs};
        to.limits.bufferBytes = 100'000; // a pipe holds 65,536 bytes; the squeeze has some 90,000
        CapturedSqueezeRun run(to);
        QCOMPARE(run.state, SqueezeState::Finished);
        QCOMPARE(run.samples, std::size_t(100 + 2000 + 120));
        QVERIFY(run.closing < std::chrono::seconds(2)); // it promises one
        ::close(reader);                                // and lets the thread go
    }

    void whatFindsNoRoomIsCountedAndTold()
    {
        const QTemporaryDir place;
        CaptureDestination to{place.filePath(u"x.gscap"_qs), {}, {}};
        to.limits.bufferBytes = 3 * (64 + captureRecordHead);
        const auto monitor = std::make_shared<CaptureMonitor>();
        const auto writer = CaptureWriter::create(to, monitor).value();
        QVERIFY(waitFor([&] { // in one visit of the disk's
            for (int i = 0; i < 10; ++i)
                writer->add(CaptureKind::Input, report);
            return monitor->status().droppedRecords >= 7;
        }));
        const std::uint64_t before = monitor->status().droppedRecords;
        QVERIFY(waitFor([&] { return monitor->status().records > 0; }));
        writer->add(CaptureKind::Input, report);
        QVERIFY(writer->finishBy(Clock::now() + patience));
        std::uint64_t told = 0;
        const std::vector<CaptureRecord> records = readCapture(to.file).value();
        for (const CaptureRecord& record : records)
            if (record.kind == CaptureKind::Note && record.note().startsWith(u"dropped\n"_qs))
                told += record.note().section(u": "_qs, 1).trimmed().toULongLong();
        QCOMPARE(told, before);
    }

    void aFolderThatGoesAwayIsMadeAgain()
    {
        const QTemporaryDir place;
        const QString path = place.filePath(u"captures"_qs);
        const auto monitor = std::make_shared<CaptureMonitor>();
        const auto writer = CaptureWriter::create({{}, path, u"virtual:"_qs}, monitor).value();
        writer->add(CaptureKind::Input, report);
        QVERIFY(waitFor([&] { return monitor->status().records == 1; }));
        QVERIFY(QDir(path).removeRecursively());
        std::optional<Error> problem;
        QVERIFY(waitFor([&] {
            writer->add(CaptureKind::Input, report);
            problem = monitor->status().problem;
            return problem.has_value();
        }));
        QVERIFY(problem->code == ErrorCode::FileUnwritable);
        QVERIFY(waitFor([&] {
            writer->add(CaptureKind::Input, report);
            return !monitor->status().problem;
        }));
        QVERIFY(monitor->status().droppedRecords > 0);
        QVERIFY(writer->finishBy(Clock::now() + patience));
        const std::vector<CaptureFolder::Part> parts = CaptureFolder(path).parts();
        QCOMPARE(parts.size(), std::size_t(1));
        QVERIFY(parts.front().closed());
    }

    void aFolderThatCannotBeMadeKeepsNobodyFromMeasuring()
    {
        const CapturedSqueezeRun run({{}, u"/dev/null/captures"_qs, u"virtual:"_qs});
        QCOMPARE(run.state, SqueezeState::Finished);
        QVERIFY(run.monitor->status().problem.has_value());
        QVERIFY(run.monitor->status().droppedRecords > 0);
    }
};

GRIPSCOPE_TEST(KeptCapturesTest)
#include "kept_captures_test.moc"
