// SPDX-License-Identifier: GPL-3.0-or-later
// What speaks against a measurement whatever the estimate is: the gripper's own word, its channels, its time.
#include "core/identification/identification.h"
#include "core/signal/recording/stream_account.h"
#include "tests/core/signal/measured_can.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::MeasuredCan;

namespace {

Identification identified(const Recording& recording)
{
    IdentificationOptions options;
    options.estimators = {Estimator::OutputError};
    options.assess = false; // the checks need no budget
    return identify(recording, options);
}

ValidityCheck measurementCheck(const Identification& identification, const QString& id)
{
    for (const ValidityCheck& c : identification.validity.checks)
        if (c.id == id)
            return c;
    qFatal("no check is called %s", qPrintable(id));
}

Recording squeezedByADevice()
{
    Recording recording = MeasuredCan().make();
    recording.status.assign(recording.size(), StatusArmed | StatusMoving);
    for (std::size_t i = 0; i < recording.size(); ++i)
        recording.sequence.push_back(i);
    recording.provenance[u"excitation"_s] = u"prbs"_s;
    return recording;
}

using Change = std::function<void(Recording&)>;

Change stream(const QString& account)
{
    return [account](Recording& recording) { recording.provenance[streamAccountKey()] = account; };
}

Change clocks(double clock_ppm, double sampling_ppm, double uncertainty_ppm)
{
    return stream(u"clock_compared=1 clock_ppm=%1 clock_uncertainty_ppm=%3 sampling_ppm=%2 "
                  "sampling_uncertainty_ppm=%3"_s.arg(clock_ppm)
                      .arg(sampling_ppm)
                      .arg(uncertainty_ppm));
}

} // namespace

Q_DECLARE_METATYPE(Change)

class MeasurementChecksTest : public QObject {
    Q_OBJECT
private slots:
    void eachFaultIsNamed_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("verdict");
        QTest::addColumn<QString>("failed"); ///< the check that names it
        QTest::addColumn<QString>("word");
        const auto row = [](const char* name, const Change& change, const QString& verdict,
                            const QString& failed, const QString& word) {
            QTest::newRow(name) << change << verdict << failed << word;
        };
        const QString valid = u"valid"_s, suspect = u"suspect"_s, invalid = u"invalid"_s;
        row("nothing", [](Recording&) {}, valid, {}, {});
        row(
            "a fault bit in one sample", [](Recording& r) { r.status[700] |= StatusFault; }, invalid,
            u"device_fault"_s, u"fault of its own in 1 of 2000"_s);
        row(
            "position stuck all the time",
            [](Recording& r) { std::fill(r.position.begin(), r.position.end(), 0.01234); }, invalid,
            u"stuck"_s, u"position channel is stuck: it stands at 12.34 mm in 2000 of 2000"_s);
        row(
            "position stuck from the middle on",
            [](Recording& r) { std::fill(r.position.begin() + 1000, r.position.end(), r.position[1000]); },
            invalid, u"stuck"_s, u"position channel is stuck"_s);
        row(
            "force stuck from the middle on",
            [](Recording& r) { std::fill(r.force.begin() + 1000, r.force.end(), r.force[1000]); }, invalid,
            u"stuck"_s, u"force channel is stuck"_s);
        row(
            "force stuck all the time", [](Recording& r) { std::fill(r.force.begin(), r.force.end(), 20.0); },
            invalid, u"stuck"_s, u"force channel is stuck: it stands at 20 N"_s);
        row(
            "force clipped, unmarked",
            [](Recording& r) {
                for (double& f : r.force)
                    f = std::min(f, 25.0);
            },
            invalid, u"saturation"_s, u"the force stands at the end"_s);
        row(
            "position clipped below, unmarked",
            [](Recording& r) {
                for (double& y : r.position)
                    y = std::max(y, 0.0018);
            },
            invalid, u"saturation"_s, u"the position stands at the end"_s);
        row("clock right", clocks(40, 40, 90), valid, {}, {});
        row("clock not known yet", stream(u"clock_compared=1"_s), valid, {}, {});
        row("clock may be wrong, or right", clocks(2500, 2500, 1800), valid, {}, {});
        row("clock 0.5 % fast", clocks(5000, 5000, 900), suspect, u"clock"_s, u"0.5 % fast"_s);
        row("clock 0.5 % slow", clocks(-5000, -5000, 900), suspect, u"clock"_s, u"0.5 % slow"_s);
        row("clock 1.5 % fast", clocks(15000, 15000, 900), invalid, u"clock"_s, u"1.5 % fast"_s);
        row("clock 5.5 % fast", clocks(55000, 55000, 900), invalid, u"clock"_s, u"m is off by about 11 %"_s);
        row("clock 10 % slow", clocks(-100000, -100000, 900), invalid, u"clock"_s,
            u"m is off by about 19 %"_s);
        row("samples come twice as often as stated",
            stream(u"clock_compared=1 sampling_ppm=1e6 sampling_uncertainty_ppm=900"_s), invalid,
            u"sample_time"_s, u"too often"_s);
        row("samples come half as often as stated",
            stream(u"clock_compared=1 sampling_ppm=-5e5 sampling_uncertainty_ppm=900"_s), invalid,
            u"sample_time"_s, u"too seldom"_s);
        row("samples come 0.3 % too often", clocks(30, 3000, 900), suspect, u"sample_time"_s,
            u"0.3 % too often"_s);
        row("the clock contradicts the count throughout", stream(u"clock_steps=900"_s), invalid,
            u"sample_time"_s, u"contradicts its sample count 900 times"_s);
        row(
            "stamps come 3 % later than stated",
            [](Recording& r) {
                for (double& t : r.time_s)
                    t *= 1.03;
            },
            invalid, u"sample_time"_s, u"every 0.515 ms"_s);
    }
    void eachFaultIsNamed()
    {
        QFETCH(Change, change);
        QFETCH(QString, verdict);
        QFETCH(QString, failed);
        QFETCH(QString, word);
        Recording recording = squeezedByADevice();
        change(recording);
        const Identification found = identified(recording);
        const ValiditySummary summary = summaryOf(found.validity);
        QVERIFY2(toString(summary.verdict) == verdict, qPrintable(described(summary.reasons).join(u'\n')));
        QCOMPARE(summary.checksFailed.isEmpty(), failed.isEmpty());
        if (failed.isEmpty())
            return;
        QVERIFY2(summary.checksFailed.contains(failed), qPrintable(summary.checksFailed.join(u' ')));
        const ValidityCheck named = measurementCheck(found, failed);
        QCOMPARE(named.decisive, verdict == u"invalid"_s);
        QVERIFY(named.limit);
        QVERIFY2(named.message.describe().contains(word), qPrintable(named.message.describe()));
        // It is the one thing that the person is told.
        QCOMPARE(summary.reasons.size(), 1);
        QVERIFY2(summary.reasons[0].describe().contains(word, Qt::CaseInsensitive),
                 qPrintable(summary.reasons[0].describe()));
        QVERIFY(summary.reasons[0].describe()[0].isUpper() && summary.reasons[0].describe().endsWith(u'.'));
    }
    void aForceThatMayStandStillIsNotAccused()
    {
        for (const QString& excitation : {u"step"_s, u"none, listened only"_s, QString()}) {
            Recording recording = squeezedByADevice();
            std::fill(recording.force.begin() + 20, recording.force.end(), 20.0);
            recording.provenance[u"excitation"_s] = excitation;
            QVERIFY(measurementCheck(identified(recording), u"stuck"_s).ok);
        }
    }
    void whatIsNotKnownIsSaid()
    {
        Recording recording = squeezedByADevice();
        QVERIFY(measurementCheck(identified(recording), u"clock"_s)
                    .message.describe()
                    .startsWith(u"not judged:"_s));
        recording.provenance[streamAccountKey()] = u"clock_compared=1"_s;
        QVERIFY(
            measurementCheck(identified(recording), u"clock"_s).message.describe().contains(u"too young"_s));
        recording.provenance[streamAccountKey()] =
            u"clock_compared=1 clock_ppm=-12 clock_uncertainty_ppm=80"_s;
        QVERIFY(measurementCheck(identified(recording), u"clock"_s)
                    .message.describe()
                    .contains(u"-12 ± 80 ppm"_s));
    }
    void aSentenceIsSaidOnce()
    {
        Recording recording = MeasuredCan().make();
        std::fill(recording.force.begin(), recording.force.end(), 20.0);
        const ValiditySummary summary = summaryOf(identified(recording).validity);
        QVERIFY(summary.verdict == ValidityVerdict::Invalid);
        QVERIFY(!described(summary.reasons).join(u' ').contains(u'_'));
        QVERIFY(described(summary.reasons).removeDuplicates() == 0);
    }
};

GRIPSCOPE_TEST(MeasurementChecksTest)
#include "measurement_checks_test.moc"
