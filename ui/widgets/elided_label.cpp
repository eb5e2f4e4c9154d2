// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/elided_label.h"

#include "ui/theme/elided_text.h"

#include <QFontMetrics>

namespace gripscope {

ElidedLabel::ElidedLabel(const QString& text, QWidget* parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setFullText(text);
}

void ElidedLabel::setFullText(const QString& text)
{
    setParts({text}, {});
}

void ElidedLabel::setParts(const QStringList& parts, const QString& separator)
{
    const QString full = parts.join(separator);
    if (full == m_full && parts.size() == m_parts.size())
        return;
    m_parts = parts;
    m_separator = separator;
    m_full = full;
    setAccessibleName(full);
    updateGeometry();
    elide();
}

QSize ElidedLabel::minimumSizeHint() const
{
    return {fontMetrics().averageCharWidth() * 6, QLabel::minimumSizeHint().height()};
}

QSize ElidedLabel::sizeHint() const
{
    return {fontMetrics().horizontalAdvance(m_full) + 4, QLabel::sizeHint().height()};
}

void ElidedLabel::resizeEvent(QResizeEvent* event)
{
    QLabel::resizeEvent(event);
    elide();
}

QString ElidedLabel::fitting() const
{
    QStringList parts = m_parts;
    while (parts.size() > 1 &&
           fontMetrics().horizontalAdvance(parts.join(m_separator)) > contentsRect().width())
        parts.removeLast();
    return parts.join(m_separator);
}

void ElidedLabel::elide()
{
    const QString shown = elided(fontMetrics(), fitting(), contentsRect().width());
    setText(shown);
    setToolTip(shown == m_full ? QString() : m_full);
}

} // namespace gripscope
