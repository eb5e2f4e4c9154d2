// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_session.h"
#include "devices/address/device_address.h"
#include "tests/devices/port_helpers.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using State = StudySession::State;

namespace {

constexpr double partSpread = 0.03, operatorSpread = 0.01, repeatSpread = 0.005;
constexpr int studyParts = 10, studyTrials = 3;

/// One program run on a gripper that holds whatever part the plan asks for.
struct VirtualStudyRun {
    VirtualStudyRun(const QString& file, std::uint64_t studySeed)
        : seed(studySeed), library(file), session(connection, library)
    {
        IdentificationOptions quick;
        quick.assess = false;
        session.setIdentificationOptions(quick);
    }
    std::uint64_t seed;
    DeviceFactory factory = patientFactory();
    ConnectSession connection{factory};
    LibraryService library;
    StudySession session;

    template <typename Condition>
    bool until(const Condition& condition)
    {
        return waitFor([&] {
            connection.poll();
            session.poll();
            return condition();
        });
    }
    bool settle()
    {
        return until([this] { return !session.busy(); });
    }
    /// The gripper with that part, that operator's hand, armed.
    bool take(const PlanRow& row)
    {
        const auto address = u"virtual:?object=0.04,43,9990&speed=0&seed=%1&part=%2&operator=%3&trial=%4&"
                             "part-spread=%5&operator-spread=%6&repeat-spread=%7"_s.arg(seed)
                                 .arg(row.part + 1)
                                 .arg(row.operators + 1)
                                 .arg(row.trial + 1)
                                 .arg(partSpread)
                                 .arg(operatorSpread)
                                 .arg(repeatSpread);
        return connection.connectTo(address) &&
               until([this] { return connection.state() == ConnectSession::State::Connected; }) &&
               connection.arm(u"Lea"_s) && until([this] { return connection.armed(); });
    }
    bool begin()
    {
        StudyRequest request;
        request.name = u"Cans"_s;
        request.design.parts = numberedParts(studyParts);
        request.design.operators = QStringList{u"Ada"_s, u"Bo"_s, u"Cy"_s};
        request.design.trials = studyTrials;
        request.design.seed = seed;
        request.recipe.seconds = 0.5;
        return take({}) && session.begin(request) && settle() && session.state() == State::Waiting;
    }
    /// Goes on until the plan is through, or so many squeezes were made; those that are invalid are repeated.
    bool squeeze(int most)
    {
        for (int i = 0; i < most; ++i) {
            const std::optional<std::size_t> row = session.nextRow();
            if (!row)
                return true;
            if (!take(session.study()->plan.rows[*row]) || !session.squeeze() || !settle() ||
                session.lastError())
                return false;
        }
        return true;
    }
    bool resume()
    {
        using Studies = std::vector<StudyRecord>;
        const Studies open =
            library.run<Studies>([](Library& kept) { return kept.unfinishedStudies(); }).get().value();
        return open.size() == 1 && session.resume(open[0].id) && settle() &&
               session.state() == State::Waiting;
    }
    bool finish()
    {
        return session.finish() && settle() && until([this] { return session.result().has_value(); }) &&
               session.result()->has_value();
    }
};

/// Which intervals hold what is true, of m, b and k.
struct StudyCoverage {
    std::array<int, 3> part{}, operators{}, repeatability{}, all{};
    std::array<double, 3> repeatsOverTruth{}, ownShare{}; ///< sums over the studies
    int studies = 0;

    void add(const GaugeStudy& study)
    {
        ++studies;
        const std::array<double, 3> centre{0.04, 43, 9990};
        for (std::size_t i = 0; i < centre.size(); ++i) {
            const GaugeValue& value = study.values[i];
            // What a squeeze does not determine better counts as repeatability, as it is in truth.
            const double own = value.consistency ? value.consistency->statedDeviation : 0;
            const bool ofParts = holds(value, GaugeComponent::Part, std::pow(partSpread * centre[i], 2));
            const bool ofPeople =
                holds(value, GaugeComponent::Operator, std::pow(operatorSpread * centre[i], 2));
            const bool ofRepeats = holds(value, GaugeComponent::Repeatability,
                                         std::pow(repeatSpread * centre[i], 2) + own * own);
            const double repeats = std::pow(repeatSpread * centre[i], 2) + own * own;
            repeatsOverTruth[i] += value.find(GaugeComponent::Repeatability)->estimate / repeats;
            ownShare[i] += own * own / repeats;
            part[i] += ofParts ? 1 : 0;
            operators[i] += ofPeople ? 1 : 0;
            repeatability[i] += ofRepeats ? 1 : 0;
            all[i] += ofParts && ofPeople && ofRepeats ? 1 : 0;
        }
    }
    static bool holds(const GaugeValue& value, GaugeComponent which, double truth)
    {
        const VarianceInterval& interval = value.find(which)->interval;
        return interval.lower <= truth && (!interval.upper || truth <= *interval.upper);
    }
    [[nodiscard]] QString text() const
    {
        QStringList lines{u"of %1 studies, intervals that hold the truth (m, b, k):"_s.arg(studies)};
        const auto line = [&](const QString& name, const std::array<int, 3>& counts) {
            lines << u"%1: %2, %3, %4"_s.arg(name).arg(counts[0]).arg(counts[1]).arg(counts[2]);
        };
        line(u"part"_s, part);
        line(u"operator"_s, operators);
        line(u"repeatability"_s, repeatability);
        line(u"all three"_s, all);
        const auto mean = [&](const QString& name, const std::array<double, 3>& sums) {
            lines << u"%1: %2, %3, %4"_s.arg(name)
                         .arg(sums[0] / studies, 0, 'f', 3)
                         .arg(sums[1] / studies, 0, 'f', 3)
                         .arg(sums[2] / studies, 0, 'f', 3);
        };
        mean(u"mean of repeatability over truth"_s, repeatsOverTruth);
        mean(u"share of it that the squeezes state as their own"_s, ownShare);
        return lines.join(u'\n');
    }
};

} // namespace

/// Whole studies of a gripper whose parts, operators and repeats are known.
class VirtualStudyTest : public QObject {
    Q_OBJECT
private slots:
    void aPartOfAStudyIsWhatItsEffectsMakeIt()
    {
        const auto drawn = [](int part, int person, int trial, std::uint64_t squeeze) {
            VirtualObject object = VirtualObject::fromText(u"0.04,43,9990"_s).value();
            object.takePartOf({part, person, trial, 0.03, 0.01, 0, 5});
            return object.draw(1, squeeze);
        };
        // Without a spread of repeats, a part is the same in each trial of an operator.
        QCOMPARE(drawn(3, 2, 1, 0), drawn(3, 2, 2, 7));
        // Effects add: no interaction.
        const double first = drawn(1, 1, 1, 0).k - drawn(1, 2, 1, 0).k;
        QVERIFY(std::abs(first - (drawn(2, 1, 1, 0).k - drawn(2, 2, 1, 0).k)) < 1e-8);
        QVERIFY(first != 0 && drawn(1, 1, 1, 0).k != drawn(2, 1, 1, 0).k);
    }
    void spreadsAreDeviations()
    {
        // Of 20,000 squeezes the deviation is known to 1 / sqrt(40,000) = 0.5 %: four of them.
        VirtualObject object = VirtualObject::fromText(u"0.04,43,10000"_s).value();
        double sum = 0, squares = 0;
        constexpr int squeezes = 20'000;
        object.takePartOf({1, 1, 1, 0, 0, 0.02, 5});
        for (int i = 0; i < squeezes; ++i) {
            const double off = object.draw(1, std::uint64_t(i)).k - 10000;
            sum += off;
            squares += off * off;
        }
        const double deviation = std::sqrt(squares / squeezes - std::pow(sum / squeezes, 2));
        QVERIFY2(std::abs(deviation / 200 - 1) < 0.02, qPrintable(QString::number(deviation)));
    }
    void addressesOfAStudyAreRead()
    {
        const auto address = std::get<VirtualAddress>(
            parseDeviceAddress(
                u"virtual:?object=A&part=3&operator=2&trial=1&part-spread=0.03&operator-spread=0.01&"
                "repeat-spread=0.005&seed=5"_s)
                .value());
        QVERIFY((address.study == VirtualStudyPart{3, 2, 1, 0.03, 0.01, 0.005, 5}));
        QVERIFY(!std::get<VirtualAddress>(parseDeviceAddress(u"virtual:?object=A"_s).value()).study);
        for (const auto& wrong : {u"part=0"_s, u"part=x"_s, u"operator=1001"_s, u"part-spread=-1"_s,
                                  u"repeat-spread=0.2"_s, u"trial=1.5"_s})
            QCOMPARE(parseDeviceAddress(u"virtual:?"_s + wrong).error().code, ErrorCode::Usage);
    }
    /// By hand with GRIPSCOPE_STUDIES=100: how many intervals hold the truth. GRIPSCOPE_FIRST_STUDY=26 begins
    /// with that seed, so that several programs can share them.
    void aStudyThatIsKilledAndResumedFindsTheTruth()
    {
        const int asked = qEnvironmentVariableIntValue("GRIPSCOPE_STUDIES");
        const int studies = asked > 0 ? asked : 3;
        const int first = std::max(1, qEnvironmentVariableIntValue("GRIPSCOPE_FIRST_STUDY"));
        StudyCoverage coverage;
        for (int seed = first; seed < first + studies; ++seed) {
            const QTemporaryDir folder;
            const QString file = folder.filePath(u"library.db"_s);
            {
                VirtualStudyRun run(file, std::uint64_t(seed));
                QVERIFY(run.begin());
                QVERIFY(run.squeeze(40));
                QVERIFY(run.take(run.session.study()->plan.rows[*run.session.nextRow()]));
                QVERIFY(run.session.squeeze()); // under way when the program ends
            }
            VirtualStudyRun run(file, std::uint64_t(seed));
            QVERIFY(run.resume());
            QVERIFY2(run.session.progress().done >= 38, "almost none of the squeezes is invalid");
            QVERIFY(run.squeeze(100));
            QVERIFY(run.finish());
            const StudyResult& result = **run.session.result();
            QCOMPARE(result.gauge()->study.rows, Eigen::Index(90));
            QVERIFY(result.gauge()->study.balanced);
            QCOMPARE(result.gauge()->study.values.size(), std::size_t(3));
            coverage.add(result.gauge()->study);
            if (coverage.studies % 5 == 0)
                qInfo("%s", qPrintable(coverage.text()));
        }
        qInfo("%s", qPrintable(coverage.text()));
        if (studies < 100)
            return; // three say little of a share: that they came to a result is what is tested
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(coverage.part[i] >= 90 * studies / 100);
            QVERIFY(coverage.operators[i] >= 90 * studies / 100);
            QVERIFY(coverage.repeatability[i] >= 90 * studies / 100);
        }
    }
};
GRIPSCOPE_TEST(VirtualStudyTest)
#include "virtual_study_test.moc"
