// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/factory/gripper_factory.h"
#include "devices/hid/node_permission.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// A computer with a folder of rules and a node.
struct PermissionBench {
    QTemporaryDir folder;
    NodeAccess access{{folder.filePath(u"rules.d"_s)}, u"anna"_s, true};
    HidNode node{folder.filePath(u"hidraw3"_s), 0x1209, 1, u"GS-1"_s, u"Bench gripper"_s, true, false};

    PermissionBench()
    {
        QDir().mkpath(access.ruleFolders.front());
        put(node.path, {});
    }
    static void put(const QString& file, const QByteArray& text)
    {
        QFile out(file);
        if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size())
            qFatal("no file");
    }
    void addRule(const QByteArray& text) const { put(access.ruleFolders.front() + u"/70-one.rules"_s, text); }
};

QByteArray packagedRules()
{
    QFile rule(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/packaging/70-gripscope.rules"));
    return rule.open(QIODevice::ReadOnly) ? rule.readAll() : QByteArray();
}

} // namespace

class NodePermissionTest : public QObject {
    Q_OBJECT
private slots:
    void saysWhichPermissionIsMissing_data()
    {
        QTest::addColumn<bool>("read");
        QTest::addColumn<bool>("write");
        QTest::addColumn<QString>("words");
        QTest::newRow("none") << true << true << QString();
        QTest::newRow("writing") << true << false
                                 << u"writing (it belongs to root, group plugdev, rw-r-----)"_s;
        QTest::newRow("reading") << false << true
                                 << u"reading (it belongs to root, group plugdev, rw-r-----)"_s;
        QTest::newRow("both") << false << false
                              << u"reading and writing (it belongs to root, group plugdev, rw-r-----)"_s;
    }
    void saysWhichPermissionIsMissing()
    {
        QFETCH(bool, read);
        QFETCH(bool, write);
        QTEST(missingIn({read, write, u"root"_s, u"plugdev"_s, u"rw-r-----"_s, false}), "words");
    }

    void readsTheNode()
    {
        PermissionBench bench;
        QVERIFY(QFile::setPermissions(bench.node.path, QFileDevice::ReadOwner | QFileDevice::ReadGroup));
        const NodePermission permission = permissionOf(bench.node, bench.access);
        QCOMPARE(permission.mode, u"r--r-----"_s);
        QVERIFY(permission.read);
        QVERIFY(!permission.ruled);
        bench.node.path += u"-gone"_s;
        QCOMPARE(missingIn(permissionOf(bench.node, bench.access)), u"reading and writing"_s);
    }

    void withoutARuleTheLineIsTheRuleThatIsPackaged()
    {
        const PermissionBench bench;
        const QString line = permissionCommand(bench.node, bench.access);
        const QString rule = QString::fromUtf8(packagedRules()).trimmed().section(u'\n', -1);
        QVERIFY2(line.contains(rule) && !rule.isEmpty(), qPrintable(line));
        QVERIFY2(line.endsWith(u" && sudo udevadm trigger --subsystem-match=hidraw"_s), qPrintable(line));
        QVERIFY(!line.contains(u'\n'));
        // What the line writes is understood as the rule that it is.
        bench.addRule(rule.toUtf8());
        QVERIFY(permissionOf(bench.node, bench.access).ruled);
    }

    void withTheRuleItIsAppliedAnewAtTheScreen()
    {
        const PermissionBench bench;
        bench.addRule(packagedRules());
        QCOMPARE(permissionCommand(bench.node, bench.access),
                 u"sudo udevadm trigger --action=change --subsystem-match=hidraw"_s);
    }

    void overTheNetworkTheRuleIsForNobodySoTheNodeIsOpenedToThisUser()
    {
        PermissionBench bench;
        bench.addRule(packagedRules());
        bench.access.atTheScreen = false;
        QCOMPARE(permissionCommand(bench.node, bench.access),
                 u"sudo setfacl -m u:anna:rw %1"_s.arg(bench.node.path));
    }

    void anotherProductsRuleAndACommentAreNone()
    {
        const PermissionBench bench;
        bench.addRule("# " + packagedRules().trimmed().split('\n').last() + "\n" +
                      packagedRules().trimmed().split('\n').last().replace("0001", "0002") + "\n");
        QVERIFY(!hasRule(bench.access.ruleFolders, 0x1209, 1));
        QVERIFY(hasRule(bench.access.ruleFolders, 0x1209, 2));
    }

    void whatIsListedCarriesBoth()
    {
        const PermissionBench bench;
        QFile::setPermissions(bench.node.path, {});
        const std::vector<FoundDevice> found = devicesAmong({bench.node});
        QCOMPARE(found.back().state, u"no permission"_s);
        QVERIFY(found.back().toAllow.contains(u"sudo "_s));
        QVERIFY(found.front().toAllow.isEmpty() && found.front().missing.isEmpty());
    }
};

GRIPSCOPE_TEST(NodePermissionTest)
#include "node_permission_test.moc"
