// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random_stream.h"
#include "core/quality/agreement/attribute_agreement.h"
#include "tests/support/test_registry.h"

#include <QFileInfo>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// One pair a part, as counted in a square table.
std::vector<VerdictPair> pairsOfTable(const std::vector<std::vector<int>>& table)
{
    std::vector<VerdictPair> pairs;
    for (int i = 0; i < int(table.size()); ++i)
        for (int j = 0; j < int(table.size()); ++j)
            for (int k = 0; k < table[i][j]; ++k)
                pairs.push_back({int(pairs.size()), i, j});
    return pairs;
}

bool nearKappa(double found, double expected, double absolute)
{
    return std::abs(found - expected) <= absolute;
}

std::vector<Rating> ratingsOf(const std::vector<std::vector<int>>& parts)
{
    std::vector<Rating> ratings;
    for (int part = 0; part < int(parts.size()); ++part)
        for (const int verdict : parts[part])
            ratings.push_back({part, int(ratings.size()), verdict});
    return ratings;
}

} // namespace

class KappaTest : public QObject {
    Q_OBJECT
private slots:
    /// Values as published; standard errors by R from the formula of Fleiss, Cohen and Everitt.
    void cohensKappaOfTables_data()
    {
        using Table = std::vector<std::vector<int>>;
        QTest::addColumn<Table>("table");
        QTest::addColumn<double>("published");
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("error");
        QTest::newRow("Cohen 1960") << Table{{88, 14, 18}, {10, 40, 10}, {2, 6, 12}} << 0.49
                                    << 0.4915254237288 << 0.0510018155761;
        QTest::newRow("AIAG A B") << Table{{44, 6}, {3, 97}} << 0.86 << 0.862944162437 << 0.044198240183;
        QTest::newRow("AIAG A C") << Table{{43, 7}, {8, 92}} << 0.78 << 0.7761194029851 << 0.0546707943443;
        QTest::newRow("AIAG B C") << Table{{42, 5}, {9, 94}} << 0.79 << 0.788007268322 << 0.053702460640;
        QTest::newRow("AIAG A") << Table{{45, 5}, {3, 97}} << 0.88 << 0.8787878787879 << 0.0416409171136;
        QTest::newRow("AIAG B") << Table{{45, 2}, {3, 100}} << 0.92 << 0.9229821318546 << 0.0338470874259;
        QTest::newRow("AIAG C") << Table{{42, 9}, {6, 93}} << 0.77 << 0.7739602169982 << 0.0551373393055;
    }
    void cohensKappaOfTables()
    {
        QFETCH(std::vector<std::vector<int>>, table);
        QFETCH(double, published);
        QFETCH(double, value);
        QFETCH(double, error);
        const std::vector<VerdictPair> pairs = pairsOfTable(table);
        const CohenKappa kappa = cohenKappa(pairs, int(table.size()));
        QVERIFY(nearKappa(*kappa.value, published, 0.005));
        QVERIFY(nearKappa(*kappa.value, value, 1e-12));
        QVERIFY(nearKappa(*kappa.standardError, error, 1e-12));
        // The same verdicts again on each part tell nothing more.
        std::vector<VerdictPair> again;
        for (const VerdictPair& pair : pairs)
            again.insert(again.end(), 3, pair);
        const CohenKappa repeated = cohenKappa(again, int(table.size()));
        QVERIFY(nearKappa(*repeated.value, value, 1e-12));
        QVERIFY(nearKappa(*repeated.standardError, error, 1e-12));
    }
    void theStandardErrorIsThatOfRepeatedStudies()
    {
        constexpr int runs = 2000, parts = 150;
        double sum = 0, squares = 0, stated = 0;
        for (int run = 0; run < runs; ++run) {
            RandomStream random(3, std::uint64_t(run), 0);
            std::vector<VerdictPair> pairs;
            for (int part = 0; part < parts; ++part) {
                const int truth = random.uniform() < 0.7 ? 0 : 1;
                const auto judged = [&] { return random.uniform() < 0.9 ? truth : 1 - truth; };
                const int first = judged(), second = judged();
                pairs.push_back({part, first, second});
                const int third = judged(), fourth = judged();
                pairs.push_back({part, third, fourth});
            }
            const CohenKappa kappa = cohenKappa(pairs, 2);
            sum += *kappa.value;
            squares += *kappa.value * *kappa.value;
            stated += *kappa.standardError;
        }
        const double deviation = std::sqrt(squares / runs - sum / runs * sum / runs);
        // 2000 runs know a deviation to 1.6 %; the formula is one for large samples.
        QVERIFY2(nearKappa(stated / runs / deviation, 1, 0.06),
                 qPrintable(QString::number(stated / runs / deviation)));
    }
    void kappaDoesNotExistWhereAllIsOneClass()
    {
        const CohenKappa one = cohenKappa(pairsOfTable({{10, 0}, {0, 0}}), 2);
        QVERIFY(!one.value && !one.standardError && *one.agreement == 1);
        const CohenKappa none = cohenKappa(std::vector<VerdictPair>{}, 2);
        QVERIFY(!none.value && !none.agreement && none.pairs == 0);
        const CohenKappa full = cohenKappa(pairsOfTable({{10, 0}, {0, 3}}), 2);
        QVERIFY(*full.value == 1 && !full.standardError);
        const CohenKappa apart = cohenKappa(pairsOfTable({{0, 5}, {5, 0}}), 2);
        QVERIFY(nearKappa(*apart.value, -1, 1e-15));
        const CohenKappa oneEach = cohenKappa(pairsOfTable({{0, 5}, {0, 0}}), 2);
        QVERIFY(nearKappa(*oneEach.value, 0, 1e-15));
    }
    /// Fleiss 1971: 30 patients, 6 psychiatrists; kappa and z as published, by class too.
    void fleissDiagnoses()
    {
        const QString file = QStringLiteral(GRIPSCOPE_SHARED_DATA "/quality/kappa_6_raters.csv");
        if (!QFileInfo::exists(file))
            QSKIP("the diagnoses are not there");
        const auto table = StudyTable::read(file);
        QVERIFY(table);
        RatingColumns columns;
        for (int rater = 1; rater <= 6; ++rater)
            columns.raters << u"rater%1"_s.arg(rater);
        const auto ratings = readRatings(*table, columns);
        QVERIFY(ratings);
        const FleissKappa kappa = fleissKappa(ratings->ratings, int(ratings->classes.size()));
        QCOMPARE(kappa.parts, std::size_t(30));
        QCOMPARE(kappa.ratings, std::size_t(180));
        QVERIFY(nearKappa(*kappa.value, 0.430, 0.0005) && nearKappa(*kappa.z, 17.7, 0.05));
        const QHash<QString, std::pair<double, double>> published{
            {u"1. Depression"_s, {0.245, 5.192}},
            {u"2. Personality Disorder"_s, {0.245, 5.192}},
            {u"3. Schizophrenia"_s, {0.520, 11.031}},
            {u"4. Neurosis"_s, {0.471, 9.994}},
            {u"5. Other"_s, {0.566, 12.009}}};
        QCOMPARE(kappa.classes.size(), std::size_t(5));
        for (const ClassKappa& one : kappa.classes) {
            const auto expected = published.value(ratings->classes[one.verdict]);
            QVERIFY(nearKappa(*one.value, expected.first, 0.0005) &&
                    nearKappa(*one.z, expected.second, 0.0005));
        }
    }
    /// With two verdicts a part it is Scott's pi: both raters share one set of class shares.
    void fleissOfTwoIsScottsPi()
    {
        const FleissKappa kappa = fleissKappa(ratingsOf({{0, 0}, {0, 1}, {1, 1}, {1, 1}, {2, 1}}), 3);
        const double expected = 0.09 + 0.36 + 0.01, observed = 0.6;
        QVERIFY(nearKappa(*kappa.value, (observed - expected) / (1 - expected), 1e-14));
    }
    void zIsStandardNormalWhereVerdictsAreDrawnBlindly()
    {
        constexpr int runs = 2000;
        double sum = 0, squares = 0;
        for (int run = 0; run < runs; ++run) {
            RandomStream random(11, std::uint64_t(run), 0);
            std::vector<std::vector<int>> parts;
            for (int part = 0; part < 60; ++part) {
                std::vector<int> verdicts;
                for (int i = 0; i < 2 + part % 4; ++i) { // unequal numbers
                    const double drawn = random.uniform();
                    verdicts.push_back(drawn < 0.6 ? 0 : drawn < 0.9 ? 1 : 2);
                }
                parts.push_back(verdicts);
            }
            const FleissKappa kappa = fleissKappa(ratingsOf(parts), 3);
            sum += *kappa.z;
            squares += *kappa.z * *kappa.z;
        }
        const double mean = sum / runs, deviation = std::sqrt(squares / runs - mean * mean);
        QVERIFY2(nearKappa(mean, 0, 0.15), qPrintable(QString::number(mean)));
        QVERIFY2(nearKappa(deviation, 1, 0.05), qPrintable(QString::number(deviation)));
    }
    void fleissWithoutChoiceDoesNotExist()
    {
        const FleissKappa same = fleissKappa(ratingsOf({{0, 0, 0}, {0, 0, 0}, {0, 0}}), 2);
        QVERIFY(!same.value && !same.z && same.parts == 3 && same.classes.size() == 1);
        const FleissKappa single = fleissKappa(ratingsOf({{0}, {1}}), 2);
        QVERIFY(!single.value && single.parts == 0);
        QVERIFY(!fleissKappa({}, 0).value);
        const FleissKappa full = fleissKappa(ratingsOf({{0, 0, 0}, {1, 1}, {1}}), 3); // a class nobody used
        QVERIFY(*full.value == 1 && full.parts == 2 && full.classes.size() == 2);
    }
};

GRIPSCOPE_TEST(KappaTest)
#include "kappa_test.moc"
