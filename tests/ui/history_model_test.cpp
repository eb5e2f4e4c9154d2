// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/library/history_document.h"
#include "tests/support/test_registry.h"
#include "ui/models/history_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

HistoryEntry inspection(qint64 number)
{
    HistoryEntry entry;
    entry.graspId = u"g%1"_s.arg(number);
    entry.number = number;
    entry.time = QDateTime(QDate(2020, 3, 1), QTime(12, 0), Qt::UTC).addSecs(number);
    entry.expectedType = u"A"_s;
    entry.verdict = VerdictKind::Type;
    entry.type = number % 2 ? u"A"_s : u"B"_s;
    entry.posterior = 0.9998;
    entry.parameters = MassDampingStiffness{0.0396, 43, 9990};
    entry.standardErrors = Eigen::Vector3d(1e-4, 0.1, 10);
    entry.forceUnit = u"N"_s;
    entry.positionUnit = u"m"_s;
    entry.seconds = 1;
    entry.operatorName = u"Mai"_s;
    entry.estimator = u"oe"_s;
    return entry;
}

/// The keys of inspections `newest`, ..., 1.
HistoryKeys keysDownFrom(qint64 newest)
{
    HistoryKeys keys;
    for (qint64 number = newest; number > 0; --number)
        keys.append(u"g%1"_s.arg(number));
    return keys;
}

std::vector<HistoryEntry> page(qint64 newest, int count)
{
    std::vector<HistoryEntry> entries;
    for (int i = 0; i < count; ++i)
        entries.push_back(inspection(newest - i));
    return entries;
}

} // namespace

class HistoryModelTest : public QObject {
    Q_OBJECT
private slots:
    void keepsTheRulesOfAModelWhilePagesComeAndGo()
    {
        HistoryModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.restart(keysDownFrom(500), page(500, 200));
        QCOMPARE(model.rowCount(), 500);
        model.setPage(1, page(300, 200));
        model.setPage(9, page(300, 200)); // of an older, longer list
        QCOMPARE(model.rowCount(), 500);
        model.restart({}, {});
        QCOMPARE(model.rowCount(), 0);
    }
    void asksForThePageThatIsLookedAtOnce()
    {
        HistoryModel model;
        QSignalSpy asked(&model, &HistoryModel::pageAsked);
        model.restart(keysDownFrom(100'000), page(100'000, 200));
        QVERIFY(model.index(199, 0).data().isValid());
        QCOMPARE(asked.size(), 0);
        QVERIFY(!model.index(99'999, 0).data().isValid()); // the end, at once
        QVERIFY(!model.index(99'900, 3).data().isValid());
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked[0][0].toInt(), 499);
        QCOMPARE(model.pageKeys(499).size(), std::size_t(200));
        QCOMPARE(model.pageKeys(499).back(), u"g1"_s);
        model.setPage(499, page(200, 200));
        QCOMPARE(model.index(99'999, int(HistoryColumn::Number)).data().toLongLong(), 1);
        model.index(50'000, 0).data();
        model.forgetRequest(250);
        model.index(50'000, 0).data();
        QCOMPARE(asked.size(), 3);
    }
    void holdsFewPagesHoweverFarItIsScrolled()
    {
        HistoryModel model;
        model.restart(keysDownFrom(100'000), page(100'000, 200));
        for (int i = 1; i < 500; ++i) {
            model.index(0, 0).data(); // the first page stays in use
            model.setPage(i, page(100'000 - 200 * i, 200));
            QVERIFY(model.pagesHeld() <= HistoryModel::pagesKept);
        }
        QVERIFY(model.entry(0));
        QVERIFY(model.entry(99'999));
        QVERIFY(!model.entry(50'000));
    }
    void findsARowByItsKey()
    {
        HistoryModel model;
        model.restart(keysDownFrom(1000), {});
        QCOMPARE(model.rowOf(u"g1000"_s), 0);
        QCOMPARE(model.rowOf(u"g1"_s), 999);
        QCOMPARE(model.rowOf(u"g0"_s), -1);
        QCOMPARE(model.key(998), u"g2"_s);
    }
    void sortingIsForTheLibrary()
    {
        HistoryModel model;
        QSignalSpy asked(&model, &HistoryModel::sortAsked);
        model.sort(int(HistoryColumn::Stiffness), Qt::AscendingOrder);
        QCOMPARE(asked.size(), 1);
        QVERIFY(asked[0][0].value<HistoryColumn>() == HistoryColumn::Stiffness);
    }
    void holdsRawValuesAndWordsThemInTheDelegate()
    {
        HistoryModel model;
        model.restart(keysDownFrom(3), page(3, 2));
        const auto cell = [&](int row, HistoryColumn column) { return model.index(row, int(column)); };
        QCOMPARE(cell(0, HistoryColumn::Mass).data(HistoryModel::SortRole).toDouble(), 0.0396);
        QCOMPARE(HistoryDelegate::text(cell(0, HistoryColumn::Mass)), u"39.6"_s);
        QCOMPARE(cell(1, HistoryColumn::Outcome).data(Qt::EditRole).toInt(),
                 int(InspectionOutcome::OtherType));
        QCOMPARE(HistoryDelegate::text(cell(0, HistoryColumn::Outcome)), u"as expected"_s);
        QCOMPARE(HistoryDelegate::text(cell(0, HistoryColumn::Posterior)), u"0.9998"_s);
        QVERIFY(HistoryDelegate::text(cell(0, HistoryColumn::Time)).startsWith(u"2020-03-01"_s));
        QCOMPARE(HistoryDelegate::text(cell(0, HistoryColumn::Device)), QString(QChar(0x2013))); // not known
        QCOMPARE(HistoryDelegate::text(cell(2, HistoryColumn::Type)),
                 QString(QChar(0x2026))); // not there yet
    }
    void aPartOfNoTypeHasNoPosterior()
    {
        HistoryModel model;
        HistoryEntry stranger = inspection(1);
        stranger.verdict = VerdictKind::Unknown;
        model.restart(keysDownFrom(1), {stranger});
        QVERIFY(!model.index(0, int(HistoryColumn::Posterior)).data(Qt::EditRole).isValid());
    }
    void csvKeepsEveryDigitAndQuotesNames()
    {
        HistoryEntry entry = inspection(7);
        entry.operatorName = u"Nguyen, \"Mai\""_s;
        entry.parameters->m = 0.1 + 0.2;
        const QStringList header = QString::fromUtf8(historyCsvHeader()).trimmed().split(u',');
        const QString line = QString::fromUtf8(toCsv({entry}));
        QVERIFY(line.startsWith(u"7,2020-03-01T12:00:07.000Z,inspection,A,as_expected,type,A,"_s));
        QVERIFY2(line.contains(u",0.30000000000000004,1e-04,kg,"_s), qPrintable(line));
        QVERIFY(line.contains(u"\"Nguyen, \"\"Mai\"\"\""_s));
        QCOMPARE(QString(line).remove(u"\"Nguyen, \"\"Mai\"\"\""_s).count(u',') + 1, header.size());
    }
};

GRIPSCOPE_TEST(HistoryModelTest)
#include "history_model_test.moc"
