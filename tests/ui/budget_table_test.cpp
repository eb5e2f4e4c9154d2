// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/format/interval_text.h"
#include "ui/models/budget_table_model.h"
#include "ui/pages/fit/fit_page_summary.h"
#include "ui/theme/theme.h"

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QTableView>
#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

/// Noise of 3 and a lag of 4 per cent of m = 0.04 kg, b = 40 N s/m, k = 10 kN/m: 5 % combined.
UncertaintyBudget exampleBudget()
{
    UncertaintyBudget budget;
    budget.parameters = MassDampingStiffness{0.04, 40, 10000};
    const Eigen::Vector3d values = budget.parameters->vector();
    for (const auto& [id, percent] : {std::pair("position_noise", 3.0), std::pair("lag", 4.0)}) {
        BudgetLine line;
        line.id = QLatin1String(id);
        line.words = QStringLiteral("as large as ") + line.id;
        const Eigen::Vector3d u = values * percent / 100;
        line.covariance = u.cwiseProduct(u).asDiagonal();
        line.share.setConstant(percent * percent / 25);
        budget.lines.push_back(line);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const double u = 0.05 * values[Eigen::Index(i)];
        budget.combined[i] = {u, std::nullopt, 1.96};
        budget.intervals[i] = {values[Eigen::Index(i)] - 1.96 * u, values[Eigen::Index(i)] + 1.96 * u, false,
                               false};
    }
    return budget;
}

double number(const BudgetTableModel& model, int row, BudgetTableModel::Column column)
{
    return model.index(row, int(column)).data(BudgetTableModel::SortRole).toDouble();
}

} // namespace

class BudgetTableTest : public QObject {
    Q_OBJECT
    using Column = BudgetTableModel::Column;

private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void everyEffectIsALineAndTheSumsComeLast()
    {
        BudgetTableModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setBudget(exampleBudget(), QStringLiteral("N"), QStringLiteral("m"));
        QCOMPARE(model.rowCount(), 4);
        QCOMPARE(model.index(0, 0).data().toString(), QStringLiteral("Position noise"));
        QCOMPARE(model.headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("u(m)\ng"));
        QVERIFY(std::abs(number(model, 0, Column::Mass) - 1.2) < 1e-12);
        QVERIFY(std::abs(model.index(1, 3).data(BudgetTableModel::ShareRole).toDouble() - 0.64) < 1e-12);
        QVERIFY(model.index(2, 0).data(BudgetTableModel::SumRole).toBool());
        QVERIFY(std::abs(number(model, 2, Column::Stiffness) - 0.5) < 1e-12); // kN/m
        QVERIFY(std::abs(number(model, 3, Column::Stiffness) - 0.98) < 1e-12);
        QVERIFY(!model.index(3, 3).data(BudgetTableModel::ShareRole).isValid());
    }
    void unitsOfTheChannelsGoToSi()
    {
        BudgetTableModel model;
        model.setBudget(exampleBudget(), QStringLiteral("N"), QStringLiteral("mm"));
        // 0.04 N s^2/mm are 40 kg: 3 % of them are 1.2 kg.
        QCOMPARE(model.headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("u(m)\nkg"));
        QVERIFY(std::abs(number(model, 0, Column::Mass) - 1.2) < 1e-12);
    }
    void textReadsBackWithFullPrecision()
    {
        BudgetTableModel model;
        model.setBudget(exampleBudget(), QStringLiteral("N"), QStringLiteral("m"));
        const QStringList lines = model.toTsv().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), qsizetype(5));
        QVERIFY(lines[0].startsWith(QStringLiteral("effect\tu(m) (kg)\t")));
        QVERIFY(std::abs(lines[1].section(u'\t', 1, 1).toDouble() / 0.0012 - 1) < 1e-12);
        QVERIFY(lines[4].startsWith(QStringLiteral("expanded\t")));
    }
    void withoutABudgetThereIsNothing()
    {
        BudgetTableModel model;
        model.setBudget({}, QStringLiteral("N"), QStringLiteral("m"));
        QCOMPARE(model.rowCount(), 0);
    }
    void theWordsFollowTheRow()
    {
        BudgetPanel panel;
        panel.setBudget(exampleBudget(), QStringLiteral("N"), QStringLiteral("m"));
        panel.show();
        auto* table = panel.findChild<QTableView*>();
        const auto said = [&] {
            QStringList texts;
            for (const QLabel* label : panel.findChildren<QLabel*>())
                if (label->isVisibleTo(&panel))
                    texts << label->text();
            return texts.join(u'\n');
        };
        QVERIFY(said().contains(QStringLiteral("as large as position_noise")));
        QTest::keyClick(table, Qt::Key_Down);
        QVERIFY(said().contains(QStringLiteral("as large as lag")));
    }
    void barsAreAsLongAsTheShares()
    {
        BudgetPanel panel;
        panel.resize(372, 300);
        panel.setBudget(exampleBudget(), QStringLiteral("N"), QStringLiteral("m"));
        panel.show();
        auto* table = panel.findChild<QTableView*>();
        table->clearSelection();
        const QImage image = table->viewport()->grab().toImage();
        const auto accentIn = [&](int row) {
            const QRect cell = table->visualRect(table->model()->index(row, int(Column::Mass)));
            int widest = 0;
            for (int y = cell.top(); y < cell.bottom(); ++y) {
                int run = 0;
                for (int x = cell.left(); x <= cell.right(); ++x)
                    run += image.pixelColor(x, y) == themeTokens(ThemeKind::Light).accent ? 1 : 0;
                widest = std::max(widest, run);
            }
            return widest;
        };
        QVERIFY2(std::abs(accentIn(0) - 0.36 * 44) < 3, qPrintable(QString::number(accentIn(0))));
        QVERIFY2(std::abs(accentIn(1) - 0.64 * 44) < 3, qPrintable(QString::number(accentIn(1))));
    }
    void intervalsSayWhatTheyAre()
    {
        const QString unit = QStringLiteral("kN/m");
        QCOMPARE(intervalText(9.98, {9.93, 10.03, false, false}, unit),
                 QString::fromUtf8("9.98 ± 0.05\u00A0kN/m"));
        QCOMPARE(intervalText(10, {8, 13, true, false}, unit), QString::fromUtf8("10\u00A0kN/m (8 to 13)"));
        QCOMPARE(intervalText(1, {0, 3.1, true, true}, QStringLiteral("g")),
                 QString::fromUtf8("at most 3.1\u00A0g"));
    }
};

GRIPSCOPE_TEST(BudgetTableTest)
#include "budget_table_test.moc"
