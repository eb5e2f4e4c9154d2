// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/brief_lock.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <chrono>
#include <thread>

using namespace gripscope;

class BriefLockTest : public QObject {
    Q_OBJECT
private slots:
    /// As it lies there when a program was killed between making it and writing its name into it.
    void whatAKilledProgramLeftIsNobodys()
    {
        const QTemporaryDir folder;
        QFile left(folder.filePath(QStringLiteral("x.lock")));
        QVERIFY(left.open(QIODevice::WriteOnly));
        left.close();
        BriefLock lock(left.fileName());
        QVERIFY(lock.take());
    }
    void whoLivesKeepsItHoweverLong()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("x.lock"));
        std::atomic<bool> taken = false;
        std::atomic<bool> over = false;
        std::thread other([&] {
            BriefLock lock(file);
            taken = lock.take();
            std::this_thread::sleep_for(std::chrono::milliseconds(1500)); // three times what makes it stale
            over = true;
        });
        while (!taken)
            std::this_thread::yield();
        BriefLock lock(file);
        const bool mine = lock.take();
        const bool after = over;
        other.join();
        QVERIFY(mine && after);
    }
};

GRIPSCOPE_TEST(BriefLockTest)
#include "brief_lock_test.moc"
