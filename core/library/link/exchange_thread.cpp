// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/link/shared_link.h"
#include "core/library/link/station_hold.h"

#include <algorithm>
#include <random>

namespace gripscope {

namespace {

/// What the thread has open, and how far it came.
class Exchange {
public:
    explicit Exchange(SharedLink& state) : m_state(state), m_station(state, ExchangeThread) {}

    void letGo()
    {
        m_station.close();
        m_server.reset();
        m_marks.clear();
    }
    /// The server first: while it is not reached, this thread has not the station's file.
    [[nodiscard]] Expected<ExchangeStep> step()
    {
        if (!m_server) {
            ASSIGN_OR_RETURN(m_server, Library::open(m_state.options().server, m_state.hangup()));
        }
        ASSIGN_OR_RETURN(Library* const station, m_station.open());
        ASSIGN_OR_RETURN(ExchangeStep taken, station->exchangeWith(*m_server, m_marks, linksOfStep));
        m_marks = taken.marks;
        return taken;
    }
    [[nodiscard]] bool serverAnswers() const { return m_server && !m_server->hasLostServer(); }

private:
    SharedLink& m_state;
    StationHold m_station;
    std::unique_ptr<Library> m_server;
    QString m_marks;
};

} // namespace

void exchangeUntilEnd(SharedLink& state)
{
    using std::chrono::milliseconds;
    const PlantLinkOptions& options = state.options();
    Exchange exchange(state);
    std::mt19937 random(std::random_device{}()); // a moment of its own
    milliseconds pause{0}, retry = options.every;
    while (state.await(pause, [&] { exchange.letGo(); })) {
        state.beginStep();
        const Expected<ExchangeStep> taken = exchange.step();
        if (taken) {
            state.endStep(*taken);
            retry = options.every;
            pause = taken->inStep ? options.every : milliseconds(0);
            continue;
        }
        state.endStep(taken.error(), exchange.serverAnswers());
        exchange.letGo();
        pause = milliseconds(std::uniform_int_distribution<qint64>(retry.count() / 2, retry.count())(random));
        retry = std::min(2 * retry, options.retryMost);
    }
    exchange.letGo();
    state.noteEnd();
}

} // namespace gripscope
