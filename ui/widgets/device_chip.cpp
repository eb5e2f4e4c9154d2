// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/device_chip.h"

#include "ui/theme/theme.h"
#include "ui/widgets/outcome_view.h"

#include <QPainter>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace gripscope {

DeviceChip::DeviceChip(QWidget* parent) : QAbstractButton(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void DeviceChip::setLink(ConnectSession::State state, const QString& words, const QString& detail)
{
    if (state == m_state && words == m_words && detail == m_detail)
        return;
    const bool resized = words.size() != m_words.size() || detail.size() != m_detail.size();
    m_state = state;
    m_words = words;
    m_detail = detail;
    setAccessibleName(tr("Gripper: %1").arg(words));
    setAccessibleDescription(detail);
    setToolTip(detail.isEmpty() ? words : u"%1 · %2"_s.arg(words, detail));
    if (resized)
        updateGeometry();
    update();
}

QSize DeviceChip::sizeHint() const
{
    const int words = QFontMetrics(Theme::font(metrics::fontBase, true)).horizontalAdvance(m_words);
    const int detail = QFontMetrics(Theme::font(metrics::fontBase)).horizontalAdvance(m_detail);
    return {36 + words + (detail ? 8 + detail : 0) + 34, metrics::touchTarget};
}

void DeviceChip::paintState(QPainter& painter, const QPointF& c) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    switch (m_state) {
    case ConnectSession::State::Connected:
        painter.setPen(Qt::NoPen);
        painter.setBrush(t.asExpected);
        painter.drawEllipse(c, 6, 6);
        break;
    case ConnectSession::State::Connecting:
        painter.setPen(QPen(t.accent, 2.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawArc(QRectF(c.x() - 6, c.y() - 6, 12, 12), 45 * 16, 270 * 16);
        break;
    case ConnectSession::State::Lost:
        paintOutcomeSign(painter, QRectF(c.x() - 9, c.y() - 9, 18, 18), InspectionOutcome::NotValid,
                         t.notValid);
        break;
    case ConnectSession::State::Disconnected:
        painter.setPen(QPen(t.secondText, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(c, 5.5, 5.5);
        break;
    }
}

void DeviceChip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeTokens& t = Theme::instance().tokens();
    const double w = hasFocus() ? 2 : t.lineWidth;
    painter.setPen(QPen(hasFocus() ? t.accent : t.line, w));
    painter.setBrush(isDown()       ? Theme::mix(t.surface, t.text, 0.12)
                     : underMouse() ? Theme::mix(t.surface, t.text, 0.06)
                                    : t.page);
    painter.drawRoundedRect(QRectF(rect()).adjusted(w / 2, w / 2, -w / 2, -w / 2), height() / 2.0,
                            height() / 2.0);
    paintState(painter, {20, height() / 2.0});
    const double end = width() - 30;
    // The name first: rate and losses are in the status line too.
    const QFont strong = Theme::font(metrics::fontBase, true);
    const QFont plain = Theme::font(metrics::fontBase);
    const QFontMetricsF strongMetrics(strong);
    const double room = end - 36;
    const QString words = strongMetrics.elidedText(m_words, Qt::ElideRight, room);
    painter.setFont(strong);
    painter.setPen(t.text);
    painter.drawText(QRectF(36, 0, room, height()), Qt::AlignLeft | Qt::AlignVCenter, words);
    const double from = 36 + strongMetrics.horizontalAdvance(words) + 8;
    if (QFontMetricsF(plain).horizontalAdvance(m_detail) <= end - from) {
        painter.setFont(plain);
        painter.setPen(t.secondText);
        painter.drawText(QRectF(from, 0, end - from, height()), Qt::AlignLeft | Qt::AlignVCenter, m_detail);
    }
    painter.setPen(QPen(t.secondText, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const QPointF tip(width() - 18, height() / 2.0 + 2);
    painter.drawPolyline(QPolygonF{{tip.x() - 4, tip.y() - 4}, tip, {tip.x() + 4, tip.y() - 4}});
}

} // namespace gripscope
