// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/windows/window_guard.h"

#include "ui/context/workbench.h"
#include "ui/windows/dialog.h"
#include "ui/windows/stop_controls.h"

#include <QApplication>
#include <QDropEvent>
#include <QKeyEvent>
#include <QLayout>
#include <QMouseEvent>
#include <QScreen>
#include <QShortcutEvent>
#include <QTouchEvent>
#include <QWindow>

#include <algorithm>
#include <optional>

namespace gripscope {

namespace {

bool isFree(const QRect& place, const QList<QRect>& free)
{
    return std::none_of(free.begin(), free.end(), [&](const QRect& one) { return one.intersects(place); });
}

} // namespace

QRect placeBeside(const QRect& wish, const QList<QRect>& free, const QRect& screen)
{
    if (isFree(wish, free))
        return wish;
    std::optional<QRect> best;
    const auto consider = [&](const QPoint& corner) {
        const QRect place(corner, wish.size());
        const auto way = [&](const QRect& one) { return (one.topLeft() - wish.topLeft()).manhattanLength(); };
        if (screen.contains(place) && isFree(place, free) && (!best || way(place) < way(*best)))
            best = place;
    };
    for (const QRect& one : free) {
        consider({one.left() - wish.width(), wish.top()});
        consider({one.right() + 1, wish.top()});
        consider({wish.left(), one.bottom() + 1});
        consider({wish.left(), one.top() - wish.height()});
    }
    return best.value_or(wish);
}

namespace {

/// What is left of the smallest screen, as the main window has it.
constexpr int leastScreen_px = 640;

/// Those that ask, the newest last.
QList<QPointer<QDialog>>& askers()
{
    static QList<QPointer<QDialog>> all;
    return all;
}

Dialog::Conduct conductOf(const QWidget* window)
{
    const auto* dialog = qobject_cast<const Dialog*>(window);
    return dialog ? dialog->conduct() : Dialog::Conduct::Asks;
}

QString manualPageOf(const QWidget* window)
{
    const auto* dialog = qobject_cast<const Dialog*>(window);
    return dialog ? dialog->manualPage() : QString();
}

bool isPopup(const QWidget* widget)
{
    return widget->isWindow() && (widget->windowType() == Qt::Popup || widget->windowType() == Qt::ToolTip);
}

/// `widget` is, or lies in or over, `window`.
bool belongsTo(const QWidget* widget, const QWidget* window)
{
    for (; widget; widget = widget->parentWidget())
        if (widget == window)
            return true;
    return false;
}

bool isBlocked(const QWidget* widget)
{
    const QDialog* asking = WindowGuard::asking();
    if (!asking || belongsTo(widget, asking) || qobject_cast<const StopButton*>(widget) ||
        isPopup(widget->window())) // that of a completer belongs to nobody
        return false;
    const auto* dialog = qobject_cast<const Dialog*>(widget->window());
    return !dialog || dialog->conduct() != Dialog::Conduct::Reads;
}

QWidget* ownerOf(QObject* object)
{
    while (object && !object->isWidgetType())
        object = object->parent();
    return static_cast<QWidget*>(object);
}

/// How a person's hand reaches a widget. Releases are not among them: a press that came before the dialog is
/// to end.
bool isInput(QEvent::Type type)
{
    switch (type) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::TouchBegin:
    case QEvent::TabletPress:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::Shortcut:
    case QEvent::ContextMenu:
    case QEvent::InputMethod:
    case QEvent::DragEnter:
    case QEvent::DragMove:
    case QEvent::Drop:
        return true;
    default:
        return false;
    }
}

/// What holds the mouse lets go of it.
void closePopups()
{
    for (int i = 0; i < 16; ++i) { // menus in menus
        QWidget* popup = QApplication::activePopupWidget();
        if (!popup || !popup->close())
            return;
    }
}

} // namespace

WindowGuard::WindowGuard(Workbench& workbench, QObject* parent) : QObject(parent), m_workbench(&workbench)
{
    qApp->installEventFilter(this);
}

WindowGuard::~WindowGuard()
{
    qApp->removeEventFilter(this);
}

QDialog* WindowGuard::asking()
{
    for (auto one = askers().crbegin(); one != askers().crend(); ++one)
        if (*one && (*one)->isVisible())
            return *one;
    return nullptr;
}

bool WindowGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (watched->isWindowType())
        return seeAtWindow(watched, event);
    if (watched->isWidgetType())
        return seeAtWidget(static_cast<QWidget*>(watched), event);
    if (event->type() == QEvent::Shortcut) // of a QShortcut or an action
        if (const QWidget* owner = ownerOf(watched); owner && isBlocked(owner)) {
            if (static_cast<QShortcutEvent*>(event)->key() == QKeySequence(Qt::Key_F1))
                emit helpAsked(manualPageOf(asking())); // reading is never kept from anybody
            return true;
        }
    return false;
}

bool WindowGuard::seeAtWindow(QObject* window, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: {
        const auto& press = *static_cast<QMouseEvent*>(event);
        return stopsAt(window, press.globalPosition().toPoint(), press.button() == Qt::LeftButton);
    }
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
        for (const QEventPoint& point : static_cast<QTouchEvent*>(event)->points())
            if (point.state() == QEventPoint::Pressed &&
                stopsAt(window, point.globalPosition().toPoint(), false))
                return true;
        return false;
    case QEvent::KeyPress:
        stopByKey(*static_cast<QKeyEvent*>(event));
        return false;
    case QEvent::DragEnter:
    case QEvent::DragMove:
    case QEvent::Drop:
        return dragStops(window, event);
    default:
        return false;
    }
}

bool WindowGuard::seeAtWidget(QWidget* widget, QEvent* event)
{
    switch (event->type()) {
    case QEvent::KeyPress: {
        const auto& key = *static_cast<QKeyEvent*>(event);
        stopByKey(key); // of keys that reached no window first: a screen keyboard's, a test's
        const auto* dialog = qobject_cast<QDialog*>(widget->window());
        if (key.key() == Qt::Key_F1 && dialog && conductOf(dialog) != Dialog::Conduct::Reads) {
            emit helpAsked(manualPageOf(dialog));
            return true;
        }
        break;
    }
    case QEvent::Polish:
    case QEvent::Show:
        if (auto* dialog = qobject_cast<QDialog*>(widget); dialog && dialog->isWindow())
            adopt(dialog, event->type() == QEvent::Show);
        [[fallthrough]];
    case QEvent::Move:
    case QEvent::Resize:
        if (isPopup(widget) && !m_placing && (event->type() == QEvent::Show || widget->isVisible())) {
            const QRect place =
                placeBeside(widget->geometry(), StopButton::places(), widget->screen()->availableGeometry());
            m_placing = true;
            widget->move(place.topLeft());
            m_placing = false;
        }
        return false;
    case QEvent::Hide:
        if (auto* dialog = qobject_cast<QDialog*>(widget); dialog && dialog->isWindow())
            release(dialog);
        return false;
    default:
        break;
    }
    if (!isInput(event->type()) || !isBlocked(widget))
        return false;
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::TouchBegin) {
        asking()->raise(); // to show what is waited for
        asking()->activateWindow();
    }
    return true;
}

void WindowGuard::stopByKey(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Escape && !event.isAutoRepeat())
        m_workbench->stop();
}

bool WindowGuard::stopsAt(QObject* window, const QPoint& global, bool buttonTakesIt)
{
    StopButton* stop = StopButton::at(global);
    if (!stop)
        return false;
    const bool itsOwn = stop->window()->windowHandle() == window;
    const QWidget* popup = QApplication::activePopupWidget();
    if (buttonTakesIt && itsOwn && !popup && !QWidget::mouseGrabber())
        return false; // the button gets it, and shows that it does
    stop->press();
    closePopups();
    return true;
}

bool WindowGuard::dragStops(QObject* window, QEvent* event)
{
    // Qt's own filter for the keys of a drag was put in front when it began, and would keep Esc.
    if (event->type() == QEvent::DragEnter)
        qApp->installEventFilter(this);
    const auto* drop = static_cast<QDropEvent*>(event);
    const QPoint global = static_cast<QWindow*>(window)->mapToGlobal(drop->position().toPoint());
    StopButton* stop = StopButton::at(global);
    if (!stop || event->type() == QEvent::DragEnter)
        return false;
    if (event->type() == QEvent::Drop)
        stop->press(); // let go over it: that is as near to a press as a drag comes
    return event->type() == QEvent::Drop;
}

void WindowGuard::adopt(QDialog* dialog, bool shown)
{
    if (dialog->isModal())
        dialog->setWindowModality(Qt::NonModal);
    addStrip(dialog);
    if (conductOf(dialog) != Dialog::Conduct::Asks || !shown)
        return;
    askers().removeAll(nullptr);
    askers().removeAll(dialog);
    askers().append(dialog);
}

void WindowGuard::addStrip(QDialog* dialog)
{
    if (!dialog->layout())
        return;
    auto* strip = dialog->findChild<StopStrip*>(QString(), Qt::FindDirectChildrenOnly);
    if (!strip) {
        strip = new StopStrip(*m_workbench, dialog);
        const auto follow = [dialog](bool visible) {
            const int by = visible ? StopStrip::height_px : -StopStrip::height_px;
            dialog->resize(dialog->width(),
                           std::min(dialog->height() + by, std::max(dialog->height(), leastScreen_px)));
        };
        connect(strip, &StopStrip::shown, dialog, follow);
        if (!strip->isHidden() && dialog->testAttribute(Qt::WA_Resized))
            follow(true);
        auto* notice = new StopNotice(m_workbench->connection(), strip, dialog);
        connect(m_workbench, &Workbench::ticked, notice, &StopNotice::refresh);
    }
    if (dialog->layout()->menuBar() != strip) // a message box of Qt lays itself out anew
        dialog->layout()->setMenuBar(strip);
}

void WindowGuard::release(QDialog* dialog)
{
    if (!askers().removeAll(dialog))
        return;
    // Not every platform gives the focus back to where the dialog came from.
    QWidget* next = asking() ? asking() : dialog->parentWidget() ? dialog->parentWidget()->window() : nullptr;
    const QWidget* active = QApplication::activeWindow();
    if (next && next->isVisible() && (!active || active == dialog))
        next->activateWindow();
}

} // namespace gripscope
