// SPDX-License-Identifier: GPL-3.0-or-later
// What the walk over the pages must find, and what it must leave alone.
#include "tests/support/test_registry.h"
#include "tests/ui/layout_walk.h"
#include "ui/widgets/fitted_label.h"

#include <QListWidget>
#include <QPushButton>

#include <functional>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

namespace {

/// Paints as a chart or a delegate does.
class Painted : public QWidget {
public:
    using Paint = std::function<void(QPainter&, const QRect&)>;
    explicit Painted(Paint paint, QWidget* parent) : QWidget(parent), m_paint(std::move(paint)) {}

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.fillRect(rect(), Qt::white);
        painter.setPen(Qt::black);
        m_paint(painter, rect());
    }

private:
    Paint m_paint;
};

QString elided(const QPainter& painter, const QString& text, int room)
{
    return painter.fontMetrics().elidedText(text, Qt::ElideRight, room);
}

/// What is found in a window with one widget of 200 x 40.
template <typename Make>
QStringList foundIn(const Make& make)
{
    QWidget window;
    window.setAttribute(Qt::WA_StyledBackground);
    window.resize(300, 100);
    QWidget* widget = make(&window);
    widget->setGeometry(20, 20, 200, 40);
    window.show();
    settleLayout();
    return findingsNow(window);
}

QStringList foundPainted(const Painted::Paint& paint)
{
    return foundIn([&paint](QWidget* window) { return new Painted(paint, window); });
}

} // namespace

class PaintedAuditTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }

    void whatCanBeReadIsLeftAlone()
    {
        const QStringList found = foundPainted([](QPainter& painter, const QRect& box) {
            painter.drawText(box, Qt::AlignCenter, u"9.98 kN/m"_s);
            painter.translate(12, 30);
            painter.rotate(-90);
            painter.drawText(0, 0, u"N"_s);
        });
        QCOMPARE(found, QStringList());
    }
    void dotsOfItsOwnAreNoEnd()
    {
        const QStringList found =
            foundIn([](QWidget* window) { return new QPushButton(u"Open…"_s, window); });
        QCOMPARE(found, QStringList());
    }
    void paintedTextThatEndsInDotsIsFound()
    {
        const QStringList found = foundPainted([](QPainter& painter, const QRect& box) {
            painter.drawText(box, Qt::AlignLeft,
                             elided(painter, u"a sentence that goes on and on and on"_s, 90));
        });
        QCOMPARE(found.size(), 1);
        QVERIFY(found[0].contains(u"ends in dots"_s));
    }
    void anElidedLabelIsFound()
    {
        const QStringList found = foundIn([](QWidget* window) {
            return new ElidedLabel(u"a line that is much longer than its place, by far"_s, window);
        });
        QCOMPARE(found.size(), 1);
        QVERIFY(found[0].contains(u"is shown as"_s));
    }
    void partsThatWereLeftOutAreFoundUnlessTheyMayGo()
    {
        for (const bool may : {false, true}) {
            const QStringList found = foundIn([may](QWidget* window) {
                auto* label = new ElidedLabel({}, window);
                label->setObjectName(may ? u"statusText"_s : u"facts"_s);
                label->setParts({u"the first part"_s, u"the second part, which is longer"_s}, u" · "_s);
                return label;
            });
            QCOMPARE(found.size(), may ? 0 : 1);
        }
    }
    void aFittedLabelThatIsStillCutIsFound()
    {
        const QStringList found = foundIn([](QWidget* window) {
            auto* label = new FittedLabel(40, window);
            label->setText(u"more words than go into two hundred pixels even so"_s);
            return label;
        });
        QCOMPARE(found.size(), 1);
        QVERIFY(found[0].contains(u"ends in dots"_s));
    }
    void aCellThatIsElidedIsFound()
    {
        const QStringList found = foundIn([](QWidget* window) {
            auto* list = new QListWidget(window);
            list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
            list->setResizeMode(QListView::Adjust);
            list->setWordWrap(true);
            list->setUniformItemSizes(true);
            auto* item = new QListWidgetItem(u"a-word-that-is-longer-than-the-list-is-wide"_s, list);
            item->setSizeHint({180, 24});
            return list;
        });
        QVERIFY2(found.filter(u"ends in dots"_s).size() == 1, qPrintable(found.join(u'\n')));
    }
    void textBeyondItsWidgetIsFound()
    {
        const QStringList found = foundPainted([](QPainter& painter, const QRect&) {
            painter.drawText(120, 20, u"a sentence that begins too far right"_s);
        });
        QCOMPARE(found.size(), 1);
        QVERIFY(found[0].contains(u"is cut"_s));
    }
    void textThatIsClippedIsFound()
    {
        const QStringList found = foundPainted([](QPainter& painter, const QRect& box) {
            painter.setClipRect(0, 0, 40, 40);
            painter.drawText(box, Qt::AlignLeft, u"a whole sentence"_s);
        });
        QCOMPARE(found.size(), 1);
        QVERIFY(found[0].contains(u"is cut"_s));
    }
    void textOverAnotherIsFound()
    {
        const QStringList found = foundPainted([](QPainter& painter, const QRect& box) {
            painter.drawText(box, Qt::AlignCenter, u"0.00"_s);
            painter.drawText(box.translated(8, 0), Qt::AlignCenter, u"Time (s)"_s);
        });
        QCOMPARE(found.size(), 1);
        QVERIFY(found[0].contains(u"lies over"_s));
    }
    void paleTextIsFound()
    {
        for (const int grey : {0xC0, 0x70}) { // 1.8 and 4.9 on white
            const QStringList found = foundPainted([grey](QPainter& painter, const QRect& box) {
                painter.setPen(QColor(grey, grey, grey));
                painter.drawText(box, Qt::AlignCenter, u"pale"_s);
            });
            QCOMPARE(found.size(), grey == 0xC0 ? 1 : 0);
            QVERIFY(found.isEmpty() || found[0].contains(u"contrast 1.8"_s));
        }
    }
};

GRIPSCOPE_TEST(PaintedAuditTest)
#include "painted_audit_test.moc"
