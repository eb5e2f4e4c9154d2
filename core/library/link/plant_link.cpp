// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/link/plant_link.h"

#include "core/base/words.h"
#include "core/library/library.h"
#include "core/library/link/shared_link.h"

namespace gripscope {

namespace {
constexpr std::chrono::milliseconds destructorPatience{40}; ///< the screen's thread may be the one that waits
}

Expected<void> checkOptions(const PlantLinkOptions& options)
{
    ASSIGN_OR_RETURN(const QString server, Library::placeFrom(options.server));
    if (!Library::isOnServer(server))
        return failure(ErrorCode::Usage, {Words::say("The plant's library is on a server: "
                                                     "postgresql://USER@HOST:PORT/NAME, not \"%1\".")
                                              .arg(options.server)});
    if (options.station.isEmpty() || Library::isOnServer(options.station))
        return failure(ErrorCode::Usage, {Words::say("This station's library is on a server already. Only a "
                                                     "file is kept in step with a server.")});
    return {};
}

PlantLink::PlantLink(const PlantLinkOptions& options)
    : m_state(std::make_shared<SharedLink>(options)),
      m_exchange([state = m_state] { exchangeUntilEnd(*state); }),
      m_watch([state = m_state] { watchUntilEnd(*state); })
{
}

PlantLink::~PlantLink()
{
    static_cast<void>(end(destructorPatience));
}

PlantStatus PlantLink::status() const
{
    return m_state->status();
}

qint64 PlantLink::typesTaken() const
{
    return m_state->typesTaken();
}

bool PlantLink::end(std::chrono::milliseconds patience)
{
    if (!m_exchange.joinable())
        return true;
    m_state->end();
    const bool done = m_state->hasEnded(patience);
    for (std::thread* thread : {&m_exchange, &m_watch})
        done ? thread->join() : thread->detach(); // it has all that it needs
    return done;
}

std::shared_ptr<LibraryGuest> PlantLink::guest() const
{
    return m_state;
}

} // namespace gripscope
