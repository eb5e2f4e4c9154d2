// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/models/comparison_table_model.h"
#include "ui/pages/fit/fit_page_summary.h"
#include "ui/theme/theme.h"

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QTableView>
#include <QTest>

using namespace gripscope;

namespace {

ModelComparison exampleComparison()
{
    ModelComparison comparison;
    comparison.criterion = QStringLiteral("BIC");
    comparison.sentence = QStringLiteral("a stiffening spring explains this squeeze better");
    for (const auto& [id, delta] : {std::pair("cubic_spring", 0.0), std::pair("linear", 123.4)}) {
        ComparedModel model;
        model.id = QLatin1String(id);
        model.words = QStringLiteral("words of ") + model.id;
        model.delta = delta;
        model.weight = delta > 0 ? 0 : 1;
        model.change = delta > 0 ? 0 : 7.25;
        model.estimate.fit.simulationPercent = delta > 0 ? 86.1 : 98.2;
        comparison.ranked.push_back(model);
    }
    return comparison;
}

} // namespace

class ComparisonTableTest : public QObject {
    Q_OBJECT
    using Column = ComparisonTableModel::Column;

private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void theBestModelComesFirstWithItsNumbers()
    {
        ComparisonTableModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setComparison(exampleComparison());
        const auto text = [&](int row, Column column) {
            return model.index(row, int(column)).data().toString();
        };
        QCOMPARE(text(0, Column::Model), QStringLiteral("Cubic spring"));
        QCOMPARE(text(0, Column::Delta), QStringLiteral("best"));
        QCOMPARE(text(1, Column::Delta), QStringLiteral("+123"));
        QVERIFY(text(0, Column::Change).startsWith(QStringLiteral("7.")));
        QCOMPARE(text(1, Column::SimulationFit), QStringLiteral("86.1"));
        QCOMPARE(model.headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("BIC"));
        QVERIFY(model.toTsv().contains(QStringLiteral("\nlinear\t123.4\t0\t0\t86.1\n")));
    }
    void theSentenceIsSaidInFull()
    {
        ModelPanel panel;
        panel.setComparison(exampleComparison());
        const auto said = [&] { return panel.findChild<QLabel*>()->text(); };
        QCOMPARE(said(), QStringLiteral("A stiffening spring explains this squeeze better."));
        QVERIFY(panel.findChild<QTableView*>()->isVisibleTo(&panel));
        panel.setComparison({});
        QCOMPARE(said(), QStringLiteral("No other model was compared with this one."));
        QVERIFY(!panel.findChild<QTableView*>()->isVisibleTo(&panel));
    }
};

GRIPSCOPE_TEST(ComparisonTableTest)
#include "comparison_table_test.moc"
