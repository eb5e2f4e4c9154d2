// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QScrollBar;
class QStackedWidget;

namespace gripscope {

/// Gives the pages at least the height that they need: where a message leaves less of a low window, they are
/// scrolled, and the window stays as large as it is. By hand, since a QScrollArea would ask for the height
/// that they like best.
class PageView : public QWidget {
    Q_OBJECT
public:
    PageView(QStackedWidget& pages, QWidget* parent);
    ~PageView() override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void place();
    void reveal(const QWidget& widget); ///< that the keyboard came to
    QStackedWidget* m_pages;
    QScrollBar* m_bar; ///< over their margin: they keep their width
};

} // namespace gripscope
