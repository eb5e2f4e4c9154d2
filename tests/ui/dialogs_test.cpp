// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/help/help_windows.h"
#include "ui/windows/dialog.h"

#include <QAbstractItemModelTester>
#include <QAbstractItemView>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

namespace {

/// Words of any length, as a person or a gripper may bring them.
class WordyDialog : public Dialog {
public:
    explicit WordyDialog(QWidget* parent) : Dialog(parent)
    {
        auto* column = new QVBoxLayout(this);
        m_words = new QLabel(this);
        m_words->setWordWrap(true);
        column->addWidget(m_words);
        resize(300, 60);
    }
    void say(const QString& words) { m_words->setText(words); }
    [[nodiscard]] bool showsAll() const
    {
        return m_words->height() >= m_words->heightForWidth(m_words->width());
    }

private:
    QLabel* m_words;
};

} // namespace

/// What every dialog does, each by its row in the table.
class DialogsTest : public QObject {
    Q_OBJECT

    static void rows()
    {
        QTest::addColumn<int>("row");
        int row = 0;
        for (const DialogRow& one : dialogTable())
            QTest::newRow(one.name) << row++;
        QVERIFY(row > 15);
    }
    [[nodiscard]] static QDialog* made(int row, const WindowFixture& f, QWidget* over)
    {
        return dialogTable()[static_cast<std::size_t>(row)].make(*f.bench, over);
    }

private slots:
    /// One that was opened from within a scrolled page took over that page's transparent background: black.
    void itsBackgroundIsThatOfThePage_data()
    {
        QTest::addColumn<ThemeKind>("theme");
        QTest::newRow("light") << ThemeKind::Light;
        QTest::newRow("dark") << ThemeKind::Dark;
        QTest::newRow("contrast") << ThemeKind::HighContrast;
    }
    void itsBackgroundIsThatOfThePage()
    {
        QFETCH(ThemeKind, theme);
        const WindowFixture f(false, {});
        Theme::instance().apply(theme); // once: all of the window is laid out anew
        auto* area = new QScrollArea(f.window.get());
        auto* scrolled = new QWidget;
        area->setWidget(scrolled);
        int row = 0;
        for (const DialogRow& one : dialogTable()) {
            const std::unique_ptr<QDialog> first(made(row, f, scrolled));
            const std::unique_ptr<QDialog> second(made(row++, f, first.get()));
            for (QDialog* dialog : {first.get(), second.get()}) {
                dialog->setAttribute(Qt::WA_DeleteOnClose, false);
                dialog->show();
                QCoreApplication::processEvents();
                const QImage picture = dialog->grab().toImage();
                QVERIFY2(picture.pixelColor(1, picture.height() - 2) == Theme::instance().tokens().page,
                         one.name);
            }
        }
        Theme::instance().apply(ThemeKind::Light);
    }

    void itsTablesKeepTheRulesOfModels_data() { rows(); }
    void itsTablesKeepTheRulesOfModels()
    {
        QFETCH(int, row);
        const WindowFixture f;
        const std::unique_ptr<QDialog> dialog(made(row, f, f.window.get()));
        dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        std::vector<std::unique_ptr<QAbstractItemModelTester>> testers; // while they are filled, too
        if (!qobject_cast<QFileDialog*>(dialog.get()))                  // Qt's own
            for (const QAbstractItemView* view : dialog->findChildren<QAbstractItemView*>())
                if (view->model())
                    testers.push_back(std::make_unique<QAbstractItemModelTester>(
                        view->model(), QAbstractItemModelTester::FailureReportingMode::QtTest));
        dialog->show();
        QTest::qWait(300); // what it asks the library or the gripper for
        testers.clear();
    }

    void helpIsAtItsOwnPage_data() { rows(); }
    void helpIsAtItsOwnPage()
    {
        QFETCH(int, row);
        const WindowFixture f(false, {});
        QDialog* dialog = made(row, f, f.window.get());
        const auto* ours = qobject_cast<Dialog*>(dialog);
        const QString page = ours ? ours->manualPage() : QString();
        if (ours && ours->conduct() == Dialog::Conduct::Reads) {
            delete dialog;
            return; // it is the help itself, or is read beside it
        }
        QVERIFY2(page.isEmpty() || QFile::exists(manualPath(page + u".md"_s)), qPrintable(page));
        dialog->open();
        QVERIFY(QTest::qWaitForWindowExposed(dialog));
        QTest::keyClick(dialog, Qt::Key_F1); // to it, whichever window the platform has made active
        const auto* manual = f.window->findChild<ManualWindow*>();
        QVERIFY(manual && manual->isVisible());
        QCOMPARE(manual->browser()->page(),
                 manualPageFor(page.isEmpty() ? f.window->currentPage()->id() : page));
    }

    void itGrowsWithItsWords()
    {
        WordyDialog dialog(nullptr);
        dialog.say(u"Short."_s);
        dialog.open();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        dialog.say(u"Words that need some lines. "_s.repeated(20));
        QTRY_VERIFY(dialog.showsAll());
        dialog.say(u"Words without an end. "_s.repeated(2000));
        QTest::qWait(50);
        QVERIFY(dialog.height() <= 640); // the least screen
    }

    /// A field's caption takes an ampersand for the mark of a key.
    void nothingIsEatenFromACaption_data() { rows(); }
    void nothingIsEatenFromACaption()
    {
        QFETCH(int, row);
        const WindowFixture f(false, {});
        const std::unique_ptr<QDialog> dialog(made(row, f, f.window.get()));
        dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        if (qobject_cast<QFileDialog*>(dialog.get())) // Qt's own, with keys that are meant
            return;
        for (const QLabel* label : dialog->findChildren<QLabel*>())
            if (label->buddy())
                QVERIFY2(!QString(label->text()).remove(u"&&"_s).contains(u'&'), qPrintable(label->text()));
    }
};

GRIPSCOPE_TEST(DialogsTest)
#include "dialogs_test.moc"
