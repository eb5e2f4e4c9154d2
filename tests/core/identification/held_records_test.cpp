// SPDX-License-Identifier: GPL-3.0-or-later
// Seven objects squeezed three times each by a two-finger hand: 30 rows a second, a width that is renewed
// some five times a second, and clocks of force and width that nobody aligned.
#include "core/identification/estimators/estimator_table.h"
#include "core/identification/identification.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

const QString folder = QStringLiteral(GRIPSCOPE_SHARED_DATA "/franka");

Recording readSqueeze(const QString& name)
{
    CsvReadOptions options;
    options.timeColumn = u"nominal_time_s_30fps"_s;
    options.forceColumn = u"force_N"_s;
    options.positionColumn = u"width_m"_s;
    options.forceUnit = u"N"_s;
    options.positionUnit = u"m"_s;
    return readRecordingCsv(folder + u'/' + name, options).value_or(Recording());
}

} // namespace

class HeldRecordsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase()
    {
        if (!QDir(folder).exists())
            QSKIP("the records of the two-finger hand are not in ../shared/data/franka");
    }
    void noRecordGetsAMassAndRigidOnesGetALowerBound_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("asked");
        for (const QString& name : QDir(folder).entryList({u"*.csv"_s}))
            for (int asked = 0; asked < 3; ++asked)
                QTest::addRow("%s %d", qPrintable(name), asked) << name << asked;
    }
    void noRecordGetsAMassAndRigidOnesGetALowerBound()
    {
        QFETCH(QString, name);
        QFETCH(int, asked);
        IdentificationOptions options;
        if (asked > 0)
            options.estimators = asked == 1 ? allEstimators() : std::vector{Estimator::Static};
        const Recording recording = readSqueeze(name);
        QVERIFY(recording.size() > 200);
        const Identification found = identify(recording, options);
        for (const Estimate& estimate : found.estimates)
            QVERIFY(!estimate.parameters && (!estimate.motion || !estimate.motion->terms.mass));
        QVERIFY(!found.budget.parameters && found.budget.lines.empty());
        QVERIFY(found.recommended == Estimator::Static);
        const Estimate* const k = found.find(Estimator::Static);
        QVERIFY(k != nullptr && k->message.english().contains(u"while the force rises from"_s));
        // Looked at and right for these 21: each is at least bounded, and no gripper yields by 30 mm.
        QVERIFY2(k->stiffnessBounds && k->stiffnessBounds->lower > 300, qPrintable(k->message.english()));
        const bool rigid = name.startsWith(u"golf"_s) || name.startsWith(u"rigid"_s);
        QVERIFY2(!rigid || !k->stiffnessBounds->upper, qPrintable(k->message.english()));
        const bool told = k->stiffnessBounds->upper.has_value();
        QVERIFY2(told || !name.startsWith(u"red_foam"_s), qPrintable(k->message.english()));
        QVERIFY(found.validity.verdict == (told ? ValidityVerdict::Suspect : ValidityVerdict::Invalid));
        QCOMPARE(found.budget.further.size(), std::size_t(told ? 1 : 0));
    }
    void whatIsNotTheSqueezeIsExcludedAndSaid_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("spike_N");
        QTest::newRow("-70 N behind the release") << u"blue_foam_brick_harder_0.csv"_s << -70.3268;
        QTest::newRow("-14 N before the touch") << u"red_foam_brick_softer_1.csv"_s << -13.5253;
        QTest::newRow("-3.7 N") << u"orange_ball_softest_1.csv"_s << -3.67354;
        QTest::newRow("none") << u"golf_ball_0.csv"_s << 0.0;
    }
    void whatIsNotTheSqueezeIsExcludedAndSaid()
    {
        QFETCH(QString, name);
        QFETCH(double, spike_N);
        const PreparedRecord record = prepare(readSqueeze(name));
        QVERIFY(record.held && record.held->opening);
        for (const QString& id : {u"opening"_s, u"contact"_s, u"position_held"_s})
            QVERIFY2(record.find(id) != nullptr, qPrintable(id));
        QVERIFY(record.find(u"saturation"_s) == nullptr);
        QCOMPARE(record.find(u"force_spikes"_s) != nullptr, spike_N != 0);
        if (spike_N != 0)
            QCOMPARE(record.find(u"force_spikes"_s)->value, spike_N);
        QVERIFY(*std::ranges::min_element(record.force) > 0);
    }
};

GRIPSCOPE_TEST(HeldRecordsTest)
#include "held_records_test.moc"
