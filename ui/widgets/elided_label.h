// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QStringList>

namespace gripscope {

/// One line of text that ends in an ellipsis where there is no room, with the whole as tool tip then. Of
/// several parts, as many are shown as have room whole.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(const QString& text = {}, QWidget* parent = nullptr);
    void setFullText(const QString& text);
    [[nodiscard]] const QString& fullText() const { return m_full; }
    /// The most important first: those at the end give way.
    void setParts(const QStringList& parts, const QString& separator);
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void elide();
    [[nodiscard]] QString fitting() const; ///< as many parts as have room, at least the first
    QStringList m_parts;
    QString m_separator, m_full;
};

} // namespace gripscope
