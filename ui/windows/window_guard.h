// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>
#include <QRect>

class QDialog;
class QKeyEvent;
class QWidget;

namespace gripscope {

class Workbench;

/// Where a popup of this size and wish is to be, so that it lies on `screen` and on none of `free`: as near
/// to its wish as can be. Where there is no such place, the wish.
[[nodiscard]] QRect placeBeside(const QRect& wish, const QList<QRect>& free, const QRect& screen);

/// Keeps Stop within reach whatever is open. It sees every event before any window does:
/// - Esc stops, wherever the focus is, and then does what it does there (it closes a menu or a dialog).
/// - A press or a touch on a STOP stops also while a menu, a list, a calendar or a drag holds the mouse, and
///   closes what held it.
/// - Menus, lists and tooltips open where they cover no STOP.
/// - No dialog is modal, Qt's own neither: while one asks, input to the other windows is kept from all but
/// their
///   STOPs. Each dialog gets a STOP of its own (StopStrip), and gives the focus back where it came from.
class WindowGuard : public QObject {
    Q_OBJECT
public:
    explicit WindowGuard(Workbench& workbench, QObject* parent = nullptr);
    ~WindowGuard() override;

    /// The dialog that asks; null while none does.
    [[nodiscard]] static QDialog* asking();

signals:
    void helpAsked(const QString& page); ///< F1 in a dialog, and its page of the manual (see Dialog)

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool seeAtWindow(QObject* window, QEvent* event);
    bool seeAtWidget(QWidget* widget, QEvent* event);
    bool stopsAt(QObject* window, const QPoint& global, bool buttonTakesIt);
    void stopByKey(const QKeyEvent& event);
    bool dragStops(QObject* window, QEvent* event);
    void adopt(QDialog* dialog, bool shown);
    void release(QDialog* dialog);
    void addStrip(QDialog* dialog);
    Workbench* m_workbench;
    bool m_placing = false;
};

} // namespace gripscope
