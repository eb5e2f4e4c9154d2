// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/part_picture_view.h"

#include "ui/part_picture_reader.h"
#include "ui/theme/theme.h"
#include "ui/workbench.h"

#include <QPainter>

namespace gripscope {

using namespace Qt::StringLiterals;

PartPictureView::PartPictureView(Workbench& workbench, int side, Empty empty, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_side(side), m_empty(empty)
{
    setFixedSize(side, side);
    setAccessibleName(tr("Picture of the part: none"));
    setVisible(empty == Empty::Frame);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void PartPictureView::setPicture(const std::optional<PartPicture>& picture)
{
    if (m_picture == picture)
        return;
    m_picture = picture;
    m_pixmap = {};
    setVisible(m_empty == Empty::Frame || picture);
    setAccessibleName(picture ? tr("Picture of the part") : tr("Picture of the part: none"));
    update();
    if (!picture)
        return;
    const double ratio = devicePixelRatioF();
    const int pixels = static_cast<int>(m_side * ratio);
    m_workbench->compute<QImage>(
        this, [picture = *picture, pixels] { return shownPicture(picture, pixels); },
        [this, id = picture->id, ratio](const QImage& image) {
            if (!m_picture || m_picture->id != id)
                return;
            m_pixmap = QPixmap::fromImage(image);
            m_pixmap.setDevicePixelRatio(ratio);
            update();
        });
}

void PartPictureView::paintEvent(QPaintEvent*)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    QPainter painter(this);
    if (!m_pixmap.isNull()) {
        const QSizeF size = m_pixmap.deviceIndependentSize();
        painter.drawPixmap(QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), m_pixmap);
        return;
    }
    if (m_empty == Empty::Hidden)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(tokens.secondText, tokens.lineWidth, Qt::DashLine));
    painter.setBrush(tokens.page);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), metrics::radius, metrics::radius);
    const int icon = m_side / 3;
    Theme::instance()
        .icon(u"insert-image"_s, tokens.secondText)
        .paint(&painter, (width() - icon) / 2, (height() - icon) / 2, icon, icon);
}

} // namespace gripscope
