// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/models/estimate_table_model.h"
#include "ui/theme/theme.h"

#include <QComboBox>
#include <QListWidget>
#include <QMenu>
#include <QTableWidget>
#include <QTest>
#include <QTreeWidget>

#include <algorithm>
#include <memory>

using namespace Qt::StringLiterals;
using namespace gripscope;

namespace {

QImage pictureOf(QWidget& widget)
{
    return widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

/// The most that any place of the two pictures differs by, as a ratio of contrast.
double strongestDifference(const QImage& one, const QImage& other)
{
    double most = 1;
    for (int y = 0; y < std::min(one.height(), other.height()); ++y)
        for (int x = 0; x < std::min(one.width(), other.width()); ++x)
            most = std::max(most, Theme::contrastRatio(one.pixelColor(x, y), other.pixelColor(x, y)));
    return most;
}

/// A view with two rows without words, so that the ground is what differs.
std::unique_ptr<QAbstractItemView> viewOf(const QString& kind)
{
    if (kind == u"list"_s) {
        auto list = std::make_unique<QListWidget>();
        list->addItems({u" "_s, u" "_s});
        return list;
    }
    if (kind == u"tree"_s) {
        auto tree = std::make_unique<QTreeWidget>();
        tree->addTopLevelItems({new QTreeWidgetItem({u" "_s}), new QTreeWidgetItem({u" "_s})});
        return tree;
    }
    auto table = std::make_unique<QTableWidget>(2, 2);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    if (kind == u"estimates"_s)
        table->setItemDelegate(new EstimateDelegate(table.get()));
    return table;
}

} // namespace

/// What is chosen in a list, a table or a menu is seen, in every theme.
class SelectionTest : public QObject {
    Q_OBJECT

    /// A tint is enough beside words of the same colour (the cursor's frame comes with it); who needs high
    /// contrast gets an edge of it (WCAG 2.1, 1.4.11).
    static double least(ThemeKind theme) { return theme == ThemeKind::HighContrast ? 3 : 1.1; }

private slots:
    void cleanup() { Theme::instance().apply(ThemeKind::Light); }

    void aRow_data()
    {
        QTest::addColumn<ThemeKind>("theme");
        QTest::addColumn<QString>("kind");
        for (const ThemeKind theme : {ThemeKind::Light, ThemeKind::Dark, ThemeKind::HighContrast})
            for (const char* kind : {"table", "list", "tree", "estimates"})
                QTest::addRow("%s %d", kind, int(theme)) << theme << QString::fromLatin1(kind);
    }
    void aRow()
    {
        QFETCH(ThemeKind, theme);
        QFETCH(QString, kind);
        Theme::instance().apply(theme);
        const std::unique_ptr<QAbstractItemView> view = viewOf(kind);
        view->resize(300, 160);
        view->show();
        const QImage without = pictureOf(*view->viewport());
        view->selectionModel()->select(view->model()->index(0, 0),
                                       QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        const double difference = strongestDifference(without, pictureOf(*view->viewport()));
        QVERIFY2(difference >= least(theme), qPrintable(QString::number(difference)));
    }

    void anEntry_data()
    {
        QTest::addColumn<ThemeKind>("theme");
        for (const ThemeKind theme : {ThemeKind::Light, ThemeKind::Dark, ThemeKind::HighContrast})
            QTest::addRow("%d", int(theme)) << theme;
    }
    void anEntry()
    {
        QFETCH(ThemeKind, theme);
        Theme::instance().apply(theme);
        QMenu menu;
        QAction* entry = menu.addAction(u"      "_s);
        menu.popup({0, 0});
        const QImage without = pictureOf(menu);
        menu.setActiveAction(entry);
        const double difference = strongestDifference(without, pictureOf(menu));
        QVERIFY2(difference >= least(theme), qPrintable(QString::number(difference)));
    }

    void aChoice_data() { anEntry_data(); }
    void aChoice()
    {
        QFETCH(ThemeKind, theme);
        Theme::instance().apply(theme);
        QComboBox box;
        box.addItems({u"      "_s, u"       "_s});
        box.show();
        box.showPopup();
        QAbstractItemView* list = box.view();
        list->selectionModel()->clear();
        const QImage without = pictureOf(*list->viewport());
        list->selectionModel()->select(list->model()->index(1, 0), QItemSelectionModel::ClearAndSelect);
        const double difference = strongestDifference(without, pictureOf(*list->viewport()));
        QVERIFY2(difference >= least(theme), qPrintable(QString::number(difference)));
        box.hidePopup();
    }
};

GRIPSCOPE_TEST(SelectionTest)
#include "selection_test.moc"
