// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/painted_audit.h"
#include "ui/theme/theme.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/narrow_choice.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QRegularExpression>
#include <QScrollArea>
#include <QStyleOptionComboBox>
#include <QTableView>
#include <QWidget>

#include <functional>

namespace gripscope::test {

/// Looks at every visible widget below one, as it stands: words that do not fit, controls that lie over each
/// other or beyond their parent, targets too small for a finger, controls without a name. One line a finding.
class LayoutAudit {
public:
    [[nodiscard]] static QStringList of(QWidget& top)
    {
        LayoutAudit audit;
        audit.visit(top);
        return audit.m_findings;
    }

private:
    void add(const QWidget& widget, const QString& what)
    {
        m_findings << placeOf(widget) + QStringLiteral(": ") + what;
    }

    void visit(QWidget& widget)
    {
        checkText(widget);
        checkControl(widget);
        checkScrolled(widget);
        checkNumbers(widget);
        std::vector<QWidget*> children;
        for (QObject* child : widget.children())
            if (auto* one = qobject_cast<QWidget*>(child); one && one->isVisible() && !one->isWindow())
                children.push_back(one);
        checkPlaces(widget, children);
        for (QWidget* child : children)
            visit(*child);
    }

    void checkText(QWidget& widget)
    {
        if (auto* label = qobject_cast<QLabel*>(&widget))
            checkLabel(*label);
        else if (auto* button = qobject_cast<QAbstractButton*>(&widget))
            checkButton(*button);
        else if (auto* box = qobject_cast<QComboBox*>(&widget))
            checkBox(*box);
        else if (auto* header = qobject_cast<QHeaderView*>(&widget))
            checkHeader(*header);
    }
    void checkLabel(const QLabel& label)
    {
        if (label.text().isEmpty())
            return;
        if (const auto* elided = qobject_cast<const ElidedLabel*>(&label))
            return checkElided(*elided);
        const QSize hint = label.wordWrap()
                               ? QSize(label.minimumSizeHint().width(), label.heightForWidth(label.width()))
                               : label.sizeHint();
        if (hint.height() > label.height() + 1 || (!label.wordWrap() && hint.width() > label.width() + 1))
            add(label, QStringLiteral("\"%1\" needs %2 x %3, has %4 x %5")
                           .arg(label.text().left(60).simplified())
                           .arg(hint.width())
                           .arg(hint.height())
                           .arg(label.width())
                           .arg(label.height()));
    }
    /// One line that may give way has to have its room all the same, but for the few where giving way is
    /// right.
    void checkElided(const ElidedLabel& label)
    {
        static const QStringList namesOfPeople{
            // typed by a person, as long as they like; the whole is in the tip
            QStringLiteral("batchName"), QStringLiteral("draftName"), QStringLiteral("fitTitle")};
        static const QStringList partsByRank{
            // whole parts go from the end where there is no room, and are told elsewhere: the state of the
            // gripper on Live, the counts of each type in History, the recipe in Enroll, the facts in Fit
            QStringLiteral("statusText"), QStringLiteral("typesLabel"), QStringLiteral("recipeLabel"),
            QStringLiteral("factsLabel")};
        if (label.text() == label.fullText())
            return;
        const bool told = label.toolTip() == label.fullText();
        if (told && namesOfPeople.contains(label.objectName()))
            return;
        if (told && partsByRank.contains(label.objectName()) && label.fullText().startsWith(label.text()))
            return;
        add(label, QStringLiteral("\"%1\" is shown as \"%2\" in %3, needs %4")
                       .arg(label.fullText(), label.text())
                       .arg(label.width())
                       .arg(label.sizeHint().width()));
    }
    void checkButton(const QAbstractButton& button)
    {
        if (!button.text().isEmpty() && button.sizeHint().width() > button.width() + 1)
            add(button, QStringLiteral("\"%1\" needs %2, has %3 in width")
                            .arg(button.text())
                            .arg(button.sizeHint().width())
                            .arg(button.width()));
    }
    void checkBox(const QComboBox& box)
    {
        QStyleOptionComboBox option;
        option.initFrom(&box);
        option.editable = box.isEditable();
        option.frame = box.hasFrame();
        const int room =
            box.style()
                ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box)
                .width();
        const int text = box.fontMetrics().horizontalAdvance(box.currentText());
        if (!box.isEditable() && !qobject_cast<const NarrowChoice*>(&box) && text > room)
            add(box, QStringLiteral("\"%1\" needs %2, has %3").arg(box.currentText()).arg(text).arg(room));
    }
    void checkHeader(const QHeaderView& header)
    {
        if (header.orientation() != Qt::Horizontal || !header.model())
            return;
        for (int i = 0; i < header.count(); ++i) {
            const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
            int needed = 0;
            for (const QString& line : text.split(QLatin1Char('\n')))
                needed = std::max(needed, header.fontMetrics().horizontalAdvance(line));
            if (!header.isSectionHidden(i) && header.sectionSize(i) > 0 && needed > header.sectionSize(i))
                add(header, QStringLiteral("column \"%1\" needs %2, has %3")
                                .arg(text)
                                .arg(needed)
                                .arg(header.sectionSize(i)));
        }
    }

    static bool isControl(const QWidget& widget)
    {
        const bool control = qobject_cast<const QAbstractButton*>(&widget) ||
                             qobject_cast<const QComboBox*>(&widget) || widget.inherits("QLineEdit") ||
                             widget.inherits("QAbstractSpinBox") || widget.inherits("QSlider");
        const QWidget* parent = widget.parentWidget();
        const bool inner =
            parent && (qobject_cast<const QComboBox*>(parent) || parent->inherits("QAbstractSpinBox") ||
                       parent->inherits("QLineEdit") || parent->inherits("QAbstractItemView"));
        return control && !inner;
    }

    /// A finger in a glove: 40 px in height. What is lower (a box with its words) is at least 32, and nothing
    /// else lies in the 40 about its middle, so that a finger that is off finds nothing other.
    void checkTarget(const QWidget& widget)
    {
        constexpr int least = 32;
        const QWidget* window = widget.window();
        const QRect own(widget.mapTo(window, QPoint()), widget.size());
        if (own.height() < least || own.width() < least)
            return add(widget, QStringLiteral("%1 x %2 px").arg(own.width()).arg(own.height()));
        if (own.height() >= metrics::touchTarget)
            return;
        if (widget.visibleRegion().boundingRect().size() != widget.size())
            return; // at the edge of what scrolls, or beyond: no finger gets there before it was moved
        const int more = (metrics::touchTarget - own.height()) / 2;
        const QRect finger = own.adjusted(0, -more, 0, more);
        for (const QWidget* other : window->findChildren<QWidget*>()) {
            if (other == &widget || !other->isVisible() || other->window() != window || !isControl(*other) ||
                other->isAncestorOf(&widget) || widget.isAncestorOf(other))
                continue;
            if (QRect(other->mapTo(window, QPoint()), other->size()).intersects(finger))
                add(widget, QStringLiteral("%1 px high, and %2 within %3 px")
                                .arg(own.height())
                                .arg(describe(*other))
                                .arg(metrics::touchTarget));
        }
    }

    /// Words in a cell may end in dots, and are told whole when they are pointed at; a number may not.
    void checkNumbers(const QWidget& widget)
    {
        const auto* table = qobject_cast<const QTableView*>(&widget);
        if (!table || !table->model())
            return;
        constexpr int air = 6; // of the hint, that a cell can do without
        static const QRegularExpression number(QStringLiteral("^[±+\\-\u2212]?\\s?\\d"));
        const QAbstractItemModel& model = *table->model();
        const int first = std::max(0, table->rowAt(0));
        const int bottom = table->rowAt(table->viewport()->height() - 1);
        const int last = bottom < 0 ? model.rowCount() - 1 : bottom;
        for (int row = first; row <= last; ++row)
            for (int column = 0; column < model.columnCount(); ++column) {
                const QModelIndex index = model.index(row, column);
                if (table->isColumnHidden(column) || !number.match(index.data().toString()).hasMatch() ||
                    !(index.data(Qt::TextAlignmentRole).toInt() & Qt::AlignRight))
                    continue;
                if (const int needed = table->sizeHintForIndex(index).width() - air;
                    needed > table->columnWidth(column))
                    add(widget, QStringLiteral("number \"%1\" needs %2, has %3")
                                    .arg(index.data().toString())
                                    .arg(needed)
                                    .arg(table->columnWidth(column)));
            }
    }

    void checkControl(QWidget& widget)
    {
        if (!isControl(widget))
            return;
        checkTarget(widget);
        const auto* button = qobject_cast<QAbstractButton*>(&widget);
        if (widget.focusPolicy() != Qt::NoFocus && widget.accessibleName().isEmpty() &&
            !(button && !button->text().isEmpty()) && !hasBuddy(widget))
            add(widget, QStringLiteral("has no accessible name"));
    }
    /// What cannot be scrolled to the side is not wider than its window.
    void checkScrolled(const QWidget& widget)
    {
        const auto* area = qobject_cast<const QScrollArea*>(&widget);
        if (area && area->widget() && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff &&
            area->widget()->width() > area->viewport()->width())
            add(widget, QStringLiteral("shows %1 of %2 in width")
                            .arg(area->viewport()->width())
                            .arg(area->widget()->width()));
    }
    static bool hasBuddy(const QWidget& widget)
    {
        const QList<QLabel*> labels = widget.window()->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->buddy() == &widget; });
    }

    /// What a layout places may neither overlap nor leave its parent; what is placed by hand (marks over a
    /// picture) may.
    void checkPlaces(const QWidget& parent, const std::vector<QWidget*>& children)
    {
        if (!parent.layout())
            return;
        std::vector<QWidget*> placed;
        for (QWidget* child : children)
            if (isPlaced(*parent.layout(), *child))
                placed.push_back(child);
        for (std::size_t i = 0; i < placed.size(); ++i) {
            if (!parent.rect().contains(placed[i]->geometry()))
                add(*placed[i], QStringLiteral("leaves its parent"));
            for (std::size_t j = 0; j < i; ++j)
                if (placed[i]->geometry().intersects(placed[j]->geometry()))
                    add(*placed[i], QStringLiteral("lies over %1").arg(describe(*placed[j])));
        }
    }
    static QString describe(const QWidget& widget)
    {
        return widget.objectName().isEmpty() ? QString::fromLatin1(widget.metaObject()->className())
                                             : widget.objectName();
    }
    static bool isPlaced(const QLayout& layout, const QWidget& widget)
    {
        for (int i = 0; i < layout.count(); ++i) {
            QLayoutItem* item = layout.itemAt(i);
            if (item->widget() == &widget || (item->layout() && isPlaced(*item->layout(), widget)))
                return true;
        }
        return false;
    }

    QStringList m_findings;
};

} // namespace gripscope::test
