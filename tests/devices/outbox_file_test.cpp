// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/outbox_file.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;

namespace {

struct Folder {
    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("mqtt"));
    [[nodiscard]] QByteArray bytes() const
    {
        QFile in(file);
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    void put(const QByteArray& bytes) const
    {
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly | QIODevice::Truncate));
        out.write(bytes);
    }
    [[nodiscard]] std::unique_ptr<OutboxFile> open() const
    {
        Expected<std::unique_ptr<OutboxFile>> opened = OutboxFile::open(file);
        return opened ? std::move(*opened) : nullptr;
    }
};

QByteArray sequencesOf(const OutboxFile& file)
{
    QByteArray all;
    for (const OutboxFile::Waiting& one : file.contents().waiting)
        all += QByteArray::number(qulonglong(one.sequence)) + ':' + one.bytes + ' ';
    return all.trimmed();
}

} // namespace

class OutboxFileTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsNotAcknowledgedIsThereAgain()
    {
        const Folder at;
        {
            const auto file = at.open();
            QCOMPARE(*file->add("a"), 1u);
            QCOMPARE(*file->add("b"), 2u);
            QCOMPARE(*file->add("c"), 3u);
            QVERIFY(file->acknowledge(1));
        }
        const auto file = at.open();
        QCOMPARE(sequencesOf(*file), QByteArray("2:b 3:c"));
        QCOMPARE(*file->add("d"), 4u);
    }
    void sequencesAndSessionsGoOnWhenAllIsAcknowledged()
    {
        const Folder at;
        {
            const auto file = at.open();
            QCOMPARE(int(*file->nextBirth()), 0);
            QCOMPARE(*file->add("a"), 1u);
            QVERIFY(file->skip()); // the second had no room
            QVERIFY(file->acknowledge(1));
        }
        const auto file = at.open();
        QCOMPARE(int(*file->nextBirth()), 1);
        QCOMPARE(*file->add("c"), 3u);
    }
    void sessionsCountTo255()
    {
        const Folder at;
        const auto file = at.open();
        for (int i = 0; i < 260; ++i)
            QCOMPARE(int(*file->nextBirth()), i % 256);
    }
    /// Wherever a program is killed, or the power goes, what stood whole before is there.
    void aTornTailLosesNothingBeforeIt()
    {
        const Folder at;
        qint64 whole = 0;
        {
            const auto file = at.open();
            QVERIFY(file->add("first"));
            QVERIFY(file->add("second"));
            whole = file->size();
            QVERIFY(file->add("third"));
        }
        const QByteArray bytes = at.bytes();
        for (qsizetype length = qsizetype(whole); length < bytes.size(); ++length) {
            at.put(bytes.left(length));
            const auto file = at.open();
            QVERIFY(!file->contents().damaged);
            QCOMPARE(sequencesOf(*file), QByteArray("1:first 2:second"));
            QCOMPARE(*file->add("again"), 3u);
        }
    }
    void aDamagedRecordLosesNoOther()
    {
        const Folder at;
        qint64 from = 0, to = 0;
        {
            const auto file = at.open();
            QVERIFY(file->add("first"));
            from = file->size();
            QVERIFY(file->add("second"));
            to = file->size();
            QVERIFY(file->add("third"));
        }
        const QByteArray bytes = at.bytes();
        for (qsizetype i = qsizetype(from); i < qsizetype(to); ++i) {
            QByteArray damaged = bytes;
            damaged[i] = char(damaged[i] ^ 0x55);
            at.put(damaged);
            {
                const auto file = at.open();
                QVERIFY(file->contents().damaged);
                QCOMPARE(sequencesOf(*file), QByteArray("1:first 3:third"));
                QCOMPARE(*file->add("fourth"), 4u);
            }
            QVERIFY(!at.open()->contents().damaged); // it was told once
        }
    }
    void anyBytesAreRead()
    {
        const Folder at;
        for (const QByteArray& bytes : {QByteArray(), QByteArray("GS"), QByteArray("GSMQ"),
                                        QByteArray(5000, 'G'), QByteArray("GSMR").repeated(1000)}) {
            at.put(bytes);
            const auto file = at.open();
            QVERIFY(file);
            QVERIFY(file->contents().waiting.empty());
            QCOMPARE(*file->add("a"), 1u);
        }
    }
    void itStaysAsSmallAsWhatWaits()
    {
        const Folder at;
        const auto file = at.open();
        const QByteArray result(1000, 'r'); // a hundred are twice what is left standing
        QVERIFY(file->add("kept"));
        for (std::uint64_t i = 2; i < 200; ++i) {
            QCOMPARE(*file->add(result), i);
            if (i > 5)
                QVERIFY(file->acknowledge(i - 5)); // five wait
        }
        QVERIFY(file->size() <= OutboxFile::leastCompacted + 2000);
        QCOMPARE(at.bytes().size(), file->size());
        QCOMPARE(file->contents().waiting.size(), 5u);
    }
    void oneProgramHasIt()
    {
        const Folder at;
        auto first = at.open();
        QVERIFY(!at.open());
        for (std::uint64_t i = 1; i < 100; ++i) { // also after it was made anew
            QVERIFY(first->add(QByteArray(1000, 'b')));
            QVERIFY(first->acknowledge(i));
        }
        QVERIFY(!at.open());
        first.reset();
        QVERIFY(at.open());
    }
    void aFolderThatIsNotThereIsTold()
    {
        const auto opened = OutboxFile::open(QStringLiteral("/nowhere/at/all"));
        QVERIFY(!opened && opened.error().code == ErrorCode::FileUnwritable);
    }
};
GRIPSCOPE_TEST(OutboxFileTest)
#include "outbox_file_test.moc"
