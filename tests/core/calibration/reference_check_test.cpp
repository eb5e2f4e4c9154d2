// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/reference_check.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// 10 kN/m, known to 20 N/m, that may be found 300 N/m off.
ReferenceObject spring()
{
    ReferenceObject reference;
    reference.gripperSerial = u"0001"_s;
    reference.name = u"Spring S-12"_s;
    reference.stated[2] = ReferenceQuantity{10000, 20, 300};
    return reference;
}

ReferenceStanding standing(std::optional<CheckVerdict> last, const QDateTime& made)
{
    ReferenceStanding standing;
    static_cast<ReferenceObject&>(standing.reference) = spring();
    if (last) {
        standing.last.emplace();
        standing.last->verdict = *last;
        standing.last->made = made;
    }
    return standing;
}

} // namespace

class ReferenceCheckTest : public QObject {
    Q_OBJECT
private slots:
    void theEnNumberIsTheErrorInExpandedUncertainties()
    {
        // (10100 - 10000) / (2 sqrt(30^2 + 40^2)) = 1
        QCOMPARE(*enNumber({10100, 30}, {10000, 40, 300}), 1.0);
        QCOMPARE(*enNumber({9900, 30}, {10000, 40, 300}), -1.0);
        QCOMPARE(*enNumber({10000, 0}, {10000, 0, 300}), 0.0);
        QVERIFY(!enNumber({10001, 0}, {10000, 0, 300}));
    }

    void theToleranceDecides_data()
    {
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<double>("uncertainty");
        QTest::addColumn<int>("verdict");
        const auto row = [](const char* name, double value, double uncertainty, CheckVerdict verdict) {
            QTest::newRow(name) << value << uncertainty << int(verdict);
        };
        row("right", 10010, 30, CheckVerdict::Passed);
        row("at the tolerance", 10300, 30, CheckVerdict::Passed);
        row("beyond it", 10301, 30, CheckVerdict::Failed);
        row("beyond it on the other side", 9699, 30, CheckVerdict::Failed);
        row("an En number of 3 within it", 10290, 30, CheckVerdict::Passed);
        row("measured too coarsely to tell", 10010, 160, CheckVerdict::NotValid);
        row("not a number", std::numeric_limits<double>::quiet_NaN(), 30, CheckVerdict::NotValid);
    }
    void theToleranceDecides()
    {
        QFETCH(double, stiffness);
        QFETCH(double, uncertainty);
        QFETCH(int, verdict);
        MeasuredQuantities measured;
        measured[0] = MeasuredQuantity{1e9, 1}; // nothing is stated of the mass
        measured[2] = MeasuredQuantity{stiffness, uncertainty};
        QCOMPARE(int(judgeCheck(spring(), measured)), verdict);
    }

    void oneQuantityThatIsOffFailsTheCheck()
    {
        ReferenceObject reference = spring();
        reference.stated[1] = ReferenceQuantity{40, 0.1, 2};
        MeasuredQuantities measured;
        measured[2] = MeasuredQuantity{10010, 30};
        QVERIFY(judgeCheck(reference, measured) == CheckVerdict::NotValid); // b was not found
        measured[1] = MeasuredQuantity{43, 0.5};
        QVERIFY(judgeCheck(reference, measured) == CheckVerdict::Failed);
        measured[1] = MeasuredQuantity{41, 0.5};
        QVERIFY(judgeCheck(reference, measured) == CheckVerdict::Passed);
    }

    void whenItIsDue()
    {
        const QDateTime made(QDate(2026, 3, 1), QTime(6, 0), Qt::UTC);
        const auto at = [&](std::optional<CheckVerdict> last, int hours) {
            return checkStatus(standing(last, made), made.addSecs(3600 * hours));
        };
        QCOMPARE(checkStatus(std::nullopt, made), CheckStatus::NotAsked);
        QCOMPARE(at(std::nullopt, 0), CheckStatus::Due);
        QCOMPARE(at(CheckVerdict::Passed, 24), CheckStatus::Passed);
        QCOMPARE(at(CheckVerdict::Passed, 25), CheckStatus::Due);
        QCOMPARE(at(CheckVerdict::Failed, 1), CheckStatus::Failed);
        ReferenceStanding unasked = standing(CheckVerdict::Passed, made);
        unasked.reference.intervalHours = 0;
        QCOMPARE(checkStatus(unasked, made.addYears(1)), CheckStatus::Passed);
        QVERIFY(!checkHoldsUntil(unasked));
    }

    void whatCannotBeUsedIsRefusedWithAReason_data()
    {
        QTest::addColumn<QString>("what");
        for (const char* what :
             {"name", "stiffness", "value", "tolerance", "uncertainty", "force", "interval"})
            QTest::newRow(what) << QString::fromLatin1(what);
    }
    void whatCannotBeUsedIsRefusedWithAReason()
    {
        QFETCH(QString, what);
        QVERIFY(problemOf(spring()).isEmpty());
        ReferenceObject reference = spring();
        if (what == u"name")
            reference.name.clear();
        if (what == u"stiffness")
            reference.stated = {ReferenceQuantity{1, 0, 1}, {}, {}};
        if (what == u"value")
            reference.stated[2]->value = 0;
        if (what == u"tolerance")
            reference.stated[2]->tolerance = std::numeric_limits<double>::quiet_NaN();
        if (what == u"uncertainty")
            reference.stated[2]->standardUncertainty = 151; // twice that is above the tolerance
        if (what == u"force")
            reference.peak_N = 21;
        if (what == u"interval")
            reference.intervalHours = -1;
        QVERIFY(!problemOf(reference).isEmpty());
    }
};

GRIPSCOPE_TEST(ReferenceCheckTest)
#include "reference_check_test.moc"
