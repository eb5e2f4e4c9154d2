// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/packing/number_series.h"
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// Read back to the last bit, and nothing left over.
bool comesBack(const std::vector<double>& values)
{
    const QByteArray bytes = packedSeries(values);
    QByteArrayView rest = bytes;
    const auto back = takeDoubles(rest, values.size());
    if (!back || back->size() != values.size() || !rest.isEmpty())
        return false;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::bit_cast<quint64>((*back)[i]) != std::bit_cast<quint64>(values[i]))
            return false;
    return true;
}

double bytesEach(const std::vector<double>& values)
{
    return double(qCompress(packedSeries(values), 9).size()) / double(values.size());
}

/// Counts that scatter by some, as a converter gives them.
std::vector<double> counts(double unit, double offset = 0, std::size_t count = 2000)
{
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 3);
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(std::round((i / 40 % 2 ? 12000 : 18000) + noise(random)) * unit + offset);
    return values;
}

} // namespace

/// Series of numbers in few bytes, bit for bit.
class NumberSeriesTest : public QObject {
    Q_OBJECT
private slots:
    void everyBitComesBack_data()
    {
        QTest::addColumn<QList<double>>("values");
        constexpr double inf = std::numeric_limits<double>::infinity();
        const auto row = [](const char* name, const std::vector<double>& values) {
            QTest::newRow(name) << QList<double>(values.begin(), values.end());
        };
        row("none", {});
        row("one", {0.1});
        row("zeros", std::vector<double>(100, 0.0));
        row("zeros of both signs", {0.0, -0.0, 0.0, -0.0});
        row("the ends",
            {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(),
             std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::denorm_min()});
        row("no numbers", {inf, -inf, std::bit_cast<double>(0x7ff8000000000123u), 1});
        row("counts", counts(1.0 / 3e3));
        row("counts with an offset", counts(1e-7, 0.1234567));
        row("decimals", {0.1, 0.2, 0.3, 12.345, -7.001, 1e6});
        row("wide apart", {1e-300, 1e300, 1, -1e300});
        std::mt19937_64 random(7);
        std::vector<double> nonsense;
        for (int i = 0; i < 1000; ++i)
            nonsense.push_back(std::bit_cast<double>(random()));
        row("any bits", nonsense);
        const Recording awkward = awkwardRecording();
        row("awkward times", awkward.time_s);
        row("awkward forces", awkward.force);
        row("awkward positions", awkward.position);
    }
    void everyBitComesBack()
    {
        QFETCH(QList<double>, values);
        QVERIFY(comesBack({values.begin(), values.end()}));
    }
    void wholeNumbersComeBack()
    {
        std::mt19937_64 random(3);
        std::vector<std::uint64_t> nonsense(500);
        for (std::uint64_t& value : nonsense)
            value = random();
        std::vector<std::uint64_t> even;
        for (std::uint64_t i = 0; i < 1000; ++i)
            even.push_back(0xfffffffffffffff0u + 3 * i); // and round again
        for (const auto& values : {nonsense, even, std::vector<std::uint64_t>{}, {0}, {~std::uint64_t(0)}}) {
            const QByteArray bytes = packedSeries(values);
            QByteArrayView rest = bytes;
            QVERIFY(takeIntegers(rest, values.size()) == values);
            QVERIFY(rest.isEmpty());
        }
        QVERIFY(qCompress(packedSeries(even), 9).size() < 60);
    }
    void whatAGripperSendsTakesFewBytes()
    {
        // 3 counts of noise have 3.6 bits of information each.
        QVERIFY2(bytesEach(counts(1.0 / 3e3)) < 1.1,
                 qPrintable(QString::number(bytesEach(counts(1.0 / 3e3)))));
        // Calibrated: the table of the values that occur comes on top.
        QVERIFY(bytesEach(counts(1e-7, 0.1234567)) < 1.6);
        std::vector<double> clock;
        for (int i = 0; i < 2000; ++i)
            clock.push_back(1e-6 * double(123456789 + 500 * (i / 5 * 5)) + double(i % 5) * 0.0005);
        QVERIFY(comesBack(clock));
        QVERIFY2(bytesEach(clock) < 0.8, qPrintable(QString::number(bytesEach(clock))));
    }
    void whatIsNoSeriesIsRefused()
    {
        const auto refused = [](const QByteArray& bytes, std::uint64_t count) {
            QByteArrayView rest = bytes;
            return !takeDoubles(rest, count);
        };
        const QByteArray good = packedSeries(std::span<const double>(counts(1e-3)));
        for (qsizetype cut = 0; cut < good.size(); cut += 97)
            QVERIFY(refused(good.first(cut), 2000));
        QVERIFY(refused(good, 2001));
        QVERIFY(refused(QByteArray("\7\0\1", 3), 1));                 // no such form
        QVERIFY(refused(QByteArray("\0\3\1a", 4), 1));                // no such order
        QVERIFY(refused(QByteArray("\0\0\11aaaaaaaaa", 12), 1));      // more bytes than a number has
        QVERIFY(refused(QByteArray("\0\0\0", 3), ~std::uint64_t(0))); // zeros without end
        QVERIFY(
            refused(QByteArray("\2\0\0\0\0\0\0\0\1\0\1a\0\1b", 15), 1)); // a place that is not in the table
    }
};

GRIPSCOPE_TEST(NumberSeriesTest)
#include "number_series_test.moc"
