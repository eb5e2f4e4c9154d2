// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/simulated_parts.h"
#include "devices/address/device_address.h"
#include "devices/factory/gripper_factory.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class DeviceAddressTest : public QObject {
    Q_OBJECT
private slots:
    void aBareVirtualAddressHasTheDocumentedDefaults()
    {
        const auto address = std::get<VirtualAddress>(*parseDeviceAddress(u"virtual:"_qs));
        QCOMPARE(address.object, u"A"_qs);
        QCOMPARE(address.seed, std::uint64_t(1));
        QCOMPARE(address.speed, 1.0);
        QVERIFY(!address.positionNoise_m);
        QVERIFY(!address.terms.any());
        QCOMPARE(address.samplesPerSecond, 2000.0);
        QCOMPARE(address.jitter_s, 0.0);
    }

    void whatIsNotIdealIsRead()
    {
        const auto address = std::get<VirtualAddress>(*parseDeviceAddress(
            u"virtual:?friction=0.5&own-friction=1.5&zener=0.2,0.03&k3=-1e8&rate=100&jitter=0.001"_qs));
        const VirtualTerms terms{0.5, 1.5, 0.2, 0.03, -1e8};
        QVERIFY(address.terms == terms);
        QCOMPARE(address.samplesPerSecond, 100.0);
        QCOMPARE(address.jitter_s, 0.001);
    }

    void simulatedPartsYieldAsTheyDoUnlessToldOtherwise()
    {
        for (const SimulatedPart& part : simulatedParts())
            for (const QString& text : {u"virtual:?object=%1&seed=2"_qs, u"virtual:?seed=2&object=%1"_qs}) {
                const auto address = std::get<VirtualAddress>(*parseDeviceAddress(text.arg(part.key)));
                QCOMPARE(address.terms.relaxingShare, part.relaxingShare);
                QCOMPARE(address.terms.relaxationTime_s, part.relaxationTime_s);
                QVERIFY(VirtualObject::fromText(address.object)->centre() == part.centre);
            }
        const auto other = std::get<VirtualAddress>(
            *parseDeviceAddress(u"virtual:?object=tomato&zener=0.1,0.5&friction=0.2"_qs));
        QVERIFY(other.terms == (VirtualTerms{0.2, 0, 0.1, 0.5, 0}));
        const auto rigid =
            std::get<VirtualAddress>(*parseDeviceAddress(u"virtual:?object=apple&zener=0,0.1"_qs));
        QCOMPARE(rigid.terms.relaxingShare, 0.0);
    }

    void everyOptionIsRead()
    {
        const auto address = std::get<VirtualAddress>(*parseDeviceAddress(
            u"virtual:?object=0.04,43,9990&seed=7&noise=20e-6&speed=0&capture=/tmp/x.gscap&script=/tmp/"
            u"faults.txt"
            "&fault=loss:0.01,duplicate:0.02,crc:0.03,stall:1.5,replug:0.5,unplug:2,saturate:25,stuck,units,"
            "deaf:3,hang-feature:4,hang-write:5,broken:6,button:7"_qs));
        QCOMPARE(address.object, u"0.04,43,9990"_qs);
        QCOMPARE(address.seed, std::uint64_t(7));
        QCOMPARE(address.positionNoise_m, std::optional<double>(20e-6));
        QCOMPARE(address.speed, 0.0);
        QCOMPARE(address.capture, u"/tmp/x.gscap"_qs);
        QCOMPARE(address.script, u"/tmp/faults.txt"_qs);
        QVERIFY(address.millimetres);
        const std::vector<FaultEvent> faults{{0, Fault::Loss, 0.01},
                                             {0, Fault::Duplicate, 0.02},
                                             {0, Fault::Crc, 0.03},
                                             {0, Fault::Saturate, 25},
                                             {0, Fault::Stuck, 1},
                                             {1.5, Fault::Stall, std::nullopt},
                                             {2, Fault::Unplug, std::nullopt},
                                             {2.5, Fault::Replug, std::nullopt},
                                             {3, Fault::Deaf, 0},
                                             {4, Fault::HangFeature, usualHang_s},
                                             {5, Fault::HangWrite, usualHang_s},
                                             {6, Fault::Broken, 1},
                                             {7, Fault::Button, 1}};
        QVERIFY(address.faults == faults);
    }

    void hidAddressesNameAGripper()
    {
        const auto any = std::get<HidAddress>(*parseDeviceAddress(u"hid:"_qs));
        QVERIFY(!any.vendor && !any.product && any.serial.isEmpty());
        const auto named =
            std::get<HidAddress>(*parseDeviceAddress(u"hid:1209:0001:GS-42:b?capture=c.gscap"_qs));
        QCOMPARE(named.vendor, std::optional<std::uint16_t>(0x1209));
        QCOMPARE(named.product, std::optional<std::uint16_t>(1));
        QCOMPARE(named.serial, u"GS-42:b"_qs);
        QCOMPARE(named.capture, u"c.gscap"_qs);
        const auto at = std::get<HidAddress>(
            *parseDeviceAddress(u"hid:1209:0001:GS-42?port=usb-0000:00:14.0-2/input0&capture=c.gscap"_qs));
        QCOMPARE(at.serial, u"GS-42"_qs);
        QCOMPARE(at.port, u"usb-0000:00:14.0-2/input0"_qs);
        QCOMPARE(at.capture, u"c.gscap"_qs);
    }

    void aReplayKeepsItsFileNameAsItIs()
    {
        const auto address = std::get<ReplayAddress>(*parseDeviceAddress(u"replay:C:/a b/x?y&z.csv"_qs));
        QCOMPARE(address.file, u"C:/a b/x?y&z.csv"_qs);
    }

    void whatMakesNoSenseIsNamed_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("named"); // part of the message
        QTest::newRow("nothing") << u""_qs << u"virtual:"_qs;
        QTest::newRow("unknown kind") << u"serial:/dev/ttyS0"_qs << u"serial:"_qs;
        QTest::newRow("no colon") << u"virtual"_qs << u"virtual:"_qs;
        QTest::newRow("no question mark") << u"virtual:object=A"_qs << u"object=A"_qs;
        QTest::newRow("unknown option") << u"virtual:?colour=red"_qs << u"colour"_qs;
        QTest::newRow("no value") << u"virtual:?seed"_qs << u"seed"_qs;
        QTest::newRow("unknown object") << u"virtual:?object=Q"_qs << u"object=Q"_qs;
        QTest::newRow("negative mass") << u"virtual:?object=-1,2,3"_qs << u"-1,2,3"_qs;
        QTest::newRow("bad seed") << u"virtual:?seed=-1"_qs << u"seed=-1"_qs;
        QTest::newRow("bad noise") << u"virtual:?noise=nan"_qs << u"noise=nan"_qs;
        QTest::newRow("bad speed") << u"virtual:?speed=-1"_qs << u"speed=-1"_qs;
        QTest::newRow("negative friction") << u"virtual:?friction=-1"_qs << u"friction=-1"_qs;
        QTest::newRow("zener without its time") << u"virtual:?zener=0.2"_qs << u"0.2,0.03"_qs;
        QTest::newRow("zener without a share") << u"virtual:?zener=,0.2"_qs << u"zener="_qs;
        QTest::newRow("zener that yields at once") << u"virtual:?zener=0.2,0"_qs << u"zener=0"_qs;
        QTest::newRow("too slow a gripper") << u"virtual:?rate=1"_qs << u"rate=1"_qs;
        QTest::newRow("too fast a gripper") << u"virtual:?rate=1e6"_qs << u"rate=1e6"_qs;
        QTest::newRow("positions out of turn") << u"virtual:?jitter=0.001"_qs << u"jitter=0.001"_qs;
        QTest::newRow("unknown fault") << u"virtual:?fault=fire"_qs << u"fire"_qs;
        QTest::newRow("probability above one") << u"virtual:?fault=loss:2"_qs << u"loss"_qs;
        QTest::newRow("fault without number") << u"virtual:?fault=loss"_qs << u"loss"_qs;
        QTest::newRow("replug alone") << u"virtual:?fault=replug:1"_qs << u"unplug:S"_qs;
        QTest::newRow("two fault options") << u"virtual:?fault=stuck&fault=crc:1"_qs << u"commas"_qs;
        QTest::newRow("half an id") << u"hid:1209"_qs << u"1209"_qs;
        QTest::newRow("no hexadecimal") << u"hid:12g9:1"_qs << u"12g9"_qs;
        QTest::newRow("long id") << u"hid:11209:1"_qs << u"11209"_qs;
        QTest::newRow("no file") << u"replay:"_qs << u"replay:"_qs;
    }
    void whatMakesNoSenseIsNamed()
    {
        QFETCH(QString, text);
        QFETCH(QString, named);
        const auto address = parseDeviceAddress(text);
        QVERIFY(!address);
        QVERIFY(address.error().code == ErrorCode::Usage);
        QVERIFY2(address.error().describe().contains(named), qPrintable(address.error().describe()));
        QVERIFY(!DeviceFactory().create(text));
    }

    void theVirtualGripperIsAlwaysFound()
    {
        const std::vector<FoundDevice> found = findDevices();
        QVERIFY(!found.empty());
        QCOMPARE(found.front().address, u"virtual:"_qs);
        QCOMPARE(found.front().state, u"available"_qs);
        for (const FoundDevice& device : found)
            QVERIFY(parseDeviceAddress(device.address).has_value());
    }
};

GRIPSCOPE_TEST(DeviceAddressTest)
#include "device_address_test.moc"
