// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/cluster_agreement.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// One letter a truth, one digit a label.
ClusterAgreement agreement(const QString& truth, const QString& labels, int clusters)
{
    QStringList names;
    std::vector<int> numbers;
    for (QChar letter : truth)
        names += QString(letter);
    for (QChar digit : labels)
        numbers.push_back(digit.digitValue());
    return clusterAgreement(names, numbers, clusters);
}

} // namespace

class ClusterAgreementTest : public QObject {
    Q_OBJECT
private slots:
    void adjustedRandIndex_data()
    {
        QTest::addColumn<QString>("truth");
        QTest::addColumn<QString>("labels");
        QTest::addColumn<double>("wanted");
        QTest::newRow("same") << u"AABBCC"_s << u"001122"_s << 1.0;
        QTest::newRow("same under other numbers") << u"AABBCC"_s << u"220011"_s << 1.0;
        // Worked by hand: pairs together 2, in truth 6, in clusters 3, of 15: (2 - 1.2) / (4.5 - 1.2).
        QTest::newRow("three pairs against two triples") << u"AAABBB"_s << u"001122"_s << 0.8 / 3.3;
        // Nothing agrees: (0 - 2/3) / (2 - 2/3).
        QTest::newRow("crossed") << u"AABB"_s << u"0101"_s << -0.5;
        QTest::newRow("one cluster says nothing") << u"AABB"_s << u"0000"_s << 0.0;
        QTest::newRow("all apart says nothing") << u"AABB"_s << u"0123"_s << 0.0;
        QTest::newRow("both one lump") << u"AAAA"_s << u"0000"_s << 1.0;
        QTest::newRow("both all apart") << u"ABCD"_s << u"0123"_s << 1.0;
        QTest::newRow("one item") << u"A"_s << u"0"_s << 1.0;
        QTest::newRow("nothing") << u""_s << u""_s << 1.0;
    }
    void adjustedRandIndex()
    {
        QFETCH(QString, truth);
        QFETCH(QString, labels);
        QFETCH(double, wanted);
        // Sums of small whole numbers and one division: exact to rounding.
        QVERIFY(std::abs(agreement(truth, labels, 4).adjustedRandIndex - wanted) < 1e-15);
    }
    void countsAreByTruthInSortedOrder()
    {
        const ClusterAgreement found = agreement(u"BABA"_s, u"0112"_s, 3);
        QCOMPARE(found.truths, QStringList({u"A"_s, u"B"_s}));
        Eigen::MatrixXi wanted(2, 3);
        wanted << 0, 1, 1, 1, 1, 0;
        QVERIFY(found.counts == wanted);
    }
    void tableHoldsTheClustersOfTheTthItems()
    {
        const auto table = clusterTable({u"B"_s, u"A"_s, u"B"_s, u"A"_s, u"B"_s}, {2, 0, 2, 1, 1});
        QCOMPARE(table, (std::vector<std::vector<int>>{{1, 3}, {2, 3}, {0, 2}}));
    }
};

GRIPSCOPE_TEST(ClusterAgreementTest)
#include "cluster_agreement_test.moc"
