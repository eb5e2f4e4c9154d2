// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/shared/force_picture.h"

#include "ui/theme/theme.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace gripscope {

ForcePicture::ForcePicture(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Picture of the force"));
    setMinimumHeight(56);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

QSize ForcePicture::sizeHint() const
{
    return {320, 56};
}

void ForcePicture::show(std::vector<double> force_N, double limit_N)
{
    m_force_N = std::move(force_N);
    m_limit_N = limit_N;
    update();
}

void ForcePicture::paintEvent(QPaintEvent*)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    QPainter painter(this);
    painter.setPen(QPen(tokens.line, tokens.lineWidth));
    painter.setBrush(tokens.page);
    const QRect frame = rect().adjusted(0, 0, -1, -1);
    painter.drawRect(frame);
    if (m_force_N.empty() || !(m_limit_N > 0))
        return;
    const double largest = std::max(m_limit_N, *std::max_element(m_force_N.begin(), m_force_N.end()));
    const QRectF inside = QRectF(frame).adjusted(6, 6, -6, -6);
    const auto height = [&](double force_N) { return inside.bottom() - inside.height() * force_N / largest; };
    QPen limit(tokens.notValid, tokens.lineWidth, Qt::DashLine);
    painter.setPen(limit);
    painter.drawLine(QPointF(inside.left(), height(m_limit_N)), QPointF(inside.right(), height(m_limit_N)));
    QPainterPath path(QPointF(inside.left(), height(m_force_N.front())));
    const double step = inside.width() / static_cast<double>(m_force_N.size());
    for (std::size_t i = 0; i < m_force_N.size(); ++i) {
        // The force is held from sample to sample.
        const double y = height(m_force_N[i]);
        path.lineTo(inside.left() + static_cast<double>(i) * step, y);
        path.lineTo(inside.left() + static_cast<double>(i + 1) * step, y);
    }
    painter.setPen(QPen(tokens.force, tokens.lineWidth));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

} // namespace gripscope
