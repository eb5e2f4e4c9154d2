// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/hid_return.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

const HidAddress lost{0x1209, 1, u"GS-1"_qs};
const HidAddress nameless{0x1209, 1};
const QString port = u"usb-1/input0"_qs;
const QString otherPort = u"usb-2/input0"_qs;

HidNode node(int number, const QString& serial, const QString& at)
{
    HidNode made{u"/dev/hidraw%1"_qs.arg(number), 0x1209, 1, serial, u"Bench gripper"_qs, true, true};
    made.port = at;
    made.instance = u"hidraw%1/0003:1209:0001.%1"_qs.arg(number);
    return made;
}

} // namespace

class HidReturnTest : public QObject {
    Q_OBJECT
private slots:
    void theSameSerialComesBackAtAnyPort()
    {
        QCOMPARE(returnedNode(lost, port, {node(1, u"GS-1"_qs, port)}, {})->path, u"/dev/hidraw1"_qs);
        QCOMPARE(returnedNode(lost, port, {node(1, u"GS-1"_qs, otherPort)}, {})->path, u"/dev/hidraw1"_qs);
    }
    void anotherSerialIsAnotherGripper()
    {
        QVERIFY(!returnedNode(lost, port, {node(1, u"GS-2"_qs, port)}, {}));
        QVERIFY(!returnedNode(lost, port, {node(1, {}, port)}, {}));
        QVERIFY(!returnedNode(lost, port, {}, {}));
    }
    void oneThatWasThereAllTheTimeWithTheSameSerialIsNotTheOneThatWasLost()
    {
        const HidNode twin = node(3, u"GS-1"_qs, otherPort);
        QVERIFY(!returnedNode(lost, port, {twin}, {twin.instance}));
        const HidNode back = node(4, u"GS-1"_qs, u"usb-3/input0"_qs);
        QCOMPARE(returnedNode(lost, port, {twin, back}, {twin.instance})->path, back.path);
    }
    void withoutASerialOnlyTheOnlyOneAtItsOwnPort()
    {
        const HidNode back = node(1, {}, port);
        QCOMPARE(returnedNode(nameless, port, {back}, {})->path, back.path);
        QVERIFY(!returnedNode(nameless, port, {node(1, {}, otherPort)}, {}));
        QVERIFY(!returnedNode(nameless, port, {back, node(2, {}, otherPort)}, {}));
    }
};

GRIPSCOPE_TEST(HidReturnTest)
#include "hid_return_test.moc"
