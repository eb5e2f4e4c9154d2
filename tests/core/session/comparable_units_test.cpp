// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/comparable_units.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class ComparableUnitsTest : public QObject {
    Q_OBJECT
private:
    static TypeRecord type(const QString& name, const QString& force, const QString& position)
    {
        TypeRecord record;
        record.name = name;
        record.forceUnit = force;
        record.positionUnit = position;
        return record;
    }

private slots:
    void theFactorTakesOnePairOfUnitsToAnother()
    {
        QCOMPARE(parameterFactor(u"N"_s, u"m"_s, u"N"_s, u"m"_s).value(), 1.0);
        QCOMPARE(parameterFactor(u"1"_s, u"1"_s, u"1"_s, u"1"_s).value(), 1.0);
        // 1 N/mm is 1000 N/m, and 1 mN/mm is 1 N/m.
        QCOMPARE(parameterFactor(u"N"_s, u"mm"_s, u"N"_s, u"m"_s).value(), 1000.0);
        QCOMPARE(parameterFactor(u"mN"_s, u"mm"_s, u"N"_s, u"mm"_s).value(), 1e-3);
    }
    void unitsWithoutAMeaningAreComparedWithThemselvesOnly()
    {
        QCOMPARE(parameterFactor(u"1"_s, u"1"_s, u"N"_s, u"m"_s).error().code, ErrorCode::UnitsDiffer);
        QCOMPARE(parameterFactor(u"N"_s, u"1"_s, u"1"_s, u"1"_s).error().code, ErrorCode::UnitsDiffer);
        QCOMPARE(parameterFactor(u"stone"_s, u"inch"_s, u"stone"_s, u"inch"_s).value(), 1.0);
    }
    void typesInSiAndTypesAsPrintedAreKeptApart()
    {
        const ComparableTypes types(
            {type(u"A"_s, u"N"_s, u"m"_s), type(u"B"_s, u"N"_s, u"mm"_s), type(u"P"_s, u"1"_s, u"1"_s)},
            {{u"A"_s, {0.04, 43, 9990}}, {u"B"_s, {0.03, 40, 10500}}, {u"P"_s, {0.037, 0.13, 0.095}}});
        const auto si = types.modelsFor(u"N"_s, u"mm"_s);
        QCOMPARE(si->factor, 1000.0);
        QCOMPARE(si->types->whole()->types.size(), std::size_t(2));
        QVERIFY(!si->types->whole()->find(u"P"_s));
        const auto printed = types.modelsFor(u"1"_s, u"1"_s);
        QCOMPARE(printed->factor, 1.0);
        QCOMPARE(printed->types->whole()->types.size(), std::size_t(1));
        QCOMPARE(types.main().types.size(), std::size_t(2));
        QCOMPARE(types.modelsFor(u"stone"_s, u"inch"_s).error().code, ErrorCode::UnitsDiffer);
    }
    void anEmptyLibraryFitsEveryUnit()
    {
        const ComparableTypes none;
        QVERIFY(none.modelsFor(u"1"_s, u"1"_s)->types->whole()->types.empty());
        QVERIFY(none.main().types.empty());
    }
};

GRIPSCOPE_TEST(ComparableUnitsTest)
#include "comparable_units_test.moc"
