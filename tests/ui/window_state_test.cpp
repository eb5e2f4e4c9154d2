// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/pages/page_state.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/desktop_session.h"

#include <QGuiApplication>
#include <QHeaderView>
#include <QJsonDocument>
#include <QScreen>
#include <QSplitter>
#include <QStandardItemModel>
#include <QTableView>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

/// The window opens as it was left, whatever became of its screens and its file.
class WindowStateTest : public QObject {
    Q_OBJECT
private slots:
    void theWindowOpensAsItWasClosed()
    {
        WindowFixture f(false, QString());
        f.window.reset();
        {
            const WindowHost host(*f.bench);
            host.window().show();
            host.window().resize(1100, 700);
            host.window().showPage(u"live"_s);
            WindowFixture::click(host.window().findChild<QPushButton*>(u"span-60"_s));
            host.window().showPage(u"types"_s);
            host.window().close();
        }
        const WindowHost host(*f.bench);
        QCOMPARE(host.window().size(), QSize(1100, 700)
                                           .boundedTo(QGuiApplication::primaryScreen()->availableSize())
                                           .expandedTo(host.window().minimumSize()));
        QCOMPARE(host.window().currentPage()->id(), u"types"_s);
        QVERIFY(host.window().findChild<QPushButton*>(u"span-60"_s)->isChecked());
    }

    void aWindowBeyondTheScreensComesBack_data()
    {
        QTest::addColumn<QRect>("kept");
        QTest::newRow("a screen that is gone") << QRect(9000, 200, 1024, 640);
        QTest::newRow("above") << QRect(0, -5000, 1024, 640);
        QTest::newRow("larger than the screen") << QRect(0, 0, 30000, 20000);
    }
    void aWindowBeyondTheScreensComesBack()
    {
        QFETCH(QRect, kept);
        WindowFixture f(false, QString());
        const QJsonObject state{{u"version"_s, 1},
                                {u"geometry"_s, QJsonArray{kept.x(), kept.y(), kept.width(), kept.height()}}};
        restoreWindowState(*f.window, QJsonDocument(state).toJson());
        const QRect room = QGuiApplication::primaryScreen()->availableGeometry();
        const QRect placed = f.window->geometry();
        QVERIFY(placed.left() >= room.left() && placed.top() > room.top()); // with room for a title bar
        QVERIFY(placed.left() <= std::max(room.left(), room.right() + 1 - placed.width()));
        QVERIFY(f.window->width() <= std::max(room.width(), f.window->minimumWidth()));
        QVERIFY(f.window->height() <= std::max(room.height(), f.window->minimumHeight()));
    }

    void whatCannotBeReadIsAsIfItHadNotBeenKept_data()
    {
        QTest::addColumn<QByteArray>("state");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("no document") << QByteArray("\x01\x02garbage");
        QTest::newRow("another version") << QByteArray(R"({"version": 99, "page": "types"})");
        QTest::newRow("wrong kinds") << QByteArray(
            R"({"version": 1, "geometry": "wide", "page": 7, "pages": {"live": [1, 2]}})");
        QTest::newRow("no such page") << QByteArray(R"({"version": 1, "page": "cellar"})");
    }
    void whatCannotBeReadIsAsIfItHadNotBeenKept()
    {
        QFETCH(QByteArray, state);
        WindowFixture f(false, QString());
        const QRect before = f.window->geometry();
        restoreWindowState(*f.window, state);
        QCOMPARE(f.window->geometry(), before);
        QCOMPARE(f.window->currentPage()->id(), u"live"_s);
    }

    void columnsAndSplittersAreFoundAgain()
    {
        QWidget page;
        auto* splitter = new QSplitter(&page);
        splitter->setObjectName("splitter");
        auto* table = new QTableView;
        table->setObjectName("table");
        QStandardItemModel model(2, 3);
        table->setModel(&model);
        splitter->addWidget(table);
        splitter->addWidget(new QWidget);
        page.resize(800, 400);
        splitter->resize(800, 400);
        splitter->setSizes({600, 200});
        table->horizontalHeader()->resizeSection(1, 222);
        table->setSortingEnabled(true);
        table->horizontalHeader()->setSortIndicator(2, Qt::DescendingOrder);
        const QJsonObject kept = arrangementOf(page);
        const QList<int> sizes = splitter->sizes();

        splitter->setSizes({100, 700});
        table->horizontalHeader()->resizeSection(1, 50);
        table->horizontalHeader()->setSortIndicator(0, Qt::AscendingOrder);
        restoreArrangement(page, kept);
        QCOMPARE(splitter->sizes(), sizes);
        QCOMPARE(table->horizontalHeader()->sectionSize(1), 222);
        QCOMPARE(table->horizontalHeader()->sortIndicatorSection(), 2);

        // In another language columns take the width of its words.
        table->horizontalHeader()->resizeSection(1, 50);
        restoreArrangement(page, kept, false);
        QCOMPARE(table->horizontalHeader()->sectionSize(1), 50);
        // A table that has other columns by now keeps them as they are.
        model.setColumnCount(4);
        restoreArrangement(page, kept);
        QCOMPARE(table->horizontalHeader()->sectionSize(1), 50);
    }
};

GRIPSCOPE_TEST(WindowStateTest)
#include "window_state_test.moc"
