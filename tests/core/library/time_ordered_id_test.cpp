// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/time_ordered_id.h"
#include "tests/support/test_registry.h"

#include <QDateTime>
#include <QSet>
#include <QTest>
#include <QUuid>

#include <algorithm>
#include <thread>
#include <vector>

using namespace gripscope;

class TimeOrderedIdTest : public QObject {
    Q_OBJECT
private slots:
    void isAUuidOfVersionSeven()
    {
        const QString id = newTimeOrderedId();
        const QUuid uuid = QUuid::fromString(id);
        QVERIFY(!uuid.isNull());
        QCOMPARE(uuid.toString(QUuid::WithoutBraces), id);
        QCOMPARE(uuid.variant(), QUuid::DCE);
        QCOMPARE(id[14], QChar(u'7'));
    }
    void beginsWithTheTime()
    {
        const qint64 before = QDateTime::currentMSecsSinceEpoch();
        const QString id = newTimeOrderedId();
        const qint64 milliseconds = (id.left(8) + id.mid(9, 4)).toLongLong(nullptr, 16);
        // Many keys in one millisecond borrow from the next: 4,096 keys a millisecond are more than tests
        // make.
        QVERIFY(milliseconds >= before && milliseconds <= QDateTime::currentMSecsSinceEpoch() + 100);
    }
    void sortsInTheOrderOfMaking()
    {
        std::vector<QString> ids(50'000); // more than the counter of a few milliseconds holds
        for (QString& id : ids)
            id = newTimeOrderedId();
        QVERIFY(std::is_sorted(ids.begin(), ids.end()));
        QVERIFY(std::adjacent_find(ids.begin(), ids.end()) == ids.end());
    }
    void isUniqueAcrossThreads()
    {
        std::vector<std::vector<QString>> made(4, std::vector<QString>(5000));
        std::vector<std::thread> threads;
        for (std::vector<QString>& ids : made)
            threads.emplace_back([&ids] { std::generate(ids.begin(), ids.end(), newTimeOrderedId); });
        for (std::thread& thread : threads)
            thread.join();
        QSet<QString> all;
        for (const std::vector<QString>& ids : made)
            all.unite(QSet<QString>(ids.begin(), ids.end()));
        QCOMPARE(all.size(), 20'000);
    }
};

GRIPSCOPE_TEST(TimeOrderedIdTest)
#include "time_ordered_id_test.moc"
