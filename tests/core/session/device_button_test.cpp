// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/device_button.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;

namespace {

/// A sample for each letter: d the button is down, u it is up.
std::vector<Sample> samples(const char* text)
{
    std::vector<Sample> out;
    for (; *text; ++text) {
        out.emplace_back();
        out.back().status = static_cast<std::uint16_t>(StatusArmed | (*text == 'd' ? statusButton : 0));
    }
    return out;
}

} // namespace

/// When a person pressed the gripper's own button.
class DeviceButtonTest : public QObject {
    Q_OBJECT
private slots:
    void aPressIsTheChangeFromUpToDown()
    {
        ButtonWatch watch;
        QVERIFY(!watch.pressedIn(samples("uuu")));
        QVERIFY(watch.pressedIn(samples("udd")));
        QVERIFY(!watch.pressedIn(samples("ddd"))); // still the same
        QVERIFY(!watch.pressedIn(samples("duu")));
        QVERIFY(watch.pressedIn(samples("dudu"))); // short ones in one batch are one
    }
    void aPressBetweenTwoBatchesIsSeen()
    {
        ButtonWatch watch;
        QVERIFY(!watch.pressedIn(samples("u")));
        QVERIFY(!watch.pressedIn({}));
        QVERIFY(watch.pressedIn(samples("d")));
    }
    void aButtonThatIsDownFromTheBeginningWasNotPressed()
    {
        ButtonWatch watch;
        QVERIFY(!watch.pressedIn(samples("ddd")));
        QVERIFY(watch.pressedIn(samples("ud")));
        watch.reset(); // the gripper came back, held
        QVERIFY(!watch.pressedIn(samples("dd")));
    }
};

GRIPSCOPE_TEST(DeviceButtonTest)
#include "device_button_test.moc"
