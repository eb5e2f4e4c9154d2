// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme/theme.h"
#include "ui/widgets/elided_label.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QScrollArea>
#include <QStyleOptionComboBox>
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
        QStringList path;
        for (const QWidget* w = &widget; w && path.size() < 4; w = w->parentWidget())
            path.prepend(w->objectName().isEmpty() ? QString::fromLatin1(w->metaObject()->className())
                                                   : w->objectName());
        m_findings << path.join(u'/') + QStringLiteral(": ") + what;
    }

    void visit(QWidget& widget)
    {
        checkText(widget);
        checkControl(widget);
        checkScrolled(widget);
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
        if (label.text().isEmpty() || qobject_cast<const ElidedLabel*>(&label))
            return;
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
        if (!box.isEditable() && text > room)
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

    /// A finger in a glove: 40 px in height, as all controls here share their rows.
    void checkControl(QWidget& widget)
    {
        const bool isControl = qobject_cast<QAbstractButton*>(&widget) || qobject_cast<QComboBox*>(&widget) ||
                               widget.inherits("QLineEdit") || widget.inherits("QAbstractSpinBox") ||
                               widget.inherits("QSlider");
        const bool isInner = widget.parentWidget() && (qobject_cast<QComboBox*>(widget.parentWidget()) ||
                                                       widget.parentWidget()->inherits("QAbstractSpinBox") ||
                                                       widget.parentWidget()->inherits("QLineEdit") ||
                                                       widget.parentWidget()->inherits("QAbstractItemView"));
        if (!isControl || isInner)
            return;
        if (widget.height() < metrics::touchTarget && widget.parentWidget()->height() < metrics::touchTarget)
            add(widget, QStringLiteral("%1 px high").arg(widget.height()));
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
