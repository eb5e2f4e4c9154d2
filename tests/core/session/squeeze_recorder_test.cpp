// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/squeeze_recorder.h"
#include "core/signal/recording/recording_limits.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <limits>

using namespace gripscope;
using Mode = SqueezeRecorder::Mode;

namespace {

Sample sampleAt(std::uint64_t number, std::uint16_t status = 0)
{
    return {number, 0.001 * static_cast<double>(number), 1, 2, status};
}

} // namespace

class SqueezeRecorderTest : public QObject {
    Q_OBJECT
private slots:
    void noNumberMakesItTakeMoreThanThereIs_data()
    {
        QTest::addColumn<double>("sampleTime");
        QTest::addColumn<qulonglong>("samples");
        QTest::newRow("as usual") << 0.001 << qulonglong(100);
        for (const double sampleTime :
             {1e-15, 1e-22, 5e-324, 0.0, -1.0, 1e300, std::numeric_limits<double>::infinity(),
              std::numeric_limits<double>::quiet_NaN()})
            QTest::addRow("sample time %g", sampleTime) << sampleTime << qulonglong(100);
        for (const qulonglong samples : {9999999999999999999ULL, ~0ULL, 1ULL << 62, 0ULL})
            QTest::addRow("%llu samples", samples) << 0.001 << samples;
    }
    void noNumberMakesItTakeMoreThanThereIs()
    {
        QFETCH(double, sampleTime);
        QFETCH(qulonglong, samples);
        for (const Mode mode : {Mode::Movement, Mode::Everything}) {
            SqueezeRecorder recorder;
            recorder.begin(mode, samples, sampleTime);
            for (std::uint64_t i = 0; i < 3000; ++i)
                recorder.take(std::vector<Sample>{
                    sampleAt(i, i > 1000 && i < 2000 ? std::uint16_t(StatusMoving) : std::uint16_t(0))});
            QVERIFY(recorder.size() <= 3000);
            QVERIFY(recorder.progress() >= 0 && recorder.progress() <= 1);
            Recording recording;
            recorder.moveTo(recording);
            QVERIFY(recording.size() <= 3000);
            if (mode == Mode::Movement)
                QVERIFY(recording.size() >= 999); // all that moved
        }
    }
    void whatMovesForEverEnds()
    {
        SqueezeRecorder recorder;
        recorder.begin(Mode::Movement, 100, 0.001);
        std::vector<Sample> batch;
        for (std::uint64_t i = 0; i < mostSamples / 8 + 1; ++i)
            batch.push_back(sampleAt(i, StatusMoving));
        for (int i = 0; i < 9; ++i)
            recorder.take(batch);
        QVERIFY(recorder.complete());
        QCOMPARE(recorder.size(), mostSamples);
    }
};

GRIPSCOPE_TEST(SqueezeRecorderTest)
#include "squeeze_recorder_test.moc"
