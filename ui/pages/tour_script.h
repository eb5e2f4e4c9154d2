// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>

#include <functional>
#include <vector>

namespace gripscope {

class Workbench;

/// Steps of a demonstration, one after another: each does something and waits for what should come of it.
/// Driven by the workbench's ticks, so that the program goes on living meanwhile.
class TourScript : public QObject {
    Q_OBJECT
public:
    void add(std::function<void()> action, std::function<bool()> reached);
    void wait(int milliseconds);
    /// Connects to an address and arms it, as a person would.
    void connectTo(Workbench& workbench, const QString& address);
    void start(Workbench& workbench);
    [[nodiscard]] bool done() const { return m_started && m_next >= m_steps.size() && !m_waiting; }

private:
    void advance();
    struct Step {
        std::function<void()> action;
        std::function<bool()> reached;
    };
    std::vector<Step> m_steps;
    std::size_t m_next = 0;
    bool m_started = false;
    std::function<bool()> m_waiting;
    QElapsedTimer m_clock;
};

} // namespace gripscope
