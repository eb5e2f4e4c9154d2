// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/people_window.h"
#include "ui/people/people_dialogs.h"

#include <QAbstractItemModelTester>
#include <QFile>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::PeopleWindow;

namespace {

std::vector<AuditEntry> auditPage(qint64 newest, int count)
{
    std::vector<AuditEntry> entries;
    for (int i = 0; i < count; ++i) {
        AuditEntry entry;
        entry.number = newest - i;
        entry.utc = u"2026-01-01T12:00:00.000Z"_s;
        entry.person = u"Sam"_s;
        entry.role = u"supervisor"_s;
        entry.action = u"type.approve"_s;
        entry.subject = u"Cola, \"330 ml\""_s;
        entry.details = u"{\"version\":7}"_s;
        entries.push_back(entry);
    }
    return entries;
}

} // namespace

/// The audit trail on the screen.
class AuditDialogTest : public QObject {
    Q_OBJECT
private slots:
    void theModelKeepsTheRulesWhileItGrows()
    {
        AuditModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QSignalSpy asked(&model, &AuditModel::pageAsked);
        model.restart(5, auditPage(5, 3));
        model.fetchMore({}); // the tester has asked for more already; the first answer is still on its way
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked.first().first().toInt(), 3);
        model.append(1, auditPage(2, 2)); // an older question
        QCOMPARE(model.rowCount(), 3);
        model.append(3, auditPage(2, 2));
        QCOMPARE(model.rowCount(), 5);
        QVERIFY(!model.canFetchMore({}));
        model.restart(9, auditPage(9, 4));
        model.append(4, {}); // there is no more
        QCOMPARE(model.total(), 4);
    }
    void anEntryIsWorded()
    {
        AuditModel model;
        model.restart(1, auditPage(1, 1));
        const auto text = [&model](AuditModel::Column column) {
            return model.index(0, static_cast<int>(column)).data().toString();
        };
        QCOMPARE(text(AuditModel::Column::Person), u"Sam (supervisor)"_s);
        QCOMPARE(text(AuditModel::Column::Action), u"Type approved"_s);
        QCOMPARE(text(AuditModel::Column::Details), u"version: 7"_s);
        QCOMPARE(text(AuditModel::Column::Time).size(), 19); // to the second
        std::vector<AuditEntry> consent = auditPage(1, 1);
        consent.front().action = u"authorised"_s;
        consent.front().subject = u"change_settings"_s;
        model.restart(1, consent);
        QCOMPARE(text(AuditModel::Column::Subject), u"Changing settings"_s);
    }
    void theCsvHasEveryFieldOfTheChain()
    {
        const QString text = QString::fromUtf8(toCsv(auditPage(3, 1)));
        QVERIFY(text.startsWith(u"number,time_utc,station,person,role,action,subject,reason,details,"
                                "previous_hash,hash\n3,2026-01-01T12:00:00.000Z,,Sam,supervisor,type.approve,"
                                "\"Cola, \"\"330 ml\"\"\",,\"{\"\"version\"\":7}\",,\n"_s));
    }
    void itIsListedFilteredVerifiedAndExported()
    {
        PeopleWindow f; // three entries: the examples, two people; and one consent
        auto* dialog = new AuditDialog(*f.bench, f.window.get());
        dialog->open();
        auto* model = f.find<QTableView>("auditTable")->model();
        QTRY_COMPARE_WITH_TIMEOUT(model->rowCount(), 4, gripscope::test::longEnough_ms);
        f.find<QComboBox>("auditAction")->setCurrentIndex(3); // people
        QTRY_COMPARE_WITH_TIMEOUT(model->rowCount(), 2, gripscope::test::longEnough_ms);
        QTest::keyClicks(f.find<QLineEdit>("auditText"), u"olli"_s);
        QTRY_COMPARE_WITH_TIMEOUT(model->rowCount(), 1, gripscope::test::longEnough_ms);
        f.click(f.find<QPushButton>("auditVerify"));
        auto* result = f.find<QLabel>("auditResult");
        QTRY_VERIFY_WITH_TIMEOUT(result->text().contains(u" rows are as they were written"_s),
                                 gripscope::test::longEnough_ms);
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"trail.csv"_s);
        dialog->exportTo(file);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file), gripscope::test::longEnough_ms);
        QFile csv(file);
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = csv.readAll().split('\n');
        QCOMPARE(lines.size(), 6); // a header, all four whatever is filtered, and the end
        QVERIFY(lines[1].startsWith("1,") && lines[4].startsWith("4,"));
    }
};

GRIPSCOPE_TEST(AuditDialogTest)
#include "audit_dialog_test.moc"
