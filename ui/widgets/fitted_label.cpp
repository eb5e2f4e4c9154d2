// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/fitted_label.h"

#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"

#include <QPainter>

namespace gripscope {

FittedLabel::FittedLabel(int height, QWidget* parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setFixedHeight(height);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

int FittedLabel::fontPixels() const
{
    for (int pixels = height(); pixels > metrics::fontBase; --pixels) {
        const QFontMetricsF font(Theme::font(pixels, true));
        if (font.ascent() + font.descent() * 0.5 <= height() && font.horizontalAdvance(text()) <= width())
            return pixels;
    }
    return metrics::fontBase;
}

void FittedLabel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QFont font = Theme::font(fontPixels(), true);
    painter.setFont(font);
    painter.setPen(Theme::instance().tokens().text);
    painter.drawText(QRectF(rect()), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                     elided(QFontMetricsF(font), text(), width()));
}

} // namespace gripscope
