// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/tool_button.h"

#include "ui/theme/theme.h"

namespace gripscope {

QToolButton* makeToolButton(const QString& text, const QString& icon, const QString& tip)
{
    auto* button = new QToolButton;
    button->setAccessibleName(tip);
    button->setToolTip(tip);
    if (icon.isEmpty()) {
        button->setText(text);
        return button;
    }
    const auto paint = [button, icon] { button->setIcon(Theme::instance().icon(icon)); };
    paint();
    button->setIconSize({20, 20});
    QObject::connect(&Theme::instance(), &Theme::changed, button, paint);
    return button;
}

} // namespace gripscope
