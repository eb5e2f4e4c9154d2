// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>
#include <QWidget>

#include <optional>

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

    /// With less room around it: a message is above it, and the window is low.
    void setTight(bool tight)
    {
        if (!m_margins)
            m_margins = layout()->contentsMargins();
        layout()->setContentsMargins(m_margins->left(), m_margins->top() / (tight ? 2 : 1),
                                     m_margins->right(), m_margins->bottom() / (tight ? 2 : 1));
    }

    /// Whether something is under way that lives in this page and would be lost with it: then the window is
    /// not built anew.
    [[nodiscard]] virtual bool underWay() const { return false; }

    /// For `--tour`: bring the page to a telling state with the virtual gripper and the example types. Called
    /// once, while shown; the tour then waits until tourReady() (it gives up, and says so, after 30 s).
    virtual void prepareTour() {}
    [[nodiscard]] virtual bool tourReady() const { return true; }

protected:
    [[nodiscard]] Workbench& workbench() const { return *m_workbench; }

private:
    Workbench* m_workbench;
    std::optional<QMargins> m_margins; ///< where there is room
};

} // namespace gripscope
