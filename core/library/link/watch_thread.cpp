// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/exchange/waiting_count.h"
#include "core/library/link/shared_link.h"
#include "core/library/link/station_hold.h"

namespace gripscope {

namespace {

constexpr qint64 notedEvery_s = 60;

class Watch {
public:
    explicit Watch(SharedLink& state)
        : m_state(state), m_station(state, WatchThread), m_file(linkNoteFile(state.options().station)),
          m_written(readLinkNote(m_file, state.status().server))
    {
        if (m_written)
            state.remember(*m_written);
    }
    void letGo()
    {
        m_station.close();
        m_count = {};
    }
    void count();
    void writeNote(bool atEnd);

private:
    SharedLink& m_state;
    StationHold m_station;
    WaitingCount m_count;
    QString m_file;
    std::optional<LinkNote> m_written;
};

void Watch::count()
{
    const std::optional<LinkNote> note = m_state.note();
    if (!note)
        return;
    const Expected<Library*> station = m_station.open();
    if (!station)
        return;
    if (const Expected<Waiting> waiting = (*station)->countWaiting(m_count, note->delivered))
        m_state.tellWaiting(waiting->inspections);
    else
        letGo();
}

void Watch::writeNote(bool atEnd)
{
    std::optional<LinkNote> note = m_state.note();
    if (!note || note == m_written)
        return;
    const bool moved = !m_written || m_written->delivered != note->delivered;
    if (!moved && !atEnd && m_written->lastReached.secsTo(note->lastReached) < notedEvery_s)
        return;
    if (writeLinkNote(m_file, *note)) // else the next time: it is only told to people
        m_written = std::move(note);
}

} // namespace

void watchUntilEnd(SharedLink& state)
{
    Watch watch(state);
    do {
        state.hangUpWhatIsLate();
        watch.writeNote(false);
        watch.count();
    } while (state.await(state.options().every, [&] { watch.letGo(); }));
    watch.writeNote(true);
    watch.letGo();
    state.noteEnd();
}

} // namespace gripscope
