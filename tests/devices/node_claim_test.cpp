// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/node_claim.h"
#include "tests/support/test_registry.h"

#include <QTemporaryFile>
#include <QTest>

#include <sys/wait.h>
#include <unistd.h>

using namespace gripscope;
using namespace std::chrono_literals;
using namespace Qt::StringLiterals;

// A file stands for the device node: what is locked is the same to the system.

class NodeClaimTest : public QObject {
    Q_OBJECT
private slots:
    void isHeldByOneUntilItIsLetGoOf()
    {
        QTemporaryFile node;
        QVERIFY(node.open());
        {
            const Expected<NodeClaim> first = NodeClaim::take(node.fileName(), 0ms);
            QVERIFY(first.has_value());
            const Expected<NodeClaim> second = NodeClaim::take(node.fileName(), 20ms);
            QVERIFY(!second.has_value());
            QVERIFY(second.error().code == ErrorCode::DeviceRefused);
            QVERIFY2(second.error().describe().contains(u"another program uses it"),
                     qPrintable(second.error().describe()));
        }
        QVERIFY(NodeClaim::take(node.fileName(), 0ms).has_value());
    }

    void aProgramThatEndsLetsGo()
    {
        QTemporaryFile node;
        QVERIFY(node.open());
        int ends[2];
        QVERIFY(pipe(ends) == 0);
        const pid_t other = fork();
        if (other == 0) {
            const Expected<NodeClaim> held = NodeClaim::take(node.fileName(), 0ms);
            const char done = held ? 'y' : 'n';
            static_cast<void>(!write(ends[1], &done, 1));
            pause(); // until it is killed
        }
        char done = 0;
        QCOMPARE(read(ends[0], &done, 1), ssize_t(1));
        QCOMPARE(done, 'y');
        QVERIFY(!NodeClaim::take(node.fileName(), 0ms).has_value());
        kill(other, SIGKILL);
        QCOMPARE(waitpid(other, nullptr, 0), other);
        QVERIFY(NodeClaim::take(node.fileName(), 1s).has_value());
        close(ends[0]);
        close(ends[1]);
    }

    void aNodeThatWentAwayIsALoss()
    {
        const Expected<NodeClaim> claim = NodeClaim::take(u"/nowhere/hidraw0"_s, 0ms);
        QVERIFY(!claim && claim.error().code == ErrorCode::DeviceLost);
    }
};

GRIPSCOPE_TEST(NodeClaimTest)
#include "node_claim_test.moc"
