// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/tour_script.h"

#include "ui/context/workbench.h"

namespace gripscope {

void TourScript::add(std::function<void()> action, std::function<bool()> reached)
{
    m_steps.push_back({std::move(action), std::move(reached)});
}

void TourScript::wait(int milliseconds)
{
    add([this] { m_clock.start(); }, [this, milliseconds] { return m_clock.elapsed() >= milliseconds; });
}

void TourScript::connectTo(Workbench& workbench, const QString& address)
{
    Workbench* bench = &workbench;
    add([] {}, [bench] { return !bench->busyWithSqueeze(); }); // of the page before
    add([bench, address] { bench->connectTo(address); },
        [bench] { return bench->connection().state() == ConnectSession::State::Connected; });
    add([bench] { bench->arm(); }, [bench] { return bench->connection().armed(); });
}

void TourScript::start(Workbench& workbench)
{
    m_started = true;
    connect(&workbench, &Workbench::ticked, this, &TourScript::advance, Qt::UniqueConnection);
}

void TourScript::advance()
{
    if (m_waiting && !m_waiting())
        return;
    m_waiting = nullptr;
    if (m_next >= m_steps.size())
        return;
    const Step step = m_steps[m_next++];
    m_waiting = step.reached;
    step.action();
}

} // namespace gripscope
