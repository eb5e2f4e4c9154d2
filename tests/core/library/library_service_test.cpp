// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library_service.h"
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFileInfo>
#include <QTest>

#include <chrono>
#include <thread>

using namespace gripscope;
using namespace gripscope::test;

class LibraryServiceTest : public QObject {
    Q_OBJECT
private slots:
    void workIsDoneInOrderOnOneOtherThread()
    {
        const LibraryFolder folder;
        LibraryService service(folder.file());
        QCOMPARE(service.file(), folder.file());
        std::vector<int> order;
        std::vector<std::thread::id> threads;
        std::vector<Pending<Expected<int>>> futures;
        for (int i = 0; i < 100; ++i)
            futures.push_back(service.run<int>([&, i](Library&) -> Expected<int> {
                order.push_back(
                    i); // only ever touched on the service's thread until the last future is ready
                threads.push_back(std::this_thread::get_id());
                return i;
            }));
        for (int i = 0; i < 100; ++i)
            QCOMPARE(valueOf(futures[std::size_t(i)].get()), i);
        QVERIFY(std::is_sorted(order.begin(), order.end()));
        for (std::thread::id thread : threads)
            QVERIFY(thread == threads[0] && thread != std::this_thread::get_id());
    }
    void theFileIsOpenedWhenItIsFirstNeeded()
    {
        GRIPSCOPE_OF_FILES_ALONE("a database is there before")
        const LibraryFolder folder;
        {
            const LibraryService idle(folder.file());
        }
        QVERIFY(!QFileInfo::exists(folder.file()));
        LibraryService service(folder.file());
        valueOf(service.run<void>([](Library& library) { return library.loadExampleTypes(); }).get());
        QVERIFY(QFileInfo::exists(folder.file()));
    }
    void theDestructorFinishesWhatIsQueued()
    {
        const LibraryFolder folder;
        std::promise<void> gate;
        std::vector<Pending<Expected<InspectionRecord>>> futures;
        std::thread opener;
        {
            LibraryService service(folder.file());
            auto held = service.run<void>([&gate](Library&) -> Expected<void> {
                gate.get_future().wait();
                return {};
            });
            for (int i = 0; i < 10; ++i)
                futures.push_back(service.run<InspectionRecord>(
                    [](Library& library) { return library.addInspection(anInspection()); }));
            QVERIFY(!futures[0].ready());
            opener = std::thread([&gate] { gate.set_value(); });
        }
        opener.join();
        for (int i = 0; i < 10; ++i)
            QCOMPARE(valueOf(futures[std::size_t(i)].get()).number, i + 1);
    }
    void aLibraryThatDoesNotOpenIsInEveryFutureUntilItDoes()
    {
        GRIPSCOPE_OF_FILES_ALONE("a folder that comes later")
        const LibraryFolder folder;
        const QString file = folder.folder.filePath(u"sub/library.db"_s);
        LibraryService service(file);
        const auto types = [&] {
            return service.run<std::vector<TypeRecord>>([](Library& library) { return library.types(); })
                .get();
        };
        QCOMPARE(types().error().code, ErrorCode::StorageOpen);
        QCOMPARE(types().error().code, ErrorCode::StorageOpen);
        QDir(folder.folder.path()).mkdir(u"sub"_s);
        QVERIFY(types());
    }
    void manyMayAskAtOnce()
    {
        const LibraryFolder folder;
        LibraryService service(folder.file());
        std::vector<std::thread> threads;
        for (int i = 0; i < 4; ++i)
            threads.emplace_back([&] {
                for (int j = 0; j < 10; ++j)
                    valueOf(service
                                .run<InspectionRecord>(
                                    [](Library& library) { return library.addInspection(anInspection()); })
                                .get());
            });
        for (std::thread& thread : threads)
            thread.join();
        const auto counts =
            service.run<InspectionCounts>([](Library& library) { return library.inspectionCounts(); }).get();
        QCOMPARE(valueOf(counts).total, 40);
    }
};

GRIPSCOPE_TEST(LibraryServiceTest)
#include "library_service_test.moc"
