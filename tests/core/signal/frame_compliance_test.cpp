// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/preparation_parts.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

class FrameComplianceTest : public QObject {
    Q_OBJECT
private slots:
    void theFramesShareIsTakenAway()
    {
        const std::vector<double> corrected = withoutFrame({10, 20, 30}, {1, 2, -3}, 2);
        QVERIFY((corrected == std::vector<double>{8, 16, 36}));
    }
    void theForceIsReadWhereThePositionWas()
    {
        // Half a sample later: half way on a straight line, unchanged when held; beyond the end the last
        // value.
        const std::vector<double> position(3, 0.0), force{0, 2, 6};
        QVERIFY((withoutFrame(position, force, 1, 0.5, ForceHold::First) == std::vector<double>{-1, -4, -6}));
        QVERIFY((withoutFrame(position, force, 1, 0.5, ForceHold::Zero) == std::vector<double>{0, -2, -6}));
        QVERIFY((withoutFrame(position, force, 1, 1, ForceHold::Zero) == std::vector<double>{-2, -6, -6}));
        QVERIFY((withoutFrame(position, force, 1, -1, ForceHold::First) == std::vector<double>{0, 0, -2}));
    }
    void numbersThatLeadNowhereChangeNothing()
    {
        const std::vector<double> position{1, 2};
        QVERIFY(withoutFrame(position, {1, 2}, NAN) == position);
        QVERIFY(withoutFrame(position, {1, 2}, 1, INFINITY) == position);
        QVERIFY(withoutFrame(position, {1}, 1) == position);
        QVERIFY(withoutFrame(position, {1e300, -1e300}, 1e300) == position);
        QVERIFY(withoutFrame({}, {}, 1).empty());
    }
};

GRIPSCOPE_TEST(FrameComplianceTest)
#include "frame_compliance_test.moc"
