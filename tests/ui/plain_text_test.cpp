// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a gripper, a file or a person calls something: it is shown and never obeyed. Every page and dialog
// on a library full of such names; the kernel says whether the file that they name was opened.
#include "tests/support/patience.h"
#include "tests/support/test_registry.h"
#include "tests/ui/hostile_names.h"
#include "ui/context/workbench.h"
#include "ui/help/help_windows.h"
#include "ui/pages/page.h"
#include "ui/reports/pdf_document.h"
#include "ui/reports/reports.h"
#include "ui/shell/main_window.h"
#include "ui/theme/theme.h"
#include "ui/widgets/plain_text.h"
#include "ui/windows/dialog.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QToolTip>

using namespace gripscope;
using namespace gripscope::test;

namespace {

QLabel* shownTip()
{
    for (QWidget* top : QApplication::topLevelWidgets())
        if (top->inherits("QTipLabel"))
            return qobject_cast<QLabel*>(top);
    return nullptr;
}

/// Shows `text` as a tooltip and gives it time to lay itself out.
bool tipIsPlain(const QString& text)
{
    QToolTip::showText(QPoint(10, 10), text);
    const QLabel* tip = shownTip();
    const bool plain = tip && tip->textFormat() == Qt::PlainText;
    QToolTip::hideText();
    return plain;
}

/// What of `top` reads a text as markup that is not the program's own.
QStringList markup(QWidget& top)
{
    QStringList found;
    for (const QLabel* label : top.findChildren<QLabel*>())
        if (label->textFormat() == Qt::AutoText ||
            (label->textFormat() == Qt::RichText && label->text().contains(QStringLiteral("<img"))))
            found << label->objectName() + QStringLiteral(": ") + label->text().left(60);
    for (const QWidget* widget : top.findChildren<QWidget*>())
        if (widget->toolTip().contains(u'<') && !tipIsPlain(widget->toolTip().left(500)))
            found << QStringLiteral("tip of ") + widget->objectName();
    for (const QAbstractItemView* view : top.findChildren<QAbstractItemView*>()) {
        if (!view->model() || !view->isVisible())
            continue;
        for (int row = 0; row < std::min(view->model()->rowCount(view->rootIndex()), 20); ++row)
            for (int column = 0; column < view->model()->columnCount(view->rootIndex()); ++column) {
                const QString tip =
                    view->model()->index(row, column, view->rootIndex()).data(Qt::ToolTipRole).toString();
                if (tip.contains(u'<') && !tipIsPlain(tip.left(500)))
                    found << QStringLiteral("tip of a cell of ") + view->objectName();
            }
    }
    return found;
}

} // namespace

class PlainTextTest : public QObject {
    Q_OBJECT
private slots:
    void theBaitIsTakenWhereTextIsMarkup()
    {
        const BaitFile bait; // else a test that finds nothing proves nothing
        QVERIFY(!bait.wasOpened());
        QLabel label;
        label.setTextFormat(Qt::RichText);
        label.setText(hostileNames(bait).front());
        static_cast<void>(label.sizeHint());
        QVERIFY(bait.wasOpened());
    }
    void aLabelOfQtsOwnIsPlain()
    {
        keepTextPlain();
        keepTextPlain(); // once is enough
        const BaitFile bait;
        const QString name = hostileNames(bait).front();
        QMessageBox box(QMessageBox::Question, QStringLiteral("?"), name);
        box.setInformativeText(name);
        box.show();
        QTest::qWait(20);
        QVERIFY(tipIsPlain(name));
        for (const QLabel* label : box.findChildren<QLabel*>())
            QCOMPARE(label->textFormat(), Qt::PlainText);
        QVERIFY(!bait.wasOpened());
    }
    void everyPageAndDialogShowsNamesAsTheyAre()
    {
        const BaitFile bait;
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("names.gripscope"));
        const QStringList names = hostileNames(bait);
        fillWithHostileNames(file, names);
        Theme::instance().apply(ThemeKind::Light);
        Workbench bench(file);
        bench.setOperatorName(names.front());
        MainWindow window(bench);
        window.resize(1024, 640);
        window.show();
        bench.connectTo(QStringLiteral("virtual:?object=A&seed=5"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.connection().state(), ConnectSession::State::Connected,
                                  test::longEnough_ms);
        QTRY_COMPARE_WITH_TIMEOUT(bench.inspection().state(), InspectSession::State::Ready,
                                  test::longEnough_ms);
        bench.messages().report(names.front() + names[2]);
        const auto look = [&](QWidget& top, const QString& where) {
            QTest::qWait(200); // for what is asked of the library
            const QStringList found = markup(top);
            QVERIFY2(found.isEmpty(), qPrintable(where + QStringLiteral(": ") + found.join(u'\n')));
            QVERIFY2(!bait.wasOpened(), qPrintable(where));
        };
        for (Page* page : window.pages()) {
            window.showPage(page->id());
            look(window, page->id());
        }
        for (const DialogRow& row : dialogTable()) { // every class of dialogs there is
            const std::unique_ptr<QDialog> dialog(row.make(bench, &window));
            dialog->show();
            look(*dialog, QLatin1String(row.name));
        }
    }
    void theSearchOfTheManualTakesAnyWords()
    {
        const BaitFile bait;
        ManualWindow manual;
        manual.show();
        for (const QString& name : hostileNames(bait)) {
            manual.findChild<QLineEdit*>(QStringLiteral("manualWords"))->setText(name);
            QTest::qWait(10);
            QVERIFY(!bait.wasOpened());
        }
    }
    void aReportLoadsNothing()
    {
        const BaitFile bait;
        QTemporaryDir folder;
        QString rows;
        for (const QString& name : hostileNames(bait))
            rows += pdfRow(name, name);
        // Even where somebody forgot to escape.
        const QString html =
            QStringLiteral("<table>") + rows + QStringLiteral("</table>") + hostileNames(bait).front();
        QVERIFY(
            writePdf(hostileNames(bait).front(), html, {}, folder.filePath(QStringLiteral("report.pdf"))));
        QVERIFY(!bait.wasOpened());
    }
    void aCertificateEscapesEveryField()
    {
        const QString name = QStringLiteral("<i>x</i>");
        CalibrationRecord record;
        record.id = record.gripperName = record.gripperSerial = record.unit = record.operatorName =
            record.note = name;
        record.reference.name = record.reference.certificate = name;
        for (int i = 0; i < 6; ++i)
            record.points.push_back({10.0 * i, 10.1 * i + 0.01 * (i % 2)});
        record.degree = 1;
        const Expected<CalibrationEvaluation> evaluation = evaluateCalibration(record);
        QVERIFY(evaluation);
        const QString html = certificateHtml(record, *evaluation);
        QVERIFY(html.contains(QStringLiteral("&lt;i&gt;x")));
        QVERIFY2(!html.contains(QStringLiteral("<i>")), qPrintable(html));
    }
    void anAmpersandAndAStarAreShown()
    {
        QCOMPARE(withoutKeys(QStringLiteral("a & b")), QStringLiteral("a && b"));
        QCOMPARE(titleText(QStringLiteral("x[*]\x1b")), QStringLiteral("x[*][*]\\x1b"));
    }
};

GRIPSCOPE_TEST(PlainTextTest)
#include "plain_text_test.moc"
