// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/link/shared_link.h"

#include "core/base/words.h"
#include "core/library/library.h"

namespace gripscope {

namespace {

/// libpq gives up a connection that does not come about after ten seconds.
constexpr std::chrono::seconds leavingPatience{15};
/// A server that is silent for so long is told to be.
constexpr std::chrono::seconds silentAfter{10};

} // namespace

SharedLink::SharedLink(const PlantLinkOptions& options) : m_options(options)
{
    m_known.on = true;
    m_known.server = Library::placeFrom(options.server).value_or(QString());
}

PlantStatus SharedLink::status() const
{
    const std::lock_guard lock(m_mutex);
    PlantStatus status = m_known;
    if (!m_stepBegan || !status.reached)
        return status;
    const auto silent = LinkClock::now() - *m_stepBegan;
    if (silent < silentAfter)
        return status;
    status.reached = status.inStep = false;
    status.problem = Error{ErrorCode::Usage,
                           {Words::say("The server has not answered for %1 s.")
                                .arg(std::chrono::duration_cast<std::chrono::seconds>(silent).count())}};
    return status;
}

qint64 SharedLink::typesTaken() const
{
    const std::lock_guard lock(m_mutex);
    return m_known.typesTaken;
}

void SharedLink::end()
{
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
        m_turn.notify_all();
    }
    m_hangup->hangUpForGood();
}

bool SharedLink::hasEnded(std::chrono::milliseconds patience)
{
    std::unique_lock lock(m_mutex);
    return m_quiet.wait_for(lock, patience, [this] { return m_running == 0; });
}

void SharedLink::leave()
{
    {
        const std::lock_guard lock(m_mutex);
        m_suspended = true;
        m_turn.notify_all();
    }
    m_hangup->hangUp();
    std::unique_lock lock(m_mutex);
    m_quiet.wait_for(lock, leavingPatience,
                     [this] { return !m_holds[ExchangeThread] && !m_holds[WatchThread]; });
}

void SharedLink::comeBack()
{
    const std::lock_guard lock(m_mutex);
    m_suspended = false;
    m_turn.notify_all();
}

bool SharedLink::await(std::chrono::milliseconds pause, const std::function<void()>& letGo)
{
    std::unique_lock lock(m_mutex);
    m_turn.wait_for(lock, pause, [this] { return m_ending || m_suspended; });
    if (m_suspended) {
        lock.unlock();
        letGo();
        lock.lock();
        m_turn.wait(lock, [this] { return m_ending || !m_suspended; });
    }
    return !m_ending;
}

void SharedLink::noteEnd()
{
    const std::lock_guard lock(m_mutex);
    --m_running;
    m_quiet.notify_all();
}

Expected<void> SharedLink::holdStation(LinkThread thread)
{
    const std::lock_guard lock(m_mutex);
    if (m_suspended || m_ending)
        return failure(ErrorCode::StorageOpen,
                       {m_options.station, Words::tr("it is needed alone at this moment")});
    m_holds[thread] = true;
    return {};
}

void SharedLink::letStationGo(LinkThread thread)
{
    const std::lock_guard lock(m_mutex);
    m_holds[thread] = false;
    m_quiet.notify_all();
}

void SharedLink::beginStep()
{
    const std::lock_guard lock(m_mutex);
    m_stepBegan = LinkClock::now();
}

void SharedLink::endStep(const ExchangeStep& step)
{
    const std::lock_guard lock(m_mutex);
    m_stepBegan.reset();
    m_known.reached = true;
    m_known.lastReached = QDateTime::currentDateTimeUtc();
    m_known.inStep = step.inStep;
    m_known.problem.reset();
    if (step.there)
        m_delivered = step.there;
    if (step.delivered.waiting == 0)
        m_known.waiting = 0;
    if (step.fetched.rows > 0)
        ++m_known.typesTaken;
    if (step.conflicts)
        m_known.conflicts = *step.conflicts;
}

void SharedLink::endStep(const Error& error, bool reached)
{
    const std::lock_guard lock(m_mutex);
    m_stepBegan.reset();
    if (m_suspended || m_ending)
        return; // it was asked for
    m_known.reached = reached;
    m_known.inStep = false;
    m_known.problem = error;
}

void SharedLink::hangUpWhatIsLate()
{
    {
        const std::lock_guard lock(m_mutex);
        if (!m_stepBegan || LinkClock::now() - *m_stepBegan < m_options.patience)
            return;
    }
    m_hangup->hangUp();
}

void SharedLink::remember(const LinkNote& note)
{
    const std::lock_guard lock(m_mutex);
    if (!m_delivered)
        m_delivered = note.delivered;
    if (!m_known.lastReached.isValid())
        m_known.lastReached = note.lastReached;
}

std::optional<LinkNote> SharedLink::note() const
{
    const std::lock_guard lock(m_mutex);
    if (!m_delivered)
        return {};
    return LinkNote{m_known.server, m_known.lastReached, *m_delivered};
}

void SharedLink::tellWaiting(qint64 inspections)
{
    const std::lock_guard lock(m_mutex);
    m_known.waiting = inspections;
}

} // namespace gripscope
