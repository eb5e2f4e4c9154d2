// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/narrow_choice.h"

#include "ui/theme/elided_text.h"

#include <QHelpEvent>
#include <QStylePainter>
#include <QToolTip>

namespace gripscope {

using namespace Qt::StringLiterals;

NarrowChoice::NarrowChoice(int leastLetters, QWidget* parent) : QComboBox(parent)
{
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(leastLetters);
}

QString NarrowChoice::shownText(const QStyleOptionComboBox& option) const
{
    // As much as the style leaves beside the arrow, less what it puts between text and edge.
    constexpr int edges = 4;
    const QRect room =
        style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    return elided(fontMetrics(), option.currentText, room.width() - edges);
}

bool NarrowChoice::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        QStyleOptionComboBox option;
        initStyleOption(&option);
        if (shownText(option) != option.currentText) {
            const QString text =
                toolTip().isEmpty() ? option.currentText : u"%1: %2"_s.arg(toolTip(), option.currentText);
            QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text, this);
            return true;
        }
    }
    return QComboBox::event(event);
}

void NarrowChoice::paintEvent(QPaintEvent*)
{
    QStylePainter painter(this);
    painter.setPen(palette().color(QPalette::Text));
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    option.currentText = shownText(option);
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

} // namespace gripscope
