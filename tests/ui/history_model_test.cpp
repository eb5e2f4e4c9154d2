// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/session/library/history_document.h"
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"
#include "ui/format/estimate_words.h"
#include "ui/format/history_words.h"
#include "ui/format/yield_text.h"
#include "ui/models/history_model.h"
#include "ui/reports/reports.h"

#include <QAbstractItemModelTester>
#include <QFont>
#include <QRegularExpression>
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

/// Inspections `newest`, ..., 1, all keys of which are known.
std::shared_ptr<const HistoryList> listDownFrom(qint64 newest)
{
    auto list = std::make_shared<HistoryList>();
    for (qint64 number = newest; number > 0; --number)
        list->keys.append(u"g%1"_s.arg(number));
    list->rows = newest;
    return list;
}

/// As many of which only pages are known.
std::shared_ptr<const HistoryList> walkedList(qint64 rows)
{
    auto list = std::make_shared<HistoryList>();
    list->walked = true;
    list->rows = rows;
    return list;
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
        model.restart(listDownFrom(500), page(500, 200));
        QCOMPARE(model.rowCount(), 500);
        model.setPage(1, page(300, 200));
        model.setPage(9, page(300, 200)); // of an older, longer list
        QCOMPARE(model.rowCount(), 500);
        model.restart(listDownFrom(0), {});
        QCOMPARE(model.rowCount(), 0);
    }
    void aWalkedListGrowsAndKnowsWhatItsPagesHold()
    {
        HistoryModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.restart(walkedList(450), page(1000, 200));
        QCOMPARE(model.rowCount(), 450);
        QCOMPARE(model.key(0), u"g1000"_s);
        QCOMPARE(model.rowOf(u"g801"_s), 199);
        QVERIFY(model.key(449).isEmpty());
        model.setPage(2, page(600, 50));
        QCOMPARE(model.key(449), u"g551"_s);
        model.goOn(walkedList(1000));
        QCOMPARE(model.rowCount(), 1000);
        QSignalSpy asked(&model, &HistoryModel::pageAsked);
        model.index(460, 0).data(); // its page was the last, and is longer now
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked[0][0].toInt(), 2);
        model.goOn(walkedList(990)); // fewer were counted than another program's tallies said
        QCOMPARE(model.rowCount(), 990);
        QCOMPARE(model.rowOf(u"g1"_s), -1);
    }
    void tenMillionRowsAreAsFarAsOne()
    {
        HistoryModel model;
        model.restart(walkedList(10'000'000), page(10'000'000, 200));
        QCOMPARE(model.rowCount(), 10'000'000);
        QSignalSpy asked(&model, &HistoryModel::pageAsked);
        model.index(9'999'999, 0).data();
        QCOMPARE(asked[0][0].toInt(), 49'999);
        model.setPage(49'999, page(200, 200));
        QCOMPARE(model.key(9'999'999), u"g1"_s);
        QCOMPARE(model.pagesHeld(), 2);
    }
    void asksForThePageThatIsLookedAtOnce()
    {
        HistoryModel model;
        QSignalSpy asked(&model, &HistoryModel::pageAsked);
        model.restart(listDownFrom(100'000), page(100'000, 200));
        QVERIFY(model.index(199, 0).data().isValid());
        QCOMPARE(asked.size(), 0);
        QVERIFY(!model.index(99'999, 0).data().isValid()); // the end, at once
        QVERIFY(!model.index(99'900, 3).data().isValid());
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked[0][0].toInt(), 499);
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
        model.restart(listDownFrom(100'000), page(100'000, 200));
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
        model.restart(listDownFrom(1000), {});
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
        model.restart(listDownFrom(3), page(3, 2));
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
    void aSuspectSqueezeIsNamedAsOne()
    {
        HistoryModel model;
        HistoryEntry suspect = inspection(1);
        suspect.validity = ValidityVerdict::Suspect;
        HistoryEntry clean = inspection(3);
        clean.validity = ValidityVerdict::Valid;
        model.restart(listDownFrom(3), {clean, suspect, inspection(5)});
        const auto cell = [&](int row, HistoryColumn column) {
            return HistoryDelegate::text(model.index(row, int(column)));
        };
        QCOMPARE(cell(0, HistoryColumn::Outcome), u"as expected"_s);
        QCOMPARE(cell(1, HistoryColumn::Outcome), u"suspect: as expected"_s);
        QVERIFY(model.index(1, int(HistoryColumn::Outcome)).data(HistoryModel::SuspectRole).toBool());
        QCOMPARE(cell(0, HistoryColumn::Validity), u"valid"_s);
        QCOMPARE(cell(1, HistoryColumn::Validity), u"suspect"_s);
        QCOMPARE(cell(2, HistoryColumn::Validity), u"not recorded"_s); // from before
        QCOMPARE(cell(2, HistoryColumn::LibraryVersion), QString(QChar(0x2013)));
    }
    void theDetailsTellWhatWasInForce()
    {
        SqueezeDetails details;
        details.entry = inspection(1);
        details.entry.validity = ValidityVerdict::Suspect;
        details.entry.checksFailed = {u"calibration"_s};
        details.entry.heldTo = {0.01, 0.001, 0.02, 0.95, true};
        details.entry.libraryVersion = 7;
        details.entry.forceCalibration = u"taken 2026-03-01 against Weights M1, holds until 2027-03-01"_s;
        details.entry.positionCalibration = u""_s;
        details.samples = 500;
        const auto told = [&details] {
            QStringList lines;
            for (const Fact& fact : HistoryWords::facts(details))
                lines << fact.name + u": "_s + fact.text;
            return lines.join(u'\n');
        };
        const QString then = told();
        for (const QString& fact :
             {u"Validity: suspect: "_s + checkName(u"calibration"_s), u"stranger accept 2\u00A0%"_s,
              u"95\u00A0% confidence"_s, u"robust"_s, u"version 7 of the library"_s,
              u"Calibration, Force: Taken 2026-03-01 against Weights M1"_s,
              u"Calibration, Position: Not calibrated"_s})
            QVERIFY2(then.contains(fact), qPrintable(fact + u" in "_s + then));
        details.entry = inspection(1); // from before
        details.entry.heldTo = {0.01, 0.001, {}, {}, {}};
        const QString before = told();
        for (const QString& fact :
             {u"Validity: not recorded"_s, u"wrong type 0.1\u00A0%, stranger-accept"_s,
              u"version of the library not recorded"_s, u"Calibration, Force: Not recorded."_s})
            QVERIFY2(before.contains(fact), qPrintable(fact + u" in "_s + before));
    }
    void theSummaryTellsTheYieldOfInspect()
    {
        HistoryCounts history;
        InspectionCounts inspected;
        history.inspections = inspected.total = 60;
        history.asExpected = inspected.asExpected = 40;
        history.unknown = inspected.unknown = 2;
        history.inconclusive = inspected.inconclusive = 8;
        history.notValid = inspected.invalid = 10;
        QVERIFY(HistoryWords::summary(history).contains(yieldText(inspected)));
        HistoryReport report;
        report.counts = history;
        QVERIFY(historyReportHtml(report).contains(yieldText(inspected).toHtmlEscaped()));
    }
    void theReportTellsTheCalibrationOfThen()
    {
        HistoryReport report;
        report.counts.inspections = 3;
        report.counts.suspect = 1;
        report.inForce.serials = {{u"0001"_s, 3}};
        auto& gripper = report.inForce.calibrations[u"0001"_s];
        gripper.force[u"taken 2026-03-01 against Weights M1, holds until 2027-03-01"_s] = 2;
        gripper.force[std::nullopt] = 1;
        gripper.position[u""_s] = 3;
        report.inForce.rates = {{{0.01, 0.001, 0.02, {}, false}, 3}};
        report.inForce.firstVersion = 4;
        report.inForce.lastVersion = 6;
        report.inForce.programs = {{u"0.1.0"_s, 3}};
        HistoryEntry suspect = inspection(1);
        suspect.validity = ValidityVerdict::Suspect;
        report.rows = {suspect};
        report.total = 1;
        const QString html = historyReportHtml(report).replace(QChar::Nbsp, u' ');
        for (const QString& words :
             {u"against Weights M1, holds until 2027-03-01 (2)"_s, u"not recorded (1)"_s,
              u"stranger accept 2 %"_s, u"versions 4 to 6 of the library"_s, u"0.1.0 (3)"_s,
              u"suspect: as expected"_s})
            QVERIFY2(html.contains(words), qPrintable(words + u" in "_s + html));
        QVERIFY(!html.contains(u"in force now"_s));
    }
    void theCountsOfAReportAddUp()
    {
        HistoryReport report;
        report.counts = {.inspections = 21,
                         .enrolled = 4,
                         .asExpected = 8,
                         .otherType = 2,
                         .unknown = 3,
                         .inconclusive = 1,
                         .notValid = 2,
                         .suspect = 5,
                         .voided = 5};
        const QString html = historyReportHtml(report);
        const auto numberOf = [&html](const QString& name) {
            static const QString row = u"<tr><td>%1</td><td>&nbsp;&nbsp;&nbsp;</td><td>([0-9]+)"_s;
            return QRegularExpression(row.arg(name)).match(html).captured(1).toInt();
        };
        int sum = 0;
        for (const QString& name :
             {u"As expected"_s, u"Other type"_s, u"Unknown"_s, u"Inconclusive, not judged"_s,
              u"Measurement not valid, not judged"_s, u"Voided, counted in none of these"_s})
            sum += numberOf(name);
        QCOMPARE(sum, numberOf(u"Inspected"_s));
        QCOMPARE(sum, 21);
        report.counts.voided = 0;
        QVERIFY(!historyReportHtml(report).contains(u"Voided"_s));
    }
    void aReportSaysWhichPartsAndBatchesWhereThereAreAny()
    {
        HistoryReport report;
        report.rows = {inspection(2), inspection(1)};
        report.total = 2;
        QVERIFY(!historyReportHtml(report).contains(u"Part number"_s));
        QVERIFY(!historyReportHtml(report).contains(u"Batch"_s));
        report.rows[1].partNumber = u"SN-0815 & <b>"_s;
        QVERIFY(historyReportHtml(report).contains(u"Part number"_s));
        QVERIFY(historyReportHtml(report).contains(u"SN-0815 &amp; &lt;b&gt;"_s));
        QVERIFY(!historyReportHtml(report).contains(u"Batch"_s));
        report.rows[0].batch = u"4711"_s;
        report.rows[0].voided = u"squeezed twice"_s;
        const QString html = historyReportHtml(report);
        QVERIFY(html.contains(u"Batch"_s) && html.contains(u"4711"_s));
        QVERIFY(html.contains(u"voided: other type (squeezed twice)"_s));
        // As many cells in each row as there are titles.
        const QString table = html.mid(html.lastIndexOf(u"<table"_s));
        QCOMPARE(table.count(u"<td"_s), 2 * table.count(u"<th "_s));
    }
    void everyReportHasItsNumberFromTheAuditTrail()
    {
        const test::LibraryFolder folder;
        const auto library = folder.open();
        test::valueOf(library->addInspection(test::anInspection()));
        HistoryReport first = test::valueOf(readHistoryReport(*library, {}));
        QVERIFY(!historyReportHtml(first).contains(u"no. "_s));
        test::valueOf(numberHistoryReport(*library, first, u"first.pdf"_s));
        HistoryReport second = first;
        test::valueOf(numberHistoryReport(*library, second, u"second.pdf"_s));
        QVERIFY(second.number > first.number);
        const auto entries =
            test::valueOf(library->auditTrail().entries({.text = {}, .action = u"export.made"_s}));
        QCOMPARE(entries[0].number, second.number);
        QCOMPARE(entries[0].subject, u"second.pdf"_s);
        QCOMPARE(entries[1].number, first.number);
        QVERIFY(historyReportHtml(second).contains(u"Report of squeezes no. %1<"_s.arg(second.number)));
    }
    void aPartOfNoTypeHasNoPosterior()
    {
        HistoryModel model;
        HistoryEntry stranger = inspection(1);
        stranger.verdict = VerdictKind::Unknown;
        model.restart(listDownFrom(1), {stranger});
        QVERIFY(!model.index(0, int(HistoryColumn::Posterior)).data(Qt::EditRole).isValid());
    }
    void whatWasVoidedIsStruck()
    {
        HistoryModel model;
        HistoryEntry voided = inspection(2);
        voided.voided = u"squeezed twice"_s;
        model.restart(listDownFrom(2), {voided, inspection(1)});
        const auto struck = [&](int row) {
            return model.index(row, int(HistoryColumn::Type)).data(Qt::FontRole).value<QFont>().strikeOut();
        };
        QVERIFY(struck(0));
        QVERIFY(!struck(1));
        QCOMPARE(HistoryDelegate::text(model.index(0, int(HistoryColumn::Voided))), u"squeezed twice"_s);
        QCOMPARE(HistoryWords::outcome(voided), u"voided: other type"_s);
        QCOMPARE(HistoryWords::outcome(inspection(1)), u"as expected"_s);
        QVERIFY(HistoryWords::summary({.inspections = 2, .voided = 1}).contains(u"1 voided"_s));
    }
    void nothingExpectedIsNowhereAsExpected()
    {
        HistoryEntry entry = inspection(7);
        entry.expectedType.clear();
        HistoryModel model;
        model.restart(listDownFrom(1), {entry});
        QCOMPARE(HistoryDelegate::text(model.index(0, int(HistoryColumn::Outcome))), u"known type"_s);
        QCOMPARE(HistoryWords::outcome(entry), u"known type"_s);
        QVERIFY(toCsv({entry}).contains(",known_type,type,A,"));
        QVERIFY(!toCsv({entry}).contains("as_expected"));
        QCOMPARE(toJson(entry)[u"outcome"_s].toString(), u"known_type"_s);

        HistoryCounts counts;
        counts.inspections = 5;
        counts.asExpected = counts.knownType = 3;
        counts.unknown = 1;
        counts.unasked = 4;
        QVERIFY(HistoryWords::summary(counts).contains(u"of a known type"_s));
        QVERIFY(!HistoryWords::summary(counts).contains(u"as expected"_s));
        HistoryReport report;
        report.counts = counts;
        QVERIFY(!historyReportHtml(report).contains(u"as expected"_s, Qt::CaseInsensitive));
        QVERIFY(historyReportHtml(report).contains(u"Known type, none expected"_s));
        // Of both kinds each is told as what it is.
        counts.asExpected = 4;
        counts.inspections = 6;
        report.counts = counts;
        const QString both = historyReportHtml(report);
        QVERIFY(both.contains(u"As expected"_s) && both.contains(u"Known type, none expected"_s));
        QVERIFY(both.contains(u"as expected or of a known type"_s));
        QCOMPARE(HistoryWords::filter({.outcome = InspectionOutcome::AsExpected}).front().text,
                 u"as expected or known type"_s);
    }
    void theDetailsTellTheClockOfThen()
    {
        SqueezeDetails details;
        details.entry = inspection(1);
        details.entry.station = u"bench 3"_s;
        details.entry.utcOffset_s = -12'600;
        const auto textOf = [&details](const QString& name) {
            for (const Fact& fact : HistoryWords::facts(details))
                if (fact.name == name)
                    return fact.text;
            return QString();
        };
        QCOMPARE(textOf(u"Time"_s), u"2020-03-01 08:30:01 -03:30"_s);
        QCOMPARE(textOf(u"Station"_s), u"bench 3"_s);
        QCOMPARE(textOf(u"Clock"_s), QString());
        details.entry.clockSetBack =
            ClockStep{u"bench 3"_s, details.entry.time.addDays(1), details.entry.time.addDays(-1)};
        QCOMPARE(textOf(u"Clock"_s), u"The station's clock was set back from 2020-03-02 08:30:01 -03:30 to "
                                     "2020-02-29 08:30:01 -03:30: this time may be wrong."_s);
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
        // What came later stands behind what others already read.
        QCOMPARE(header.mid(header.indexOf(u"batch"_s) + 1), QStringList({u"part_number"_s,
                                                                          u"voided"_s,
                                                                          u"validity"_s,
                                                                          u"checks_failed"_s,
                                                                          u"false_reject_rate"_s,
                                                                          u"wrong_type_rate"_s,
                                                                          u"stranger_accept_rate"_s,
                                                                          u"confidence"_s,
                                                                          u"robust"_s,
                                                                          u"library_version"_s,
                                                                          u"force_calibration"_s,
                                                                          u"force_calibration_id"_s,
                                                                          u"position_calibration"_s,
                                                                          u"position_calibration_id"_s,
                                                                          u"station"_s,
                                                                          u"time_local"_s,
                                                                          u"clock_set_back"_s,
                                                                          u"conformity"_s,
                                                                          u"conformity_risk"_s,
                                                                          u"number_there"_s}));
    }
};

GRIPSCOPE_TEST(HistoryModelTest)
#include "history_model_test.moc"
