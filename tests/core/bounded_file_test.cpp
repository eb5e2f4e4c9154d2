// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bounded_file.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace gripscope;
using namespace Qt::StringLiterals;

class BoundedFileTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;
    QString written(const QByteArray& bytes)
    {
        QFile file(m_folder.filePath(u"a file"_s));
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() ? file.fileName()
                                                                                    : QString();
    }

private slots:
    void aFileIsReadUpToItsBudget()
    {
        const QString file = written(QByteArray(1000, 'x'));
        QCOMPARE(readBounded(file, 1000).value().size(), qsizetype(1000));
        const Expected<QByteArray> more = readBounded(file, 999);
        QCOMPARE(more.error().code, ErrorCode::FileUnreadable);
        QVERIFY2(more.error().describe().contains(u"larger than"_s), qPrintable(more.error().describe()));
        QVERIFY(readBounded(written({}), 10).value().isEmpty());
    }
    void theProgramsOwnResourcesAreFiles()
    {
        QVERIFY(readBounded(u":/paper/appendix.csv"_s, megabyte).value().size() > 100);
    }
    void aSparseFileIsRefusedByItsSize()
    {
        QFile file(m_folder.filePath(u"sparse"_s));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.resize(10'000 * megabyte));
        QVERIFY(readBounded(file.fileName(), 16 * megabyte).error().describe().contains(u"16 MB"_s));
    }
    void aFolderIsNamedAsOne()
    {
        QVERIFY(readBounded(m_folder.path(), 10).error().describe().contains(u"folder"_s));
    }
    void whatIsNotThereIsTheSystemsToSay()
    {
        QCOMPARE(readBounded(u"/no/such/file"_s, 10).error().code, ErrorCode::FileUnreadable);
    }
#ifdef Q_OS_UNIX
    void aPipeOrADeviceIsRefusedWithoutWaiting_data()
    {
        QTest::addColumn<QString>("name");
        const QString pipe = m_folder.filePath(u"pipe"_s);
        QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
        QTest::newRow("pipe") << pipe;
        QTest::newRow("endless device") << u"/dev/zero"_s;
    }
    void aPipeOrADeviceIsRefusedWithoutWaiting()
    {
        QFETCH(QString, name); // opened, the pipe would wait for a writer for ever
        const Expected<QByteArray> bytes = readBounded(name, megabyte);
        QCOMPARE(bytes.error().code, ErrorCode::FileUnreadable);
        QVERIFY(bytes.error().describe().contains(u"pipe"_s));
    }
#endif
};

GRIPSCOPE_TEST(BoundedFileTest)
#include "bounded_file_test.moc"
