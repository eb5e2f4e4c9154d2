// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include <QApplication>
#include <QEvent>
#include <QScrollBar>
#include <QStackedWidget>
#include <QWheelEvent>

#include <algorithm>

namespace gripscope {

namespace {
constexpr int leastHeight = 160; // in which a page can still be read
constexpr int stepOfScrolling = 24;
} // namespace

PageView::PageView(QStackedWidget& pages, QWidget* parent)
    : QWidget(parent), m_pages(&pages), m_bar(new QScrollBar(Qt::Vertical, this))
{
    m_pages->setParent(this);
    m_bar->setObjectName("pageScroll");
    m_bar->setAccessibleName(tr("Scrolls the page"));
    m_bar->setSingleStep(stepOfScrolling);
    m_bar->hide();
    connect(m_bar, &QScrollBar::valueChanged, this, &PageView::place);
    connect(m_pages, &QStackedWidget::currentChanged, this, [this] {
        m_bar->setValue(0);
        place();
    });
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (now && m_pages->isAncestorOf(now))
            reveal(*now);
    });
}

PageView::~PageView()
{
    disconnect(qApp, nullptr, this, nullptr); // the focus may still move while the pages go
}

QSize PageView::minimumSizeHint() const
{
    return {m_pages->minimumSizeHint().width(), leastHeight};
}

bool PageView::event(QEvent* event)
{
    if (event->type() == QEvent::LayoutRequest)
        place();
    return QWidget::event(event);
}

void PageView::resizeEvent(QResizeEvent*)
{
    place();
}

void PageView::wheelEvent(QWheelEvent* event)
{
    QCoreApplication::sendEvent(m_bar, event);
}

void PageView::place()
{
    const QWidget* page = m_pages->currentWidget(); // the others need nothing
    const int needed = std::max(height(), page ? page->minimumSizeHint().height() : 0);
    m_bar->setRange(0, needed - height());
    m_bar->setPageStep(height());
    m_bar->setVisible(needed > height());
    const int bar = m_bar->sizeHint().width();
    m_bar->setGeometry(width() - bar, 0, bar, height());
    m_bar->raise();
    m_pages->setGeometry(0, -m_bar->value(), width(), needed);
}

void PageView::reveal(const QWidget& widget)
{
    const int top = widget.mapTo(this, QPoint()).y();
    const int below = top + widget.height() - height();
    if (top < 0 || widget.height() > height())
        m_bar->setValue(m_bar->value() + top);
    else if (below > 0)
        m_bar->setValue(m_bar->value() + below);
}

} // namespace gripscope
