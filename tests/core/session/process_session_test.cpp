// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/merge/library_merge.h"
#include "core/math/gaussian.h"
#include "core/session/process/fixed_limits.h"
#include "core/session/process/process_session.h"
#include "core/session/process/process_watch.h"
#include "core/session/process/process_words.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/many_inspections.h"
#include "tests/core/library/plant_actions.h"
#include "tests/core/library/process_inspections.h"
#include "tests/core/session/session_driver.h"
#include "tests/support/test_registry.h"

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using ProcessState = ProcessSession::State;

namespace {

/// So many parts of A, k by a normal process; from `movedFrom` on k is higher by so many of its deviations.
struct NormalParts {
    int count = 60;
    int movedFrom = 1'000'000;
    double moved = 0;
    std::uint64_t seed = 3;
};

std::vector<double> addParts(Library& library, const NormalParts& parts)
{
    GaussianNoise noise(parts.seed);
    const QDateTime start(QDate(2026, 5, 4), QTime(8, 0), Qt::UTC);
    std::vector<double> stiffness;
    for (int i = 0; i < parts.count; ++i) {
        const double k = 9990 + 20 * noise() + (i >= parts.movedFrom ? 20 * parts.moved : 0);
        stiffness.push_back(k);
        addPart(library, {.parameters = {0.04 + 0.0001 * noise(), 43 + 0.2 * noise(), k},
                          .operatorName = i % 2 == 0 ? u"Ada"_s : u"Bob"_s,
                          .time = start.addSecs(60 * i)});
    }
    return stiffness;
}

/// A session on a library of its own.
struct ProcessRun {
    explicit ProcessRun(const QString& file) : library(file), session(library)
    {
        options.rules = RunRules::WesternElectric;
        session.setOptions(options);
    }
    LibraryService library;
    ProcessSession session;
    ProcessOptions options;

    bool until(const std::function<bool()>& done)
    {
        return pollUntil([this] { session.poll(); }, done);
    }
    bool shown()
    {
        return until([this] { return session.state() == ProcessState::Shown; });
    }
    [[nodiscard]] const ProcessPicture& picture() const { return *session.picture(); }
    /// On the library's thread, behind what was asked for before.
    void run(const std::function<void(Library&)>& work)
    {
        (void)library
            .run<void>([&work](Library& open) -> Expected<void> {
                work(open);
                return {};
            })
            .get();
    }
};

} // namespace

/// Control charts of what is inspected, as a page holds them.
class ProcessSessionTest : public QObject {
    Q_OBJECT
private:
    std::unique_ptr<LibraryFolder> m_folder;

private slots:
    void init() { m_folder = std::make_unique<LibraryFolder>(); }
    void whatChanceAloneSignalsIsTold()
    {
        const RunLengths lengths{RunLength{100}, {}};
        QCOMPARE(chanceSentence(1040, lengths).english(), u"Chance alone would make some 10 of them."_s);
        QVERIFY(chanceSentence(99, lengths).isEmpty());
        QVERIFY(chanceSentence(1040, {}).isEmpty());
    }
    void chartsAreThoseOfTheNumbers()
    {
        const std::vector<double> k = addParts(*m_folder->open(), {});
        ProcessRun run(m_folder->file());
        run.options.limits[2] = ToleranceLimits{9900, 10080};
        run.session.setOptions(run.options);
        run.session.setQuery({.type = u"A"_s});
        QVERIFY(run.shown());
        ChartOptions expected;
        expected.rules = RunRules::WesternElectric;
        const Subgroups groups = *Subgroups::of(*SubgroupLayout::consecutive(k.size(), 1), k);
        const ChartStudy study = *studyChart(groups, expected);
        const QuantityChart& chart = *run.picture().charts[2];
        QCOMPARE(chart.study.setting.centre, study.setting.centre);
        QCOMPARE(chart.study.setting.sigma, study.setting.sigma);
        QCOMPARE(chart.study.signalsFound.size(), study.signalsFound.size());
        CapabilityOptions capable;
        capable.limits = *run.options.limits[2];
        const Capability capability = *studyCapability(groups, capable);
        const ProcessCapability& found = *run.picture().capabilities[2];
        QCOMPARE(found.normal->overall.nearest.value, capability.overall.nearest.value);
        QCOMPARE(found.normal->within.spread->interval.lower, capability.within.spread->interval.lower);
        qint64 counted = 0;
        for (const qint64 bar : found.histogram.counts)
            counted += bar;
        QCOMPARE(counted, qint64(k.size()));
        QVERIFY(!run.picture().capabilities[0]->normal); // no limits of m
        QVERIFY(std::abs(run.picture().runLengths.inControl->points - 91.75) < 0.1);
    }
    void everyKindIsDrawn_data()
    {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"i-mr", "xbar-r", "xbar-s", "ewma", "cusum", "hotelling"})
            QTest::newRow(kind) << QString::fromLatin1(kind);
    }
    /// A shift by three sigma is seen, and told with the inspection since which it is there.
    void everyKindIsDrawn()
    {
        QFETCH(QString, kind);
        addParts(*m_folder->open(), {.count = 120, .movedFrom = 100, .moved = 3});
        ProcessRun run(m_folder->file());
        run.options.kind = *processKindFromString(kind);
        run.options.subgroup = 4;
        run.session.setOptions(run.options);
        run.session.setQuery({.type = u"A"_s});
        QVERIFY(run.shown());
        const ProcessPicture& picture = run.picture();
        if (run.options.kind == ProcessKind::Hotelling) {
            QCOMPARE((*picture.joint)->points.size(), std::size_t(120));
            return;
        }
        QVERIFY(!picture.joint);
        const QuantityChart& chart = *picture.charts[2];
        QCOMPARE(chart.points(), std::size_t(120 / chart.size));
        QVERIFY(!chart.signalsFound.empty());
        const ProcessSignal& last = chart.signalsFound.back();
        const SignalNumbers numbers = signalNumbers(chart, *picture.values, last);
        QVERIFY(numbers.last > 100 && numbers.since <= numbers.first);
        const QString words = signalSentence(last, numbers, picture.options).describe();
        QVERIFY2(words.startsWith(u"k at inspection "_s), qPrintable(words));
    }
    void aPatternThatGoesOnIsOneSignal()
    {
        addParts(*m_folder->open(), {.count = 120, .movedFrom = 100, .moved = 3});
        ProcessRun run(m_folder->file());
        run.session.setQuery({.type = u"A"_s});
        QVERIFY(run.shown());
        const QuantityChart& chart = *run.picture().charts[2];
        QVERIFY(chart.study.signalsFound.size() > 2 * chart.signalsFound.size());
        const auto side = std::ranges::find_if(chart.signalsFound, [](const ProcessSignal& one) {
            return one.rule == 4 && one.last >= 110; // eight on one side
        });
        QVERIFY(side != chart.signalsFound.end());
        QCOMPARE(side->last, std::size_t(119));
        QCOMPARE(side->first - side->since, std::size_t(7));
    }
    void filtersNarrowWhatIsDrawn()
    {
        addParts(*m_folder->open(), {});
        ProcessRun run(m_folder->file());
        run.session.setQuery({.type = u"A"_s});
        QVERIFY(run.shown());
        run.session.setFilter({.operatorName = u"Ada"_s});
        QVERIFY(run.shown());
        QCOMPARE(run.picture().rows.size(), std::size_t(30));
        ProcessFilter days;
        days.from = QDateTime(QDate(2026, 5, 4), QTime(8, 30), Qt::UTC);
        days.to = days.from.addSecs(600);
        run.session.setFilter(days);
        QVERIFY(run.shown());
        QCOMPARE(run.picture().rows.size(), std::size_t(10));
        run.session.setFilter({.station = u"elsewhere"_s});
        QVERIFY(run.shown());
        QVERIFY(run.picture().rows.empty());
        QVERIFY(!run.picture().charts[2]);
    }
    void whatIsStoredLaterJoins()
    {
        const auto open = m_folder->open();
        addParts(*open, {});
        ProcessRun run(m_folder->file());
        run.session.setQuery({.type = u"A"_s});
        QVERIFY(run.shown());
        addParts(*open, {.count = 5, .seed = 8});
        run.session.refresh();
        QVERIFY(run.until([&] { return run.picture().values->size() == 65; }));
        QVERIFY(run.shown());
        QCOMPARE(run.picture().values->numbers.back(), qint64(65));
        valueOf(open->voidInspection(3, u"dropped"_s, u"Ada"_s));
        run.session.refresh();
        QVERIFY(run.until([&] { return run.picture().values->size() == 64; }));
        QCOMPARE(run.picture().values->numbers[2], qint64(4));
    }
    /// None of those that are there is copied, unless their room is full, which then doubles.
    void oneMoreJoinsWhereTheOthersAre()
    {
        const auto open = m_folder->open();
        addParts(*open, {});
        ProcessRun run(m_folder->file());
        run.session.setQuery({.type = u"A"_s});
        QVERIFY(run.shown());
        const auto addOne = [&](std::size_t all) {
            addParts(*open, {.count = 1});
            run.session.refresh();
            QVERIFY(run.until([&] { return run.picture().values->size() == all; }));
            QVERIFY(run.shown());
        };
        addOne(61);
        const std::shared_ptr<const ProcessValues> before = run.session.values();
        addOne(62);
        const ProcessValues& after = *run.session.values();
        QVERIFY(after.numbers.sharesWith(before->numbers) && after.times_ms.sharesWith(before->times_ms));
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(after.quantities[i].sharesWith(before->quantities[i]));
        QVERIFY(after.stations.sharesWith(before->stations) && after.batches.sharesWith(before->batches));
        QCOMPARE(before->size(), std::size_t(61));
        QCOMPARE(after.numbers.back(), qint64(62));
    }
    void aColumnOfAMillionIsCopiedAFewTimes()
    {
        SharedColumn<qint64> all;
        int copied = 0;
        for (qint64 i = 0; i < 1'000'000; ++i) {
            SharedColumn<qint64> next = all;
            next.push_back(i);
            copied += next.sharesWith(all) ? 0 : 1;
            all = next;
        }
        QVERIFY2(copied <= 21, qPrintable(QString::number(copied))); // 2^20 is enough for them
        SharedColumn<qint64> one = all, other = all;
        one.push_back(1);
        other.push_back(2); // behind the same: needs room of its own
        QVERIFY(one.sharesWith(all) && !other.sharesWith(all));
        QVERIFY(one.back() == 1 && other.back() == 2 && all.back() == 999'999);
        QVERIFY(std::equal(all.begin(), all.end(), other.begin()));
    }
    void limitsThatAreFixedJudgeWhatFollows()
    {
        const auto open = m_folder->open();
        addParts(*open, {.count = 120, .movedFrom = 100, .moved = 3});
        ProcessRun run(m_folder->file());
        run.session.setQuery({.type = u"A"_s});
        QVERIFY(run.shown());
        const double before = run.picture().charts[2]->study.setting.centre;
        QVERIFY(run.session.fix(1, 100, u"Ada"_s));
        QVERIFY(run.until([&] { return run.picture().options.fixed.has_value(); }));
        const FixedLimits& fixed = *run.session.fixedLimits();
        QCOMPARE(fixed.count, qint64(100));
        QVERIFY(std::abs(fixed.quantities[2]->centre - 9990) < 8); // 4 of its standard errors
        QVERIFY(before > fixed.quantities[2]->centre + 5);
        QCOMPARE(run.picture().charts[2]->study.setting.sigma, fixed.quantities[2]->sigma);
        QCOMPARE(run.session.fixedRecord()->operatorName, u"Ada"_s);
        // Another session has them from the library.
        ProcessRun again(m_folder->file());
        again.session.setQuery({.type = u"A"_s});
        QVERIFY(again.shown());
        QCOMPARE(again.picture().charts[2]->study.setting.centre, fixed.quantities[2]->centre);
        again.session.setUsesFixed(false);
        QVERIFY(again.shown());
        QCOMPARE(again.picture().charts[2]->study.setting.centre, before);
        run.session.release(u"Ada"_s);
        QVERIFY(run.until([&] { return !run.session.fixedLimits() && !run.picture().options.fixed; }));
    }
    void fixedLimitsComeBackFromTheirText()
    {
        const auto open = m_folder->open();
        addParts(*open, {});
        const ProcessValues values = valuesOf(*open, {.type = u"A"_s});
        ProcessOptions options;
        options.kind = ProcessKind::MeanRange;
        const FixedLimits fixed = *fixLimits(values, processRows(values, {}), 1, 60, options);
        const auto back = fixedLimitsFromText(toText(fixed));
        QVERIFY(back && back->quantities == fixed.quantities && back->kind == fixed.kind &&
                back->subgroup == 5 && back->last == 60);
        QCOMPARE(back->joint->covariance, fixed.joint->covariance);
        for (const char* wrong : {"", "{}", "[1]",
                                  "{\"version\":1,\"kind\":\"i-mr\",\"rules\":\"none\","
                                  "\"subgroup\":1,\"k\":[1,0]}",
                                  "{\"version\":2,\"kind\":\"i-mr\",\"rules\":\"none\",\"subgroup\":1}"})
            QVERIFY2(!fixedLimitsFromText(QString::fromLatin1(wrong)), wrong);
    }
    /// The first signal after the limits were fixed is told, by number; before that nothing is.
    void theWatchSpeaksOfTheNewestInspection()
    {
        const auto open = m_folder->open();
        addParts(*open, {.count = 40});
        QVERIFY(!*processSignalOf(*open, u"A"_s));
        const ProcessValues values = valuesOf(*open, {.type = u"A"_s});
        ProcessOptions options;
        options.rules = RunRules::WesternElectric;
        const FixedLimits fixed = *fixLimits(values, processRows(values, {}), 1, 40, options);
        valueOf(open->fixProcessLimits(u"A"_s, toText(fixed), u"Ada"_s));
        QVERIFY(!*processSignalOf(*open, u"A"_s));
        addPart(*open, {.parameters = {0.04, 43, 9990}});
        QVERIFY(!*processSignalOf(*open, u"A"_s));
        addPart(*open, {.parameters = {0.04, 43, 10100}});
        const auto signal = *processSignalOf(*open, u"A"_s);
        QVERIFY(signal);
        QVERIFY2(signal->describe().contains(u"k at inspection 42: above the upper limit"_s),
                 qPrintable(signal->describe()));
        // Back at the centre: a last signal of the step there, then none.
        addPart(*open, {.parameters = {0.04, 43, 9990}});
        QVERIFY((*processSignalOf(*open, u"A"_s))->describe().contains(u"the step from the value before"_s));
        addPart(*open, {.parameters = {0.04, 43, 9990}});
        QVERIFY(!*processSignalOf(*open, u"A"_s));
    }
    /// Numbers of inspections are a library's own: those that a station has not come to yet are not passed
    /// over.
    void theWatchHoldsAStationAgainstLimitsFixedAtAnother()
    {
        const auto open = m_folder->open();
        addParts(*open, {.count = 40});
        const ProcessValues values = valuesOf(*open, {.type = u"A"_s});
        const FixedLimits fixed = *fixLimits(values, processRows(values, {}), 1, 40, ProcessOptions());
        valueOf(open->fixProcessLimits(u"A"_s, toText(fixed), u"Ada"_s));
        QCOMPARE(fixedLimitsOf(*open->processLimits(u"A"_s))->last, 40);

        const LibraryFolder elsewhere;
        const auto other = elsewhere.open();
        addParts(*other, {.count = 3});
        valueOf(other->mergeLibrary(m_folder->file(), why));
        const auto taken = fixedLimitsOf(*other->processLimits(u"A"_s));
        QVERIFY(taken && taken->quantities == fixed.quantities);
        QCOMPARE(taken->last, 0);
        addPart(*other, {.parameters = {0.04, 43, 10100},
                         .time = QDateTime(QDate(2026, 5, 4), QTime(9, 0), Qt::UTC)});
        const auto signal = *processSignalOf(*other, u"A"_s);
        QVERIFY(signal);
        QVERIFY2(signal->describe().contains(u"above the upper limit"_s), qPrintable(signal->describe()));
    }
    void valuesThatAreNotNormalHaveTheirWay()
    {
        GaussianNoise noise(5);
        ProcessValues values;
        for (int i = 0; i < 300; ++i) {
            values.numbers.push_back(i + 1);
            values.times_ms.push_back(i);
            for (SharedColumn<double>& column : values.quantities)
                column.push_back(std::exp(0.5 * noise()));
            for (auto* places : {&values.stations, &values.operators, &values.batches})
                places->push_back(0);
        }
        ProcessOptions options;
        options.limits[2] = ToleranceLimits{{}, 6};
        const ProcessRows rows = processRows(values, {});
        const ProcessCapability power = *processCapability(values, rows, 2, options);
        QVERIFY(power.boxCox && !power.percentiles);
        QVERIFY(std::abs(power.boxCox->lambda) < 0.3); // logarithms: 0
        QCOMPARE(power.verdictIndex(), &power.boxCox->capability.overall.nearest);
        std::vector<double> rounded; // a plateau in the middle: no power helps
        for (const double value : values.quantities[2])
            rounded.push_back(std::round(value));
        values.quantities[2] = SharedColumn<double>(rounded);
        const ProcessCapability percentiles = *processCapability(values, rows, 2, options);
        QVERIFY(percentiles.percentiles && !percentiles.boxCox);
    }
    void fewOrNoneAreToldNotDrawn()
    {
        const auto open = m_folder->open();
        addPart(*open, {});
        ProcessRun run(m_folder->file());
        run.session.setQuery({.type = u"A"_s});
        QVERIFY(run.shown());
        QVERIFY(!run.picture().charts[2]);
        run.session.setQuery({.type = u"nobody's"_s});
        QVERIFY(run.shown());
        QVERIFY(run.picture().values->empty());
        run.session.setQuery({});
        QVERIFY(run.session.state() == ProcessState::Idle);
    }
    /// Reading a large library tells how far it is, and ends at once when it is cancelled.
    void readingTellsItsProgressAndCanBeCancelled()
    {
        m_folder->open();
        addManyInspections(m_folder->file(), 200'000);
        ProcessRun run(m_folder->file());
        std::vector<double> shares;
        run.session.setQuery({.type = u"A"_s});
        QVERIFY(run.until([&] {
            if (shares.empty() || run.session.share() > shares.back())
                shares.push_back(run.session.share());
            return run.session.state() == ProcessState::Drawing || run.session.state() == ProcessState::Shown;
        }));
        QVERIFY2(shares.size() >= 3, qPrintable(QString::number(shares.size()))); // four stretches
        QVERIFY(run.shown());
        run.session.reload();
        QVERIFY(run.session.state() == ProcessState::Reading);
        run.session.cancel();
        QVERIFY(run.session.state() == ProcessState::Cancelled); // at once
        QVERIFY(run.session.picture());                          // what was shown before stays
        run.run([](Library&) {});                                // the library is free again
        run.session.poll();
        QVERIFY(run.session.state() == ProcessState::Cancelled);
        run.session.reload();
        QVERIFY(run.shown());
    }
    void anotherLibraryThatCannotBeReadIsTold()
    {
        writeBytes(m_folder->file(), "no library");
        ProcessRun run(m_folder->file());
        run.session.setQuery({.type = u"A"_s});
        QVERIFY(run.until([&] { return run.session.state() == ProcessState::Failed; }));
        QVERIFY(run.session.error());
    }
};

GRIPSCOPE_TEST(ProcessSessionTest)
#include "process_session_test.moc"
