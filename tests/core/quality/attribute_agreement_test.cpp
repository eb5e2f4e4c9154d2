// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/agreement/attribute_agreement.h"
#include "tests/support/test_registry.h"

#include <QJsonObject>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

Expected<AttributeRatings> longTable(const QByteArray& rows, bool withReference)
{
    const auto table = StudyTable::parse(
        (withReference ? "part,rater,verdict,truth\n" : "part,rater,verdict\n") + rows, u"t.csv"_s);
    RatingColumns columns{u"part"_s, u"rater"_s, u"verdict"_s, {}, {}};
    if (withReference)
        columns.reference = u"truth"_s;
    return table ? readRatings(*table, columns) : tl::make_unexpected(table.error());
}

bool nearShare(double found, double expected, double absolute = 1e-12)
{
    return std::abs(found - expected) <= absolute;
}

bool says(const AttributeAgreement& study, const QString& words)
{
    return english(study.messages).join(u' ').contains(words);
}

/// AIAG's rater A: 16 parts not OK, 34 OK, each judged three times; 3 misses and 5 false alarms on 8 parts.
QByteArray fiftyParts()
{
    QByteArray rows;
    for (int part = 0; part < 50; ++part) {
        const bool good = part >= 16;
        const bool oneWrong = part < 3 || (part >= 16 && part < 21);
        for (int trial = 0; trial < 3; ++trial) {
            const bool verdict = oneWrong && trial == 1 ? !good : good;
            rows += QByteArray::number(part) + ",A," + (verdict ? "1," : "0,") + (good ? "1\n" : "0\n");
        }
    }
    return rows;
}

} // namespace

class AttributeAgreementTest : public QObject {
    Q_OBJECT
private slots:
    /// 84 %, 6.3 % and 4.9 % as published; limits by R's binom.test(42, 50).
    void effectivenessMissesAndFalseAlarms()
    {
        const auto ratings = longTable(fiftyParts(), true);
        QVERIFY(ratings);
        const auto study = studyAgreement(*ratings);
        QVERIFY(study);
        const RaterAgreement& rater = study->raters.front();
        QVERIFY(nearShare(*rater.effectiveness.value(), 0.84));
        QVERIFY(nearShare(rater.effectiveness.lower, 0.708873693405, 1e-10));
        QVERIFY(nearShare(rater.effectiveness.upper, 0.928299232817, 1e-10));
        QVERIFY(nearShare(*rater.misses.value(), 3.0 / 48) &&
                nearShare(*rater.falseAlarms.value(), 5.0 / 102));
        QVERIFY(nearShare(*rater.correct.value(), 142.0 / 150));
        QVERIFY(nearShare(*rater.repeatability.value(), 0.84));
        QVERIFY(nearShare(*rater.reference.value, 0.8787878787879, 1e-12));
        QCOMPARE(study->accepted, u"1"_s);
        QVERIFY(says(*study, u"A judges 84.0 % of the parts right"_s) && says(*study, u"accepts 6.3 %"_s));
    }
    void undecidedIsNeitherMissNorFalseAlarm()
    {
        const auto ratings = longTable("1,A,OK,OK\n2,A,NotOK,OK\n3,A,NotDecidable,OK\n4,A,OK,NotOK\n"
                                       "5,A,NotOK,NotOK\n6,A,NotDecidable,NotOK\n",
                                       true);
        QVERIFY(ratings);
        const auto study = studyAgreement(*ratings);
        QVERIFY(study);
        QCOMPARE(study->accepted, u"OK"_s);
        QCOMPARE(study->undecided, u"NotDecidable"_s);
        const RaterAgreement& rater = study->raters.front();
        QCOMPARE(rater.effectiveness.count, std::int64_t(2));
        QCOMPARE(rater.misses.count, std::int64_t(1));
        QCOMPARE(rater.misses.of, std::int64_t(3));
        QCOMPARE(rater.falseAlarms.count, std::int64_t(1));
        QCOMPARE(rater.falseAlarms.of, std::int64_t(3));
        QCOMPARE(rater.undecided.count, std::int64_t(2));
        QVERIFY(!rater.repeatability.value() && !rater.within.value); // one verdict a part
        QVERIFY(says(*study, u"undecided"_s));
    }
    void ofSeveralClassesOneIsAccepted()
    {
        const QByteArray rows =
            "1,A,soft,soft\n2,A,soft,hard\n3,A,hard,hard\n4,A,brittle,hard\n5,A,hard,soft\n";
        const auto ratings = longTable(rows, true);
        const auto unnamed = studyAgreement(*ratings);
        QVERIFY(unnamed && unnamed->accepted.isEmpty());
        QVERIFY(!unnamed->raters[0].misses.value() && !unnamed->raters[0].falseAlarms.value());
        QVERIFY(says(*unnamed, u"--accepted"_s));
        AgreementOptions options;
        options.accepted = u"hard"_s;
        const auto named = studyAgreement(*ratings, options);
        QVERIFY(named);
        QVERIFY(nearShare(*named->raters[0].misses.value(), 0.5));
        QVERIFY(nearShare(*named->raters[0].falseAlarms.value(), 2.0 / 3));
        QVERIFY(nearShare(*named->raters[0].effectiveness.value(), 0.4));
        options.accepted = u"jelly"_s;
        QVERIFY(studyAgreement(*ratings, options).error().code == ErrorCode::Usage);
        options.accepted = options.undecided = u"hard"_s;
        QVERIFY(studyAgreement(*ratings, options).error().code == ErrorCode::Usage);
    }
    void pairsAreTrialByTrialAsFarAsBothGo()
    {
        // A judges part 1 three times, B twice; part 2 only A; part 3 both once.
        const auto ratings = longTable("1,A,x\n1,B,x\n1,A,y\n1,B,y\n1,A,x\n2,A,x\n3,B,y\n3,A,y\n", false);
        const auto study = studyAgreement(*ratings);
        QVERIFY(study);
        QCOMPARE(study->pairs.size(), std::size_t(1));
        QCOMPARE(study->pairs[0].kappa.pairs, std::size_t(3));
        QVERIFY(*study->pairs[0].kappa.value == 1);
        QCOMPARE(study->incomplete, std::int64_t(1));
        QCOMPARE(study->all.of, std::int64_t(2));
        QCOMPARE(study->all.count, std::int64_t(1));
        QCOMPARE(study->raters[0].repeatability.of, std::int64_t(1));
        QCOMPARE(study->raters[0].repeatability.count, std::int64_t(0));
        QVERIFY(!study->hasReference && !study->raters[0].reference.value);
        QVERIFY(says(*study, u"1 parts were not judged by every rater"_s));
        QVERIFY(toJson(*study)[u"kappa"_s][u"reference"_s].isNull());
    }
    void aColumnARaterWithGaps()
    {
        const auto table =
            StudyTable::parse("A,B,C,truth\nOK,OK,,OK\nNotOK,,,NotOK\nOK,NotOK,,OK\n", u"w.csv"_s);
        QVERIFY(table);
        RatingColumns columns;
        columns.raters = {u"A"_s, u"B"_s, u"C"_s};
        columns.reference = u"truth"_s;
        const auto ratings = readRatings(*table, columns);
        QVERIFY(ratings);
        QCOMPARE(ratings->ratings.size(), std::size_t(5));
        const auto study = studyAgreement(*ratings);
        QVERIFY(study);
        QCOMPARE(study->incomplete, std::int64_t(3));
        QVERIFY(!study->all.value() && study->raters[2].ratings == 0);
        QVERIFY(nearShare(*study->raters[1].falseAlarms.value(), 0.5));
        QVERIFY(!study->raters[1].misses.value());
        QVERIFY(says(*study, u"C has judged no part"_s) && says(*study, u"2 pairs of raters"_s));
    }
    void fullAgreementOnOneClassHasNoKappa()
    {
        const auto ratings = longTable("1,A,OK,OK\n2,A,OK,OK\n1,B,OK,OK\n2,B,OK,OK\n", true);
        const auto study = studyAgreement(*ratings);
        QVERIFY(study);
        QVERIFY(!study->fleiss.value && !study->pairs[0].kappa.value && !study->raters[0].reference.value);
        QVERIFY(says(*study, u"kappa does not exist"_s));
        QVERIFY(nearShare(*study->all.value(), 1) && nearShare(*study->raters[0].effectiveness.value(), 1));
        const QJsonObject document = toJson(*study);
        QVERIFY(document[u"kappa"_s][u"fleiss"_s][u"value"_s].isNull());
        QVERIFY(document[u"kappa"_s][u"pairs"_s][0][u"value"_s].isNull());
        QVERIFY(document[u"raters"_s][u"A"_s][u"miss_rate"_s].isNull());
    }
    void aReferenceClassThatNobodyNamesCounts()
    {
        const auto ratings = longTable("1,A,OK,OK\n2,A,OK,NotOK\n1,B,OK,OK\n2,B,OK,NotOK\n", true);
        const auto study = studyAgreement(*ratings);
        QVERIFY(study);
        QVERIFY(*study->raters[0].misses.value() == 1 && *study->raters[0].falseAlarms.value() == 0);
        QVERIFY(nearShare(*study->raters[0].reference.value, 0));
        QVERIFY(nearShare(*study->allRight.value(), 0.5) && nearShare(*study->all.value(), 1));
    }
    void whatMakesNoSenseIsRefused()
    {
        const auto two = longTable("1,A,OK,OK\n1,B,OK,NotOK\n", true);
        QVERIFY(!two && two.error().describe().contains(u"for part 1"_s));
        QVERIFY(!longTable("1,A,\n", false));
        const auto table = StudyTable::parse("part,A,B\n1,,\n", u"w.csv"_s);
        RatingColumns columns;
        columns.raters = {u"A"_s, u"B"_s};
        QVERIFY(readRatings(*table, columns).error().code == ErrorCode::BadInput); // no verdict at all
        columns.raters = {u"A"_s, u"A"_s};
        QVERIFY(readRatings(*table, columns).error().code == ErrorCode::Usage);
        QVERIFY(readRatings(*table, RatingColumns{}).error().code == ErrorCode::Usage);
        QByteArray many;
        for (int i = 0; i <= mostRaters; ++i)
            many += "1," + QByteArray::number(i) + ",OK\n";
        QVERIFY(longTable(many, false).error().describe().contains(u"right column"_s));
        AgreementOptions options;
        options.confidence = 1;
        QVERIFY(!studyAgreement(*longTable("1,A,OK\n", false), options));
    }
};

GRIPSCOPE_TEST(AttributeAgreementTest)
#include "attribute_agreement_test.moc"
