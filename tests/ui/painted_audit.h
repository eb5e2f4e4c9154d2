// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/painted_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/narrow_choice.h"

#include <QAbstractButton>
#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QHash>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabBar>

namespace gripscope::test {

/// Where a widget is: its name and those of three around it.
[[nodiscard]] inline QString placeOf(const QWidget& widget)
{
    QStringList path;
    for (const QWidget* w = &widget; w && path.size() < 4; w = w->parentWidget())
        path.prepend(w->objectName().isEmpty() ? QString::fromLatin1(w->metaObject()->className())
                                               : w->objectName());
    return path.join(u'/');
}

/// Looks at the letters that reach the screen, whoever paints them: text that ends in dots though it goes on,
/// that is cut at the edge of its place, that lies over another text, or that is too pale on its ground.
class PaintedAudit {
public:
    static constexpr double leastContrast = 3; // of large words and signs (WCAG 2.1, 1.4.3 and 1.4.11)

    /// `picture`: of `top`, for the contrast; without one it is not asked for.
    [[nodiscard]] static QStringList of(QWidget& top, const QImage& picture = {})
    {
        PaintedAudit audit(top, picture.convertToFormat(QImage::Format_RGB32));
        audit.collect(top);
        for (const Seen& seen : audit.m_seen) {
            audit.checkEnd(seen);
            audit.checkRoom(seen);
            audit.checkContrast(seen);
        }
        audit.checkOverlaps();
        return audit.m_findings;
    }

private:
    struct Seen {
        QWidget* widget;
        PaintedText text;
        QRectF visible; ///< what of its ink is seen, in `top`
        QRectF line;    ///< likewise
    };

    PaintedAudit(QWidget& top, QImage picture) : m_top(&top), m_picture(std::move(picture))
    {
        gatherWholes();
    }

    void add(const Seen& seen, const QString& what)
    {
        m_findings << placeOf(*seen.widget) +
                          QStringLiteral(": painted \"%1\" ").arg(seen.text.text.left(60)) + what;
    }

    void collect(QWidget& widget)
    {
        const QRect open = widget.visibleRegion().boundingRect();
        if (!open.isEmpty())
            for (const PaintedText& text : textsPaintedBy(widget)) {
                const QPointF at = widget.mapTo(m_top, QPointF());
                QRectF room = open;
                if (text.clip)
                    room &= *text.clip;
                const QRectF visible = (text.ink & room).translated(at);
                if (!visible.isEmpty())
                    m_seen.push_back({&widget, text, visible, (text.line & room).translated(at)});
            }
        for (QObject* child : widget.children())
            if (auto* one = qobject_cast<QWidget*>(child); one && one->isVisible() && !one->isWindow())
                collect(*one);
    }

    /// Texts that end in dots of their own ("Open…"): what widgets and models hold, and say of themselves.
    void gatherWholes()
    {
        QList<QWidget*> widgets = m_top->findChildren<QWidget*>();
        widgets << m_top;
        for (const QWidget* widget : widgets) {
            keep(widget->accessibleName());
            keep(widget->accessibleDescription());
            if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
                keep(button->text());
            else if (const auto* field = qobject_cast<const QLineEdit*>(widget))
                keep(field->text()), keep(field->placeholderText());
            else if (const auto* label = qobject_cast<const QLabel*>(widget))
                keep(qobject_cast<const ElidedLabel*>(label) ? QString() : label->text());
            else if (const auto* box = qobject_cast<const QComboBox*>(widget))
                keep(box->currentText());
            else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget); view && view->model())
                gatherCells(*view->model());
        }
    }
    void gatherCells(const QAbstractItemModel& model)
    {
        constexpr int most = 100; // rows; more are not seen at once
        for (int column = 0; column < model.columnCount(); ++column) {
            keep(model.headerData(column, Qt::Horizontal).toString());
            for (int row = 0; row < std::min(model.rowCount(), most); ++row)
                keep(model.index(row, column).data().toString());
        }
    }
    void keep(const QString& text)
    {
        if (text.contains(dots))
            m_wholes << QString(text).remove(u'&').simplified();
    }

    void checkEnd(const Seen& seen)
    {
        const QString text = seen.text.text.simplified();
        const auto* label = qobject_cast<const ElidedLabel*>(seen.widget); // LayoutAudit looks at it
        if (label || !text.endsWith(dots) || text == QString(dots))
            return;
        const bool whole = std::any_of(m_wholes.begin(), m_wholes.end(),
                                       [&text](const QString& one) { return one.contains(text); });
        const bool narrow =
            qobject_cast<const NarrowChoice*>(seen.widget) != nullptr; // its tool tip tells all
        if (!whole && !narrow && !isToldWhole(seen) && !isNameThatIsTold(*seen.widget, text.chopped(1)))
            add(seen, QStringLiteral("ends in dots"));
    }
    /// The name of a gripper or a person, as long as its maker or the person likes.
    static bool isNameThatIsTold(const QWidget& widget, const QString& start)
    {
        const QString name = widget.objectName();
        return (name == u"deviceChip" || name == u"operatorChip") && widget.toolTip().contains(start);
    }
    /// A cell that a person fills with words of any length, and which tells them all when it is pointed at.
    static bool isToldWhole(const Seen& seen)
    {
        static const QStringList tables{QStringLiteral("inspectionList"), // names of types
                                        QStringLiteral("historyTable"),   // names of types, people, grippers
                                        QStringLiteral("heldOutTable")};  // names of types
        const auto* view = qobject_cast<const QAbstractItemView*>(seen.widget->parentWidget());
        if (!view || !tables.contains(view->objectName()))
            return false;
        const QModelIndex cell = view->indexAt(seen.text.line.center().toPoint());
        const QString start = seen.text.text.chopped(1).simplified();
        return cell.data(Qt::ToolTipRole).toString().contains(start);
    }

    /// Letters lie within their widget and what was left open of it; at the edge of what scrolls they may be
    /// on their way in.
    void checkRoom(const Seen& seen)
    {
        const auto* field = qobject_cast<const QLineEdit*>(seen.widget);
        if (field && !qobject_cast<const QAbstractSpinBox*>(field->parentWidget()))
            return; // what a person types moves along under the cursor
        constexpr double far = 1e6;
        constexpr double air = 2.5; // of soft edges, and of letters that reach out to the left ("J")
        QRectF room(seen.widget->rect());
        if (scrolls(*seen.widget, Qt::Horizontal))
            room.adjust(-far, 0, far, 0);
        if (scrolls(*seen.widget, Qt::Vertical))
            room.adjust(0, -far, 0, far);
        if (seen.text.clip)
            room &= *seen.text.clip;
        if (!room.adjusted(-air, -air, air, air).contains(seen.text.ink))
            add(seen, QStringLiteral("is cut: %1 x %2 at %3, %4 in %5 x %6 at %7, %8")
                          .arg(seen.text.ink.width(), 0, 'f', 0)
                          .arg(seen.text.ink.height(), 0, 'f', 0)
                          .arg(seen.text.ink.x(), 0, 'f', 0)
                          .arg(seen.text.ink.y(), 0, 'f', 0)
                          .arg(room.width(), 0, 'f', 0)
                          .arg(room.height(), 0, 'f', 0)
                          .arg(room.x(), 0, 'f', 0)
                          .arg(room.y(), 0, 'f', 0));
    }
    static bool scrolls(const QWidget& widget, Qt::Orientation along)
    {
        const auto* area = qobject_cast<const QAbstractScrollArea*>(widget.parentWidget());
        if (!area || area->viewport() != &widget)
            return false;
        if (const auto* header = qobject_cast<const QHeaderView*>(area)) {
            const int room = along == Qt::Horizontal ? widget.width() : widget.height();
            return header->orientation() == along && header->length() > room;
        }
        const QScrollBar* bar =
            along == Qt::Horizontal ? area->horizontalScrollBar() : area->verticalScrollBar();
        return bar->maximum() > bar->minimum();
    }

    void checkContrast(const Seen& seen)
    {
        const auto* field = qobject_cast<const QLineEdit*>(seen.widget);
        if (m_picture.isNull() || (field && field->hasSelectedText()))
            return; // what is chosen is painted twice, and the first time its colour is clipped away
        const QColor ground = groundUnder(seen.line);
        const QColor ink = Theme::mix(ground, seen.text.color, double(seen.text.color.alphaF()));
        if (const double contrast = Theme::contrastRatio(ink, ground); contrast < leastContrast)
            add(seen, QStringLiteral("%1 on %2: contrast %3")
                          .arg(ink.name(), ground.name())
                          .arg(contrast, 0, 'f', 1));
    }
    /// The colour that most of a line is of: letters cover less of it than what they stand on.
    [[nodiscard]] QColor groundUnder(const QRectF& line) const
    {
        QHash<QRgb, int> counts;
        const QRect box = line.toAlignedRect() & m_picture.rect();
        for (int y = box.top(); y <= box.bottom(); ++y)
            for (int x = box.left(); x <= box.right(); ++x)
                ++counts[m_picture.pixel(x, y)];
        QRgb most = 0;
        int count = 0;
        for (auto one = counts.cbegin(); one != counts.cend(); ++one)
            if (one.value() > count) {
                most = one.key();
                count = one.value();
            }
        return QColor(most);
    }

    void checkOverlaps()
    {
        constexpr double least = 2; // letters that touch are still read
        for (std::size_t i = 0; i < m_seen.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const QRectF common = m_seen[i].visible & m_seen[j].visible;
                if (common.width() > least && common.height() > least &&
                    m_seen[i].text.text != m_seen[j].text.text)
                    add(m_seen[i], QStringLiteral("lies over \"%1\" of %2")
                                       .arg(m_seen[j].text.text.left(60), placeOf(*m_seen[j].widget)));
            }
    }

    static constexpr QChar dots{0x2026};
    QWidget* m_top;
    QImage m_picture;
    QStringList m_wholes;
    std::vector<Seen> m_seen;
    QStringList m_findings;
};

} // namespace gripscope::test
