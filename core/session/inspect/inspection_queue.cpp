// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/session/inspect/inspect_session_private.h"

#include <algorithm>
#include <utility>

// Of InspectionArchive: inspections on their way into the spill file, then into the library.

namespace gripscope {

namespace {

constexpr std::chrono::seconds retryEvery{2};

/// The fault is the library's, not the inspection's.
bool mayBeStoredLater(const Error& error)
{
    switch (error.code) {
    case ErrorCode::StorageOpen:
    case ErrorCode::StorageFailed:
    case ErrorCode::StorageUnknown:
    case ErrorCode::StorageNewer:
    case ErrorCode::StorageCorrupt:
        return true;
    default:
        return false;
    }
}

} // namespace

void InspectionArchive::openSpill(std::function<void()> done, std::function<void(const Error&)> lost)
{
    m_spillAsked = true;
    m_spillOpened = std::move(done);
    m_lost = std::move(lost);
    tryToOpenSpill();
}

void InspectionArchive::tryToOpenSpill()
{
    m_nextSpillTry.reset();
    using Opened = InspectionSpill::Opened;
    auto asked = m_library.run<Opened>([spill = m_spill](Library& library) -> Expected<Opened> {
        ASSIGN_OR_RETURN(const std::optional<ChainEnd> birth, library.birth());
        return spill->open(library.file(), birth);
    });
    m_openingSpill =
        PendingCall(std::move(asked), [this](Expected<Opened> opened) { takeOpened(std::move(opened)); });
}

void InspectionArchive::takeOpened(Expected<InspectionSpill::Opened> opened)
{
    m_spillProblem.reset();
    if (!opened) {
        m_spillProblem = opened.error();
        m_nextSpillTry = m_clock() + retryEvery;
    } else {
        goOnWith(std::move(opened->waiting));
        if (opened->lost)
            m_lost(*opened->lost);
    }
    if (m_spillOpened)
        std::exchange(m_spillOpened, nullptr)();
}

void InspectionArchive::goOnWith(std::vector<SpilledInspection> earlier)
{
    const auto told = [this](const Expected<qint64>& number) {
        if (!number)
            m_lost(number.error());
    };
    // Before all others, but for the one that is being stored.
    auto place = m_waiting.begin() + (m_storing.waiting() ? 1 : 0);
    for (SpilledInspection& before : earlier) {
        place =
            m_waiting.insert(place, {std::move(before.inspection), told, Spilled::Yes, before.place, true});
        ++place;
    }
}

bool InspectionArchive::spillKnown() const
{
    return m_spillAsked && (m_spillProblem || !m_openingSpill.waiting());
}

Expected<void> InspectionArchive::roomForOneMore() const
{
    if (!spillKnown())
        return failure(ErrorCode::Usage, {Words::say("The library is still being read.")});
    if (m_spillProblem)
        return failure(ErrorCode::Usage,
                       {Words::say("There is no safe place for an inspection that cannot be "
                                   "stored at once, so nothing is squeezed. %1")
                            .arg(m_spillProblem->describe())});
    const bool full = m_waiting.size() >= InspectSession::mostUnstored && m_obstacle;
    if (full || !m_spill->hasRoom())
        return failure(ErrorCode::Usage,
                       {Words::say("%1 inspections are not stored yet, and no more can be kept. %2")
                            .arg(m_waiting.size())
                            .arg(m_obstacle ? m_obstacle->describe() : QString())});
    return {};
}

std::size_t InspectionArchive::spilled() const
{
    return static_cast<std::size_t>(std::count_if(
        m_waiting.begin(), m_waiting.end(), [](const Waiting& w) { return w.spilled == Spilled::Yes; }));
}

void InspectionArchive::keep(const NewInspection& inspection,
                             std::function<void(const Expected<qint64>&)> told)
{
    m_waiting.push_back({inspection, std::move(told)});
    spillNext();
}

void InspectionArchive::spillNext()
{
    if (m_spilling.waiting())
        return;
    const auto next = std::find_if(m_waiting.begin(), m_waiting.end(),
                                   [](const Waiting& w) { return w.spilled == Spilled::NotYet; });
    if (next == m_waiting.end())
        return;
    next->spilled = Spilled::OnItsWay;
    m_spilling = PendingCall(
        m_spill->add(next->inspection),
        [this, id = next->inspection.id](const Expected<qint64>& place) { takeSpilled(id, place); });
}

void InspectionArchive::takeSpilled(const QString& id, const Expected<qint64>& place)
{
    const auto which = std::find_if(m_waiting.begin(), m_waiting.end(),
                                    [&id](const Waiting& w) { return w.inspection.id == id; });
    if (which != m_waiting.end()) {
        which->spilled = place ? Spilled::Yes : Spilled::Cannot;
        which->place = place.value_or(0);
    }
    // What no library would take either is for the library to refuse.
    if (!place && place.error().code == ErrorCode::FileUnwritable)
        m_spillProblem = place.error();
    spillNext();
    storeNext();
}

Expected<InspectionArchive::Kept> InspectionArchive::storeWaiting(Library& library, InspectionSpill& spill,
                                                                  const Waiting& waiting, qint64 after)
{
    NewInspection inspection = waiting.inspection;
    if (waiting.fromBefore) {
        ASSIGN_OR_RETURN(inspection, library.withKnownBatch(std::move(inspection)));
    }
    Expected<Kept> kept = store(library, inspection, after);
    if (!kept && mayBeStoredLater(kept.error()))
        return kept;
    if (!kept && waiting.fromBefore) { // nobody is there any more who could squeeze the part again
        ASSIGN_OR_RETURN(const auto birth, library.birth());
        ASSIGN_OR_RETURN(const QString file, InspectionSpill::keepAside(library.file(), birth, inspection));
        kept =
            failure(ErrorCode::Usage,
                    {Words::say("An inspection that waited to be stored was refused, and is kept in %2. %1")
                         .arg(kept.error().describe(), file)});
    }
    if (waiting.spilled == Spilled::Yes)
        spill.remove(waiting.place);
    return kept;
}

std::function<Expected<InspectionArchive::Kept>(Library&)>
InspectionArchive::storing(const Waiting& waiting) const
{
    return [spill = m_spill, waiting, after = m_shiftStart](Library& library) {
        return storeWaiting(library, *spill, waiting, after);
    };
}

void InspectionArchive::storeNext()
{
    const bool safe = !m_waiting.empty() && (m_waiting.front().spilled == Spilled::Yes ||
                                             m_waiting.front().spilled == Spilled::Cannot);
    if (!safe || m_storing.waiting() || m_nextTry)
        return;
    m_storing = PendingCall(
        m_library.run<Kept>(storing(m_waiting.front())),
        [this, request = ++m_requests](const Expected<Kept>& kept) { takeStored(kept, request); });
}

void InspectionArchive::takeStored(const Expected<Kept>& kept, std::uint64_t request)
{
    if (!kept && mayBeStoredLater(kept.error())) {
        m_nextTry = m_clock() + retryEvery;
        m_obstacle = kept.error();
        return;
    }
    const auto told = std::move(m_waiting.front().told);
    m_waiting.pop_front();
    m_obstacle.reset();
    if (m_waiting.empty() && m_spill->isOpen())
        m_spillProblem.reset(); // there is room again
    if (kept)
        take(kept->standing, request);
    // Last: whoever hears it may ask for the next.
    told(kept.map([](const Kept& stored) { return stored.number; }));
}

} // namespace gripscope
