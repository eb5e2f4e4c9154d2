// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace gripscope {

class Workbench;

/// One page of the window. A page shows what the sessions of the workbench hold and asks them for things; it
/// computes nothing and waits for nothing.
class Page : public QWidget {
    Q_OBJECT
public:
    explicit Page(Workbench& workbench, QWidget* parent = nullptr) : QWidget(parent), m_workbench(&workbench)
    {
    }

    [[nodiscard]] virtual QString id() const = 0;       ///< "live", names the tour's picture
    [[nodiscard]] virtual QString title() const = 0;    ///< translated, for rail and header
    [[nodiscard]] virtual QString iconName() const = 0; ///< of the breeze icon theme

    /// Called when the page comes into view or leaves it; timers and pictures rest while it is out of view.
    virtual void setActive(bool) {}

    /// For `--tour`: bring the page to a telling state with the virtual gripper and the example types. Called
    /// once, while shown; the tour then waits until tourReady() (it gives up, and says so, after 30 s).
    virtual void prepareTour() {}
    [[nodiscard]] virtual bool tourReady() const { return true; }

protected:
    [[nodiscard]] Workbench& workbench() const { return *m_workbench; }

private:
    Workbench* m_workbench;
};

} // namespace gripscope
