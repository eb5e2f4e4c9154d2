// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of quality from the squeezes of a library in place of a table.
#include "core/library/library.h"
#include "core/library/records/batch.h"
#include "core/math/gaussian.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

constexpr int studiedParts = 8, studiedTrials = 3;
constexpr std::array studiedOperators{"Ada", "Bob", "Eve"};

/// A squeeze with that k and an error of 5 N/m, in newtons and millimetres: the table is in SI.
NewInspection squeezeOf(double k, const QString& batchId)
{
    Estimate estimate;
    estimate.status = EstimateStatus::Converged;
    estimate.parameters = MassDampingStiffness{0.001, 0.01, k / 1000};
    estimate.covariance = Eigen::Matrix3d(Eigen::Vector3d(1e-10, 1e-8, 25e-6).asDiagonal());
    NewInspection inspection;
    inspection.grasp.estimates = {estimate};
    inspection.grasp.forceUnit = u"N"_s;
    inspection.grasp.positionUnit = u"mm"_s;
    inspection.verdict.kind = VerdictKind::Unknown;
    inspection.expectedType = u"A"_s;
    inspection.batchId = batchId;
    return inspection;
}

} // namespace

class LibraryStudyTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

    [[nodiscard]] ProgramRun study(const QString& text) const
    {
        return m_work.cli(u"study "_s.append(text).split(u' ', Qt::SkipEmptyParts));
    }

private slots:
    /// Batch 4711: 8 parts around 1000 N/m by 3 operators, 3 times each, and what does not count; 4712
    /// elsewhere, without part numbers.
    void initTestCase()
    {
        const auto library = Library::open(m_work.path(u"lib.db"_s));
        QVERIFY(library);
        GaussianNoise noise(3);
        const auto first = (*library)->beginBatch({u"4711"_s, 1000, {}, u"Ada"_s});
        QVERIFY(first);
        std::vector<double> parts;
        for (int p = 0; p < studiedParts; ++p)
            parts.push_back(1000 + 30 * noise());
        for (const char* name : studiedOperators)
            for (int p = 0; p < studiedParts; ++p)
                for (int trial = 0; trial < studiedTrials; ++trial) {
                    NewInspection inspection =
                        squeezeOf(parts[std::size_t(p)] + (name[0] - 'A') + 3 * noise(), first->id);
                    inspection.partNumber = u"P%1"_s.arg(p);
                    inspection.grasp.operatorName = QLatin1String(name);
                    QVERIFY((*library)->addInspection(inspection));
                }
        const auto spoiled = (*library)->addInspection(squeezeOf(5000, first->id));
        QVERIFY(spoiled && (*library)->voidInspection(spoiled->number, u"dropped"_s, u"Ada"_s));
        QVERIFY((*library)->endBatch(first->id, u"Ada"_s));
        const auto second = (*library)->beginBatch({u"4712"_s, 1000, {}, u"Ada"_s});
        QVERIFY(second);
        for (int i = 0; i < 10; ++i)
            QVERIFY((*library)->addInspection(squeezeOf(2000 + 30 * noise(), second->id)));
    }
    void everyStudyOfATableTakesIt_data()
    {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("key");
        QTest::newRow("gauge") << u"gauge --part part --operator operator --value k"_s << u"values"_s;
        QTest::newRow("type1") << u"type1 --value k --reference 1000 --tolerance 900"_s << u"cg"_s;
        QTest::newRow("linearity") << u"linearity --reference k --value k"_s << u"slope"_s;
        QTest::newRow("attributes") << u"attributes --part part --rater operator --verdict verdict "
                                       "--reference expected"_s
                                    << u"kappa"_s;
        QTest::newRow("capability") << u"capability --value k --lower 900 --upper 1100"_s << u"within"_s;
        QTest::newRow("chart") << u"chart --value k --kind xbar-r --subgroup 3"_s << u"points"_s;
        QTest::newRow("hotelling") << u"chart --value k,number --kind hotelling"_s << u"points"_s;
    }
    void everyStudyOfATableTakesIt()
    {
        QFETCH(QString, arguments);
        QFETCH(QString, key);
        const ProgramRun run = study(arguments + u" --library lib.db --batch 4711 --json"_s);
        QVERIFY2(run.exit == 0, run.err.constData());
        QVERIFY(run.json().contains(key));
        QVERIFY2(run.err.contains("1 squeezes are left out"), run.err.constData());
    }
    void aGaugeStudyFindsPartsAndOperators()
    {
        const QJsonObject found =
            study(
                u"gauge --part part --operator operator --value m,b,k --library lib.db --batch 4711 --json"_s)
                .json();
        // m and b are the same in every squeeze here, which cannot be studied.
        QCOMPARE(found[u"error"][u"code"].toString(), u"bad_input"_s);
        const QJsonObject stiffness =
            study(u"gauge --part part --operator operator --value k --uncertainty u_k --library lib.db "
                  "--batch 4711 --json"_s)
                .json();
        QCOMPARE(stiffness[u"design"].toString(), u"crossed"_s);
        QVERIFY(stiffness[u"balanced"].toBool());
        const QJsonObject value = stiffness[u"values"][u"k"].toObject();
        QVERIFY(std::abs(value[u"mean"].toDouble() - 1000) < 40);
        const double repeatability = value[u"components"][u"repeatability"][u"variance"].toDouble();
        QVERIFY(repeatability > 4.5 && repeatability < 18); // 9, with 48 degrees of freedom or more
        // 3 N/m between repeats where the squeezes say 5.
        QVERIFY(std::abs(value[u"repeat_consistency"][u"stated_deviation"].toDouble() - 5) < 1e-6);
        QVERIFY(value[u"repeat_consistency"][u"p_below"].toDouble() < 0.01);
    }
    void partsWithoutANumberAreTold()
    {
        const ProgramRun run = study(u"chart --value k --library lib.db"_s);
        QCOMPARE(run.exit, 0);
        QVERIFY2(run.err.contains("No part is named for 10 of 82 squeezes"), run.err.constData());
        QVERIFY(run.out.contains("Not steady")); // 4712 stands elsewhere
    }
    void everyColumnIsThere()
    {
        // A column of words is told to be no number, with its first cell; one that is not there, otherwise.
        for (const auto& [column, first] :
             {std::pair(u"operator"_s, "Ada"), {u"expected"_s, "\"A\""}, {u"verdict"_s, "unknown"}}) {
            const ProgramRun run = study(u"chart --library lib.db --batch 4711 --value %1"_s.arg(column));
            QCOMPARE(run.exit, 3);
            QVERIFY2(run.err.contains(first) && run.err.contains("batch 4711"), run.err.constData());
        }
        for (const QString& column : {u"m"_s, u"b"_s, u"k"_s, u"u_m"_s, u"u_b"_s, u"u_k"_s, u"number"_s})
            QCOMPARE(
                study(u"chart --library lib.db --batch 4711 --target 1 --sigma 1 --value %1"_s.arg(column))
                    .exit,
                0);
    }
    void badInputIsToldInWords_data()
    {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<int>("exit");
        QTest::addColumn<QByteArray>("told");
        const auto row = [](const char* name, const QString& arguments, int exit, const char* told) {
            QTest::newRow(name) << arguments << exit << QByteArray(told);
        };
        row("neither", u"chart --value k"_s, 2, "--library DB --batch NAME");
        row("table and library", u"chart t.csv --value k --library lib.db"_s, 2, "both");
        row("no such library", u"chart --value k --library none.db"_s, 5, "none.db");
        row("no such batch", u"chart --value k --library lib.db --batch 9"_s, 3, "4711, 4712");
        row("no such column", u"chart --value weight --library lib.db"_s, 3, "weight");
    }
    void badInputIsToldInWords()
    {
        QFETCH(QString, arguments);
        QFETCH(int, exit);
        QFETCH(QByteArray, told);
        m_work.write(u"t.csv"_s, "k\n990\n1000\n");
        const ProgramRun run = study(arguments);
        QVERIFY2(run.exit == exit, run.err.constData());
        QVERIFY2(run.err.contains(told), run.err.constData());
        QVERIFY(run.out.isEmpty());
        const ProgramRun nameless = m_work.cli({u"study"_s, u"chart"_s, u"--value"_s, u"k"_s, u"--library"_s,
                                                u"lib.db"_s, u"--batch"_s, QString()});
        QCOMPARE(nameless.exit, 2);
    }
};

GRIPSCOPE_TEST(LibraryStudyTest)
#include "library_study_test.moc"
