// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/models/history_csv.h"
#include "ui/models/history_delegate.h"
#include "ui/models/history_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

using namespace gripscope;
using Column = HistoryModel::Column;

namespace {

InspectionRecord inspection(qint64 number)
{
    InspectionRecord record;
    record.number = number;
    record.inspected = QDateTime(QDate(2020, 3, 1), QTime(12, 0), Qt::UTC).addSecs(number);
    record.expectedType = QStringLiteral("A");
    record.verdict = VerdictKind::Type;
    record.type = number % 2 ? QStringLiteral("A") : QStringLiteral("B");
    record.posterior = 0.9998;
    record.parameters = MassDampingStiffness{0.0396, 43, 9990};
    record.forceUnit = QStringLiteral("N");
    record.positionUnit = QStringLiteral("m");
    record.seconds = 1;
    record.operatorName = QStringLiteral("Mai");
    return record;
}

std::vector<InspectionRecord> page(qint64 newest, int count)
{
    std::vector<InspectionRecord> records;
    for (int i = 0; i < count; ++i)
        records.push_back(inspection(newest - i));
    return records;
}

} // namespace

class HistoryModelTest : public QObject {
    Q_OBJECT
private slots:
    void keepsTheRulesOfAModelWhileItGrows()
    {
        HistoryModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.restart(5, page(5, 3));
        model.append(3, page(2, 2));
        QCOMPARE(model.rowCount(), 5);
        model.restart(0, {});
        QCOMPARE(model.rowCount(), 0);
    }
    void asksForThePagesItLacksOneAtATime()
    {
        HistoryModel model;
        QSignalSpy asked(&model, &HistoryModel::pageAsked);
        model.restart(450, page(450, 200));
        QVERIFY(model.canFetchMore({}));
        model.fetchMore({});
        model.fetchMore({}); // the first answer is still on its way
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked.first().first().toInt(), 200);
        model.append(200, page(250, 200));
        model.fetchMore({});
        QCOMPARE(asked.last().first().toInt(), 400);
        model.append(400, page(50, 50));
        QVERIFY(!model.canFetchMore({}));
    }
    void aPageForAnOlderListIsIgnored()
    {
        HistoryModel model;
        model.restart(8, page(8, 4));
        model.append(0, page(8, 4));
        QCOMPARE(model.rowCount(), 4);
    }
    void anEmptyPageEndsTheList()
    {
        HistoryModel model;
        model.restart(10, page(10, 4));
        model.append(4, {});
        QVERIFY(!model.canFetchMore({}));
        QCOMPARE(model.total(), 4);
    }
    void holdsRawValuesAndWordsThemInTheDelegate()
    {
        HistoryModel model;
        model.restart(2, page(2, 2));
        const auto cell = [&](int row, Column column) { return model.index(row, int(column)); };
        QCOMPARE(cell(0, Column::Mass).data(HistoryModel::SortRole).toDouble(), 0.0396);
        QCOMPARE(HistoryDelegate::text(cell(0, Column::Mass)),
                 QStringLiteral("39.6") + QChar::Nbsp + QStringLiteral("g"));
        QCOMPARE(cell(0, Column::Outcome).data(Qt::EditRole).toInt(), int(InspectionOutcome::OtherType));
        QCOMPARE(HistoryDelegate::text(cell(1, Column::Outcome)), QStringLiteral("as expected"));
        QCOMPARE(HistoryDelegate::text(cell(1, Column::Posterior)), QStringLiteral("0.9998"));
        QVERIFY(HistoryDelegate::text(cell(1, Column::Time)).startsWith(QStringLiteral("2020-03-01")));
    }
    void aPartOfNoTypeHasNoPosterior()
    {
        HistoryModel model;
        InspectionRecord stranger = inspection(1);
        stranger.verdict = VerdictKind::Unknown;
        model.restart(1, {stranger});
        QVERIFY(!model.index(0, int(Column::Posterior)).data(Qt::EditRole).isValid());
    }
    void csvKeepsEveryDigitAndQuotesNames()
    {
        InspectionRecord record = inspection(7);
        record.operatorName = QStringLiteral("Nguyen, \"Mai\"");
        record.parameters->m = 0.1 + 0.2;
        const QString text = QString::fromUtf8(toCsv({record}));
        const QStringList lines = text.split(u'\n');
        QVERIFY(lines[0].startsWith(QStringLiteral("number,time_utc,expected,outcome")));
        QVERIFY(lines[1].startsWith(QStringLiteral("7,2020-03-01T12:00:07.000Z,A,as_expected,type,A,")));
        QVERIFY(lines[1].contains(QStringLiteral(",0.30000000000000004,kg,")));
        QVERIFY(lines[1].contains(QStringLiteral("\"Nguyen, \"\"Mai\"\"\"")));
    }
};

GRIPSCOPE_TEST(HistoryModelTest)
#include "history_model_test.moc"
