// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/controls.h"

#include "ui/theme/theme.h"

#include <QBoxLayout>
#include <QScrollArea>
#include <QStyle>

#include <optional>

namespace gripscope {

void setRole(QWidget* widget, const char* role)
{
    widget->setProperty("role", QString::fromLatin1(role));
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
}

QFrame* makeCard(QWidget* parent)
{
    auto* card = new QFrame(parent);
    setRole(card, "card");
    return card;
}

QScrollArea* makeScroll(QWidget* inside, QWidget* parent)
{
    auto* scroll = new QScrollArea(parent);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(inside);
    return scroll;
}

QFrame* makeRule(QWidget* parent)
{
    auto* rule = new QFrame(parent);
    setRole(rule, "rule");
    return rule;
}

QLabel* makeLabel(const QString& text, const char* role, QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText); // before it has its text: a name may look like markup
    label->setText(text);
    if (*role)
        setRole(label, role);
    return label;
}

namespace {

/// A checked button's words are bold: its room does not change with them.
class RoomyButton : public QPushButton {
public:
    using QPushButton::QPushButton;
    [[nodiscard]] QSize sizeHint() const override
    {
        QSize size = QPushButton::sizeHint();
        if (isCheckable()) {
            QFont bold = font();
            bold.setWeight(QFont::DemiBold);
            size.rwidth() +=
                QFontMetrics(bold).horizontalAdvance(text()) - fontMetrics().horizontalAdvance(text()) + 1;
        }
        return size;
    }
};

} // namespace

QPushButton* makeButton(const QString& text, const QString& icon, const char* role, QWidget* parent)
{
    auto* button = new RoomyButton(text, parent);
    if (*role)
        setRole(button, role);
    const auto paintIcon = [button, icon] {
        if (icon.isEmpty())
            return;
        const QString shown = button->property("role").toString();
        const ThemeTokens& tokens = Theme::instance().tokens();
        std::optional<QColor> color; // as its words
        if (shown == QLatin1String("primary"))
            color = Theme::onColor(tokens.accent);
        else if (shown == QLatin1String("quiet") && !button->text().isEmpty())
            color = tokens.accent;
        button->setIcon(Theme::instance().icon(icon, color));
        button->setIconSize({20, 20});
    };
    paintIcon();
    QObject::connect(&Theme::instance(), &Theme::changed, button, paintIcon);
    button->setAccessibleName(text);
    return button;
}

void setSpacing(QBoxLayout* layout, int margin, int spacing)
{
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(spacing);
}

QLabel* addCaptionedValue(QBoxLayout* row, const QString& caption, int minimumWidth, QWidget* parent)
{
    auto* pair = new QVBoxLayout;
    pair->setSpacing(0);
    pair->addWidget(makeLabel(caption, "caption", parent));
    QLabel* value = makeLabel(QStringLiteral("\u2013"), "strong", parent);
    value->setMinimumWidth(minimumWidth);
    value->setAccessibleName(caption);
    pair->addWidget(value);
    row->addLayout(pair);
    return value;
}

} // namespace gripscope
