// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "ui/format/derived_quantities.h"
#include "ui/format/estimate_words.h"
#include "ui/models/estimate_table_model.h"

#include <QAbstractItemModelTester>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace gripscope;
using EstimateColumn = EstimateTableModel::Column;

class EstimateTableModelTest : public QObject {
    Q_OBJECT

    static QVariant cell(const EstimateTableModel& model, Estimator estimator, EstimateColumn column,
                         int role = Qt::EditRole)
    {
        return model.index(model.rowOf(estimator), int(column)).data(role);
    }

private slots:
    void keepsTheRulesOfAModel()
    {
        EstimateTableModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setIdentification(test::identifiedCanA(), QStringLiteral("N"), QStringLiteral("m"));
        QCOMPARE(model.rowCount(), 3);
        model.clear();
        QCOMPARE(model.rowCount(), 0);
    }
    void holdsRawNumbersInTheUnitsOfTheHeader()
    {
        const Identification found = test::identifiedCanA();
        EstimateTableModel model;
        model.setIdentification(found, QStringLiteral("N"), QStringLiteral("m"));
        const Estimate* best = found.find(Estimator::OutputError);
        QVERIFY(best && best->parameters);
        QCOMPARE(cell(model, Estimator::OutputError, EstimateColumn::Mass).toDouble(),
                 best->parameters->m * 1e3);
        QCOMPARE(cell(model, Estimator::OutputError, EstimateColumn::Stiffness).toDouble(),
                 best->parameters->k * 1e-3);
        const double half =
            cell(model, Estimator::OutputError, EstimateColumn::Mass, EstimateTableModel::HalfWidthRole)
                .toDouble();
        QVERIFY(std::abs(half / (1.959963984540054e3 * (*best->standardErrors())[0]) - 1) < 1e-12);
        QCOMPARE(model.headerData(int(EstimateColumn::Mass), Qt::Horizontal, Qt::DisplayRole).toString(),
                 QStringLiteral("m\ng"));
        QCOMPARE(model.headerData(int(EstimateColumn::Stiffness), Qt::Horizontal, Qt::DisplayRole).toString(),
                 QStringLiteral("k\nkN/m"));
    }
    void millimetresAreShownInSi()
    {
        const Identification found = test::identifiedCanA();
        EstimateTableModel model;
        model.setIdentification(found, QStringLiteral("N"), QStringLiteral("mm"));
        // The same numbers in N and mm mean a thousand times as much in SI: 39.6 N s^2/mm are 39.6 t.
        const double m = cell(model, Estimator::OutputError, EstimateColumn::Mass).toDouble();
        QVERIFY(std::abs(m / (found.find(Estimator::OutputError)->parameters->m * 1e3) - 1) < 1e-12);
        QCOMPARE(model.headerData(int(EstimateColumn::Mass), Qt::Horizontal, Qt::DisplayRole).toString(),
                 QStringLiteral("m\nkg"));
    }
    void unitsAsPrintedShowNone()
    {
        EstimateTableModel model;
        model.setIdentification(test::identifiedCanA(), QStringLiteral("1"), QStringLiteral("1"));
        QCOMPARE(model.headerData(int(EstimateColumn::Mass), Qt::Horizontal, Qt::DisplayRole).toString(),
                 QStringLiteral("m"));
    }
    void aBiasedEstimateSaysSoInNumbers()
    {
        const Identification found = test::identifiedCanA();
        QCOMPARE(estimateVerdict(found, *found.find(Estimator::OutputError)), QStringLiteral("recommended"));
        // Noise of 5 um biases the paper's estimator by tens of per cent in m (science of the matter, not
        // chance).
        QVERIFY(estimateVerdict(found, *found.find(Estimator::Arx)).startsWith(QStringLiteral("m ")));
        Estimate failed;
        failed.estimator = Estimator::Arx;
        failed.status = EstimateStatus::NoPhysicalMapping;
        QCOMPARE(estimateVerdict(found, failed), QStringLiteral("no physical m, b, k"));
    }
    void aFailedEstimateHasNoNumbers()
    {
        Identification found = test::identifiedCanA();
        Estimate failed;
        failed.estimator = Estimator::Duffing;
        found.estimates.push_back(failed);
        EstimateTableModel model;
        model.setIdentification(found, QStringLiteral("N"), QStringLiteral("m"));
        QVERIFY(!cell(model, Estimator::Duffing, EstimateColumn::Mass).isValid());
        QVERIFY(model.toTsv().contains(QStringLiteral("duffing\t\t\t\t\t\t\t\t\tnot applicable\n")));
    }
    void tabSeparatedTextReadsBack()
    {
        const Identification found = test::identifiedCanA();
        EstimateTableModel model;
        model.setIdentification(found, QStringLiteral("N"), QStringLiteral("m"));
        const QStringList lines = model.toTsv().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 4);
        const qsizetype columns = lines[0].count(u'\t');
        for (const QString& line : lines)
            QCOMPARE(line.count(u'\t'), columns);
        QVERIFY(lines[0].contains(QStringLiteral("m (kg)")));
        QCOMPARE(lines[2].section(u'\t', 1, 1).toDouble(), found.find(Estimator::OutputError)->parameters->m);
    }
    void aCubicSpringHasItsRoomInTheTable()
    {
        Identification found = test::identifiedCanA();
        Estimate cubic = *found.find(Estimator::OutputError);
        cubic.estimator = Estimator::Duffing;
        MotionEstimate& motion = cubic.motion.emplace();
        motion.terms.cubic = true;
        motion.values[MotionParameter::Cubic] = 3.8; // N/mm^3
        motion.covariance = 0.01 * Eigen::Matrix4d::Identity();
        found.estimates.push_back(cubic);
        EstimateTableModel model;
        model.setIdentification(found, QStringLiteral("N"), QStringLiteral("mm"));
        const int row = model.rowOf(Estimator::Duffing);
        QCOMPARE(model.index(row, 0).data(EstimateTableModel::FurtherRole).toStringList(),
                 QStringList{QString::fromUtf8("k3 = 3.8 ± 0.2\u00A0N/mm³")}); // 1.96 times 0.1
        QVERIFY(!model.index(0, 0).data(EstimateTableModel::FurtherRole).isValid());
        const QStringList lines = model.toTsv().split(u'\n');
        QVERIFY(lines[0].endsWith(QString::fromUtf8("\tk3 (N/m³)\tk3 95 % half width (N/m³)")));
        QVERIFY(std::abs(lines[row + 1].section(u'\t', -2, -2).toDouble() / 3.8e9 - 1) < 1e-12);
    }
    void whatHasNoSpringHasItsMassAndFriction()
    {
        Identification found = test::identifiedCanA();
        Estimate& carriage = found.estimates.emplace_back();
        carriage.estimator = Estimator::Carriage;
        carriage.status = EstimateStatus::Converged;
        MotionEstimate& motion = carriage.motion.emplace();
        motion.terms = {.spring = false, .friction = true};
        motion.values[MotionParameter::Mass] = 95.1;
        motion.values[MotionParameter::Damping] = 215;
        motion.values[MotionParameter::Friction] = 20;
        motion.covariance = Eigen::Vector3d(1, 4, 0.25).asDiagonal();
        found.recommended = Estimator::Carriage;
        EstimateTableModel model;
        model.setIdentification(found, QStringLiteral("N"), QStringLiteral("m"));
        QCOMPARE(cell(model, Estimator::Carriage, EstimateColumn::Mass).toDouble(), 95.1);
        QVERIFY(!cell(model, Estimator::Carriage, EstimateColumn::Stiffness).isValid());
        const int row = model.rowOf(Estimator::Carriage);
        QCOMPARE(model.index(row, 0).data(EstimateTableModel::FurtherRole).toStringList(),
                 QStringList{QString::fromUtf8("Fc = 20.0 ± 1.0\u00A0N")});
        QVERIFY(model.toTsv().contains(QStringLiteral("\tFc (N)\tFc 95 % half width (N)\n")));
        QCOMPARE(cell(model, Estimator::Carriage, EstimateColumn::Verdict).toString(),
                 QStringLiteral("recommended"));
    }
    void smallNumbersWithoutAPrefixGetAPower()
    {
        Identification found = test::identifiedCanA();
        for (Estimate& estimate : found.estimates)
            estimate.parameters = MassDampingStiffness{5.08e-6, 2.2e-4, 0.97};
        EstimateTableModel model;
        model.setIdentification(found, QStringLiteral("1"), QStringLiteral("1"));
        const int mass = int(EstimateTableModel::Column::Mass);
        QCOMPARE(model.headerData(mass, Qt::Horizontal, Qt::DisplayRole).toString(),
                 QString::fromUtf8("m\n×10⁻⁶"));
        QVERIFY(std::abs(model.index(0, mass).data(EstimateTableModel::SortRole).toDouble() - 5.08) < 1e-9);
        QCOMPARE(model.headerData(mass + 2, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("k"));
    }
    void derivedQuantitiesFollowFromTheParameters()
    {
        Estimate estimate;
        estimate.parameters = MassDampingStiffness{2, 3, 18};
        estimate.covariance = Eigen::Vector3d(0.04, 0.09, 0.36).asDiagonal();
        const auto derived = derivedQuantities(estimate);
        QVERIFY(derived);
        QVERIFY(std::abs(derived->naturalFrequency_Hz - 3 / (2 * std::numbers::pi)) < 1e-14);
        QVERIFY(std::abs(derived->dampingRatio - 0.25) < 1e-14);
        // By hand: f/2 sqrt(0.04/4 + 0.36/324), zeta sqrt(0.04/16 + 0.09/9 + 0.36/1296).
        const double f = derived->naturalFrequency_Hz;
        QVERIFY(std::abs(*derived->naturalFrequencyError_Hz - f / 2 * std::sqrt(0.01 + 0.36 / 324)) < 1e-12);
        QVERIFY(std::abs(*derived->dampingRatioError - 0.25 * std::sqrt(0.0025 + 0.01 + 0.36 / 1296)) <
                1e-12);
        estimate.parameters->m = 0;
        QVERIFY(!derivedQuantities(estimate));
    }
};

GRIPSCOPE_TEST(EstimateTableModelTest)
#include "estimate_table_model_test.moc"
