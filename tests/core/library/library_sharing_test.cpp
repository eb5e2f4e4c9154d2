// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/verification/library_verification.h"
#include "tests/core/library/child_process.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QSet>
#include <QTest>

#include <thread>

using namespace gripscope;
using namespace gripscope::test;

class LibrarySharingTest : public QObject {
    Q_OBJECT
private slots:
    void manyOpenANewFileAtOnce()
    {
        const LibraryFolder folder;
        const QString file = folder.file();
        std::vector<std::thread> threads;
        for (int i = 0; i < 8; ++i)
            threads.emplace_back([&] { valueOf(valueOf(Library::open(file))->loadExampleTypes()); });
        for (std::thread& thread : threads)
            thread.join();
        QCOMPARE(valueOf(folder.open()->types()).size(), std::size_t(4));
        QCOMPARE(valueOf(folder.open()->enrolledSqueezes()).size(), std::size_t(40));
        const LibraryVerification verified = valueOf(verifyLibrary(folder.file()));
        QVERIFY2(verified.whole(), qPrintable(inWords(verified)));
    }
    void theyTakeTurnsInBringingItUpToDate_data()
    {
        QTest::addColumn<int>("one");
        QTest::addColumn<int>("other");
        const int newest = migrations().back().version;
        for (const int one : {1, 10, 11, 12, 13, 20})
            for (const int other : {11, 12, 13, 14, newest - 1, newest})
                if (other > one)
                    QTest::addRow("to %d, to %d by the other, and on", one, other) << one << other;
    }
    /// Each may be overtaken between any two steps; the ledger is made by one of them.
    void theyTakeTurnsInBringingItUpToDate()
    {
        QFETCH(int, one);
        QFETCH(int, other);
        const LibraryFolder folder;
        const auto first = valueOf(Database::open(folder.file()));
        valueOf(migrate(*first, migrationsUpTo(one)));
        valueOf(migrate(*valueOf(Database::open(folder.file())), migrationsUpTo(other)));
        valueOf(migrate(*first));
        const LibraryVerification verified = valueOf(verifyLibrary(folder.file()));
        QVERIFY2(verified.whole(), qPrintable(inWords(verified)));
    }
    void twoProcessesWriteAtOnce()
    {
        const LibraryFolder folder;
        folder.open();
        std::vector<pid_t> processes;
        for (int i = 0; i < 2; ++i) {
            processes.push_back(startChild([&] {
                const auto library = valueOf(Library::open(folder.file()));
                for (int j = 0; j < 25; ++j)
                    valueOf(library->addInspection(anInspection()));
            }));
        }
        for (pid_t process : processes)
            QVERIFY(endedWell(process));
        checkNumbers(folder, 50);
    }
    void twoThreadsWithAnObjectEachWriteAtOnce()
    {
        const LibraryFolder folder;
        folder.open();
        std::vector<std::thread> threads;
        for (int i = 0; i < 2; ++i)
            threads.emplace_back([&] {
                const auto library = valueOf(Library::open(folder.file()));
                for (int j = 0; j < 25; ++j)
                    valueOf(library->addInspection(anInspection()));
            });
        for (std::thread& thread : threads)
            thread.join();
        checkNumbers(folder, 50);
    }
    void oneSeesAtOnceWhatTheOtherStored()
    {
        const LibraryFolder folder;
        const auto one = folder.open();
        const auto two = folder.open();
        valueOf(one->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        QVERIFY(valueOf(two->findType(u"A"_s)));
        QCOMPARE(two->addType(u"A"_s, {}, u"N"_s, u"m"_s).error().code, ErrorCode::Usage);
    }

private:
    /// 1, 2, 3... without hole or double.
    static void checkNumbers(const LibraryFolder& folder, int inspections)
    {
        QSet<qint64> numbers;
        for (const InspectionRecord& inspection : valueOf(folder.open()->inspections({})))
            numbers.insert(inspection.number);
        QCOMPARE(numbers.size(), inspections);
        for (qint64 number = 1; number <= inspections; ++number)
            QVERIFY(numbers.contains(number));
        // One chain, and one second place, whoever wrote.
        const LibraryVerification verified = valueOf(verifyLibrary(folder.file()));
        QVERIFY2(verified.whole(), qPrintable(inWords(verified)));
        QVERIFY(verified.witness == WitnessState::Matched);
    }
};

GRIPSCOPE_TEST(LibrarySharingTest)
#include "library_sharing_test.moc"
