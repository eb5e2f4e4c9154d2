// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/charts/strip_chart.h"
#include "ui/feed/live_feed.h"

#include <QLabel>
#include <QPushButton>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

namespace {

std::vector<Sample> samples(std::uint64_t first, int count, bool moving)
{
    std::vector<Sample> made(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < made.size(); ++i) {
        made[i].sequence = first + i;
        made[i].status = moving ? StatusMoving : 0;
    }
    return made;
}

using Forces = std::vector<std::optional<double>>;
const Forces unknown3{std::nullopt, std::nullopt, std::nullopt};

} // namespace

/// What the gripper was asked for, beside what was measured.
class CommandedForceTest : public QObject {
    Q_OBJECT
private slots:
    void standsFromTheFirstSampleThatMoves()
    {
        CommandedForce commanded;
        const SafetyGate::Started started{{10, 20, 30, 40}, 1};
        QCOMPARE(commanded.follow(samples(7, 3, false), started), unknown3);
        QCOMPARE(commanded.follow(samples(10, 3, true), started), (Forces{10.0, 20.0, 30.0}));
        QCOMPARE(commanded.follow(samples(13, 2, true), started), (Forces{40.0, std::nullopt}));
        QCOMPARE(commanded.follow(samples(15, 3, false), started), unknown3);
    }
    void samplesLostOnTheWayDoNotShiftIt()
    {
        CommandedForce commanded;
        const SafetyGate::Started started{{10, 20, 30, 40}, 1};
        (void)commanded.follow(samples(9, 1, false), started);
        QCOMPARE(commanded.follow(samples(10, 1, true), started), Forces{10.0});
        QCOMPARE(commanded.follow(samples(13, 1, true), started), Forces{40.0});
    }
    void withoutTheFirstSampleNothingIsKnown()
    {
        CommandedForce commanded;
        const SafetyGate::Started started{{10, 20, 30, 40}, 1};
        (void)commanded.follow(samples(9, 1, false), started);
        QCOMPARE(commanded.follow(samples(11, 3, true), started), unknown3);
    }
    void whatThisProgramDidNotStartIsNotKnown()
    {
        CommandedForce commanded;
        (void)commanded.follow(samples(9, 1, false), {});
        QCOMPARE(commanded.follow(samples(10, 3, true), {}), unknown3);
        // Nor is a movement after one of its own, when nothing new was started.
        const SafetyGate::Started started{{10, 20, 30, 40}, 1};
        (void)commanded.follow(samples(13, 1, false), started);
        QCOMPARE(commanded.follow(samples(14, 1, true), started), Forces{10.0});
        (void)commanded.follow(samples(15, 1, false), started);
        QCOMPARE(commanded.follow(samples(16, 3, true), started), unknown3);
    }
    /// From the click to the chart: the virtual gripper reports what it applies, with 0.02 N of noise.
    void aTrialSqueezeShowsWhatWasAskedBesideWhatWasMeasured()
    {
        WindowFixture f(false);
        f.window->showPage(u"live"_s);
        QTRY_VERIFY(f.find<QPushButton>("trialButton")->isEnabled());
        StripChart* force = f.window->findChildren<StripChart*>().first();
        QVERIFY(force->commanded().empty());
        const auto* legend = f.find<QLabel>("commandedForce");
        bool told = false;
        QVERIFY(f.inRealTime([&f] { f.clickWhenEnabled(f.find<QPushButton>("trialButton")); },
                             [&] {
                                 told = told || legend->text().contains(u" N"_s);
                                 return told && f.bench->navigator().fitSubject();
                             }));
        const Recording& recording = f.bench->navigator().fitSubject()->recording;
        const LiveHistory& history = f.bench->live().history();
        int compared = 0;
        for (std::size_t i = 0; i < recording.size(); ++i) {
            const auto asked = history.reading(LiveHistory::Channel::CommandedForce, recording.time_s[i]);
            QCOMPARE(asked.has_value(), (recording.status[i] & StatusMoving) != 0);
            if (!asked)
                continue;
            // Six standard deviations and a count of 1 mN: one sample off, and the levels 20 N apart differ.
            QVERIFY(std::abs(asked->middle() - recording.force[i]) < 0.122);
            ++compared;
        }
        QCOMPARE(compared, 2000);
        QVERIFY(std::any_of(recording.force.begin(), recording.force.end(),
                            [](double force_N) { return force_N > 25; }));
    }
};

GRIPSCOPE_TEST(CommandedForceTest)
#include "commanded_force_test.moc"
