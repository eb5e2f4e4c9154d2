// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/rail_button.h"

#include "ui/theme/theme.h"

#include <QPainter>

namespace gripscope {

RailButton::RailButton(const QString& text, const QString& icon, QWidget* parent)
    : QAbstractButton(parent), m_icon(icon)
{
    setText(text);
    setAccessibleName(text);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

QSize RailButton::sizeHint() const
{
    const int word = QFontMetrics(Theme::font(metrics::fontSmall, true)).horizontalAdvance(text());
    return {word + 2 * metrics::step, 64};
}

void RailButton::enterEvent(QEnterEvent* event)
{
    QAbstractButton::enterEvent(event);
    update();
}

void RailButton::leaveEvent(QEvent* event)
{
    QAbstractButton::leaveEvent(event);
    update();
}

void RailButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeTokens& t = Theme::instance().tokens();
    const QRectF box = QRectF(rect()).adjusted(6, 2, -6, -2);
    painter.setPen(Qt::NoPen);
    if (isChecked())
        painter.setBrush(Theme::mix(t.surface, t.accent, t.kind == ThemeKind::HighContrast ? 0.0 : 0.12));
    else if (underMouse() || isDown())
        painter.setBrush(Theme::mix(t.surface, t.text, isDown() ? 0.12 : 0.06));
    painter.drawRoundedRect(box, metrics::radius, metrics::radius);
    if (isChecked()) {
        painter.setBrush(t.accent);
        painter.drawRoundedRect(QRectF(0, box.top() + 8, 4, box.height() - 16), 2, 2);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(t.accent, 2));
        painter.drawRoundedRect(box.adjusted(1, 1, -1, -1), metrics::radius, metrics::radius);
    }
    const QColor color = isChecked() ? t.accent : t.text;
    const double middle = box.center().x();
    Theme::instance()
        .icon(m_icon, color)
        .paint(&painter, QRectF(middle - 12, box.top() + 8, 24, 24).toRect());
    painter.setPen(color);
    painter.setFont(Theme::font(metrics::fontSmall, isChecked()));
    painter.drawText(QRectF(box.left(), box.bottom() - 24, box.width(), 18), Qt::AlignCenter, text());
}

} // namespace gripscope
