// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/inspector/device_inspector.h"
#include "ui/inspector/inspector_tabs.h"

#include <QComboBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>

using namespace gripscope;
using namespace Qt::StringLiterals;
using gripscope::test::WindowFixture;

namespace {

QString cell(const QTableWidget& table, const QString& name, int column)
{
    for (int row = 0; row < table.rowCount(); ++row)
        if (table.item(row, 0)->text() == name)
            return table.item(row, column)->text();
    return u"no such row"_s;
}
} // namespace

class DeviceInspectorTest : public QObject {
    Q_OBJECT
private slots:
    void aKeyOpensItOnce()
    {
        WindowFixture f(false);
        f.window->activateWindow();
        QTest::keyClick(f.window.get(), Qt::Key_F9);
        QTRY_COMPARE(f.window->findChildren<DeviceInspector*>().size(), 1);
        QCOMPARE(DeviceInspector::open(*f.bench, f.window.get()), f.window->findChild<DeviceInspector*>());
    }

    void saysWhatTheGripperIs()
    {
        WindowFixture f(false, u"virtual:?seed=7"_s);
        DeviceInspector* inspector = DeviceInspector::open(*f.bench, f.window.get());
        auto* identity = inspector->findChild<QTableWidget*>(u"identity"_s);
        QTRY_COMPARE_WITH_TIMEOUT(cell(*identity, u"Serial number"_s, 1), u"VG-7"_s,
                                  gripscope::test::longEnough_ms);
        QCOMPARE(cell(*identity, u"Protocol"_s, 1), u"1.1"_s);
        auto* descriptor = inspector->findChild<QTableWidget*>(u"descriptor"_s);
        QCOMPARE(descriptor->item(0, 1)->text(), u"Usage page 0xff00 (vendor-defined)"_s);
    }

    void showsTheLastReportsLiveAndFrozen()
    {
        WindowFixture f(false);
        DeviceInspector* inspector = DeviceInspector::open(*f.bench, f.window.get());
        const ReportTableModel& model = inspector->reports().model();
        QTRY_VERIFY_WITH_TIMEOUT(model.rowCount() == int(ReportLog::capacity),
                                 gripscope::test::longEnough_ms);
        QCOMPARE(model.index(0, ReportTableModel::Report).data().toString(), u"Stream"_s);
        auto* freeze = inspector->findChild<QPushButton*>(u"freezeReports"_s);
        freeze->setChecked(true);
        const std::uint64_t newest = model.at(0).number;
        QTest::qWait(600); // three refreshes
        QCOMPARE(model.at(0).number, newest);
        freeze->setChecked(false);
        QTRY_VERIFY_WITH_TIMEOUT(model.at(0).number > newest, gripscope::test::longEnough_ms);
        // A stop, and the answer to it, among the stream; the filter finds them.
        f.bench->connection().stop();
        auto* kinds = inspector->reports().findChild<QComboBox*>();
        kinds->setCurrentIndex(static_cast<int>(ReportTableModel::Kind::Commands));
        const auto stopped = [&] {
            return model.rowCount() > 0 &&
                   model.index(0, ReportTableModel::Report).data().toString() == u"Stop"_s;
        };
        QTRY_VERIFY_WITH_TIMEOUT(stopped() || (f.bench->connection().stop(), false),
                                 gripscope::test::longEnough_ms);
        QVERIFY(model.asText().contains(u"\tStop\t22 11 "_s));
    }

    void countsSinceSomeoneLooked()
    {
        WindowFixture f(false);
        DeviceInspector* inspector = DeviceInspector::open(*f.bench, f.window.get());
        auto* counters = inspector->findChild<QTableWidget*>(u"counters"_s);
        const auto samples = [&](int column) {
            return cell(*counters, u"Samples"_s, column).remove(QRegularExpression(u"[^0-9]"_s)).toLongLong();
        };
        QTRY_VERIFY_WITH_TIMEOUT(samples(1) > 2000, gripscope::test::longEnough_ms);
        f.click(inspector->findChild<QPushButton*>(u"countFromHere"_s));
        QVERIFY(samples(2) < samples(1));
    }

    void testsTheGripperWithoutMovingIt()
    {
        WindowFixture f(false, u"virtual:?fault=duplicate:0.05"_s);
        DeviceInspector* inspector = DeviceInspector::open(*f.bench, f.window.get());
        inspector->selfTest().start();
        QTRY_VERIFY_WITH_TIMEOUT(inspector->selfTest().test().state() == SelfTest::State::Done,
                                 gripscope::test::longEnough_ms);
        auto* lines = inspector->findChild<QTableWidget*>(u"selfTestLines"_s);
        QTRY_COMPARE(lines->rowCount(), 8);
        QVERIFY(cell(*lines, u"Nothing lost"_s, 1).contains(u"twice"_s));
        QVERIFY(cell(*lines, u"Nothing lost"_s, 3).contains(u"cable"_s));
        QVERIFY(cell(*lines, u"Stop"_s, 1).startsWith(u"answered"_s));
        QVERIFY(!f.bench->connection().armed());
    }
};

GRIPSCOPE_TEST(DeviceInspectorTest)
#include "device_inspector_test.moc"
