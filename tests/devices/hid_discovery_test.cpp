// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/hid_transport.h"
#include "tests/devices/port_helpers.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

void write(const QString& file, const QByteArray& bytes)
{
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(bytes);
}

/// A folder that looks like /sys/class/hidraw, and one like /dev.
struct System {
    QTemporaryDir folder;
    QString classFolder() const { return folder.filePath(u"class"_qs); }
    QString deviceFolder() const { return folder.filePath(u"dev"_qs); }

    void add(const QString& name, const QByteArray& uevent, const QByteArray& descriptor)
    {
        QDir().mkpath(classFolder() + u'/' + name + u"/device"_qs);
        QDir().mkpath(deviceFolder());
        write(classFolder() + u'/' + name + u"/device/uevent"_qs, uevent);
        write(classFolder() + u'/' + name + u"/device/report_descriptor"_qs, descriptor);
        write(deviceFolder() + u'/' + name, {});
    }
    std::vector<HidNode> nodes() const { return listHidNodes(classFolder(), deviceFolder()); }
};

const QByteArray vendorPage("\x06\x00\xFF\x09\x01", 5);
const QByteArray mousePage("\x05\x01\x09\x02", 4);

QByteArray gripper(const QByteArray& serial)
{
    return "DRIVER=hid-generic\nHID_ID=0003:00001209:00000001\nHID_NAME=Bench "
           "gripper\nHID_PHYS=usb-1\nHID_UNIQ=" +
           serial + "\nMODALIAS=hid:b0003\n";
}

} // namespace

class HidDiscoveryTest : public QObject {
    Q_OBJECT
private slots:
    void readsTheSystemsList()
    {
        System system;
        system.add(u"hidraw0"_qs, "HID_ID=0003:0000046D:0000C077\nHID_NAME=Mouse\nHID_UNIQ=\n", mousePage);
        system.add(u"hidraw1"_qs, gripper("GS-1"), vendorPage);
        system.add(u"hidraw2"_qs, "HID_ID=rubbish\n", vendorPage);
        system.add(u"hidraw3"_qs, {}, {});
        const std::vector<HidNode> nodes = system.nodes();
        QCOMPARE(nodes.size(), std::size_t(2));
        QCOMPARE(nodes[0].vendor, std::uint16_t(0x046D));
        QVERIFY(!nodes[0].vendorPage);
        QCOMPARE(nodes[1].path, system.deviceFolder() + u"/hidraw1"_qs);
        QCOMPARE(nodes[1].vendor, std::uint16_t(0x1209));
        QCOMPARE(nodes[1].product, std::uint16_t(1));
        QCOMPARE(nodes[1].name, u"Bench gripper"_qs);
        QCOMPARE(nodes[1].serial, u"GS-1"_qs);
        QVERIFY(nodes[1].vendorPage);
        QVERIFY(nodes[1].accessible);
        QCOMPARE(grippersAmong(nodes).size(), std::size_t(1));
    }

    void choosesTheOnlyOneAndNamesTwo()
    {
        System system;
        system.add(u"hidraw0"_qs, gripper("GS-1"), vendorPage);
        QCOMPARE(chooseHidNode({}, system.nodes())->serial, u"GS-1"_qs);
        system.add(u"hidraw1"_qs, gripper("GS-2"), vendorPage);
        const auto two = chooseHidNode({}, system.nodes());
        QVERIFY(two.error().code == ErrorCode::DeviceAmbiguous);
        QVERIFY(two.error().describe().contains(u"hid:1209:0001:GS-2"_qs));
        QCOMPARE(chooseHidNode({0x1209, 1, u"GS-2"_qs}, system.nodes())->serial, u"GS-2"_qs);
        QVERIFY(chooseHidNode({0x1209, 1, u"GS-3"_qs}, system.nodes()).error().code ==
                ErrorCode::DeviceNotFound);
    }

    void twoWithTheSameSerialAreToldApartByTheirPorts()
    {
        System system;
        system.add(u"hidraw0"_qs, gripper("GS-1"), vendorPage);
        QCOMPARE(addressOf(system.nodes()[0], system.nodes()), u"hid:1209:0001:GS-1"_qs);
        system.add(u"hidraw1"_qs, gripper("GS-1").replace("usb-1", "usb-2/input0"), vendorPage);
        const std::vector<HidNode> nodes = system.nodes();
        const QString second = u"hid:1209:0001:GS-1?port=usb-2/input0"_qs;
        QCOMPARE(addressOf(nodes[1], nodes), second);
        QVERIFY(chooseHidNode({0x1209, 1, u"GS-1"_qs}, nodes).error().describe().contains(second));
        const auto parsed = parseDeviceAddress(second);
        QCOMPARE(chooseHidNode(std::get<HidAddress>(*parsed), nodes)->path, nodes[1].path);
        const std::vector<FoundDevice> found = devicesAmong(nodes);
        QCOMPARE(found.back().port, u"usb-2/input0"_qs);
        QCOMPARE(found.back().address, second);
    }

    void anotherDeviceWithTheTestIdentityIsNoGripperUnlessNamed()
    {
        System system;
        system.add(u"hidraw0"_qs, gripper("GS-1"), mousePage);
        QVERIFY(!chooseHidNode({}, system.nodes()));
        QVERIFY(chooseHidNode({0x1209, 1}, system.nodes()).has_value());
    }

    void withoutPermissionItSaysWhatToDo()
    {
        HidNode node{u"/dev/hidraw7"_qs, 0x1209, 1, u"GS-1"_qs, u"Bench gripper"_qs, true, false};
        const auto refused = chooseHidNode({}, {node});
        QVERIFY(refused.error().code == ErrorCode::DevicePermission);
        const QString text = refused.error().describe();
        QVERIFY(text.contains(u"/dev/hidraw7"_qs));
        QVERIFY(text.contains(u"sudo "_qs)); // node_permission_test tells which line
    }

    void aMissingGripperIsTold()
    {
        OpenPort gripper(u"hid:1209:0001:NO-SUCH-GRIPPER"_qs);
        QVERIFY(waitForState(*gripper.port, LinkState::Lost));
        QVERIFY(gripper.port->lastError()->code == ErrorCode::DeviceNotFound);
    }
};

GRIPSCOPE_TEST(HidDiscoveryTest)
#include "hid_discovery_test.moc"
