// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/inspect_session_private.h"

namespace gripscope {

namespace {

constexpr std::chrono::seconds retryEvery{2};

/// The fault is the library's, not the inspection's.
bool mayBeStoredLater(const Error& error)
{
    switch (error.code) {
    case ErrorCode::StorageOpen:
    case ErrorCode::StorageFailed:
    case ErrorCode::StorageNewer:
    case ErrorCode::StorageCorrupt:
        return true;
    default:
        return false;
    }
}

} // namespace

InspectionArchive::~InspectionArchive()
{
    if (m_obstacle || m_waiting.empty())
        return;
    m_waiting.pop_front(); // it is on its way
    for (const Waiting& waiting : m_waiting)
        static_cast<void>(m_library.run<Kept>(
            [inspection = waiting.inspection](Library& library) { return store(library, inspection); }));
}

Expected<InspectionArchive::Standing>
InspectionArchive::standing(Library& library, const Expected<std::optional<BatchRecord>>& batch)
{
    if (!batch)
        return tl::unexpected<Error>(batch.error());
    ASSIGN_OR_RETURN(const InspectionCounts counts, library.inspectionCounts());
    return Standing{counts, *batch};
}

Expected<InspectionArchive::Loaded> InspectionArchive::read(Library& library)
{
    ASSIGN_OR_RETURN(std::vector<TypeRecord> types, library.types());
    ASSIGN_OR_RETURN(const std::vector<TypeSqueeze> squeezes, library.enrolledSqueezes());
    ASSIGN_OR_RETURN(Standing now, standing(library, library.batchUnderWay()));
    ComparableTypes comparable(types, squeezes);
    return Loaded{std::move(types), std::move(comparable), std::move(now)};
}

Expected<InspectionArchive::Kept> InspectionArchive::store(Library& library, const NewInspection& inspection)
{
    ASSIGN_OR_RETURN(const InspectionRecord added, library.addInspection(inspection));
    Expected<std::optional<BatchRecord>> batch = library.batchUnderWay();
    if (batch && *batch && (*batch)->id == inspection.batchId && (*batch)->whole()) {
        ASSIGN_OR_RETURN(const BatchRecord ended,
                         library.endBatch(inspection.batchId, inspection.grasp.operatorName));
        *batch = ended;
    }
    return standing(library, batch).map([&](const Standing& now) { return Kept{added.number, now}; });
}

void InspectionArchive::take(Standing standing, std::uint64_t request)
{
    // The library works in the order of asking, but the answers may be told in another.
    if (request < m_stood)
        return;
    // A batch that is over is no longer under way, and is shown until the next begins.
    if (!standing.batch && m_standing.batch && m_standing.batch->ended)
        standing.batch = std::move(m_standing.batch);
    m_stood = request;
    m_standing = std::move(standing);
}

void InspectionArchive::load(std::function<void(const Expected<void>&)> done)
{
    m_loading = PendingCall(m_library.run<Loaded>(read),
                            [this, request = ++m_requests, done = std::move(done)](Expected<Loaded> answer) {
                                if (!answer)
                                    return done(tl::unexpected<Error>(answer.error()));
                                m_types = std::move(answer->types);
                                m_comparable = std::move(answer->comparable);
                                take(std::move(answer->standing), request);
                                done({});
                            });
}

void InspectionArchive::keep(const NewInspection& inspection,
                             std::function<void(const Expected<qint64>&)> told)
{
    m_waiting.push_back({inspection, std::move(told)});
    if (m_waiting.size() == 1)
        storeFirst();
}

void InspectionArchive::storeFirst()
{
    m_nextTry.reset();
    m_storing = PendingCall(
        m_library.run<Kept>([inspection = m_waiting.front().inspection](Library& library) {
            return store(library, inspection);
        }),
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
    if (kept)
        take(kept->standing, request);
    // Last: whoever hears it may ask for the next.
    told(kept.map([](const Kept& stored) { return stored.number; }));
}

void InspectionArchive::changeBatch(std::function<Expected<BatchRecord>(Library&)> work,
                                    std::function<void(const Expected<void>&)> done)
{
    ++m_changing;
    m_answers.emplace_back(m_library.run<Standing>([work = std::move(work)](Library& library) {
        return standing(library, work(library).map([](const BatchRecord& batch) {
            return std::optional<BatchRecord>(batch);
        }));
    }),
                           [this, request = ++m_requests, done = std::move(done)](Expected<Standing> answer) {
                               --m_changing;
                               if (!answer)
                                   return done(tl::unexpected<Error>(answer.error()));
                               take(std::move(*answer), request);
                               done({});
                           });
}

void InspectionArchive::beginBatch(const NewBatch& batch, std::function<void(const Expected<void>&)> done)
{
    changeBatch([batch](Library& library) { return library.beginBatch(batch); }, std::move(done));
}

void InspectionArchive::endBatch(const QString& operatorName, std::function<void(const Expected<void>&)> done)
{
    if (m_standing.batch && !m_standing.batch->ended)
        changeBatch([id = m_standing.batch->id,
                     operatorName](Library& library) { return library.endBatch(id, operatorName); },
                    std::move(done));
}

bool InspectionArchive::poll()
{
    bool changed = m_loading.poll();
    while (!m_answers.empty() && m_answers.front().poll()) {
        m_answers.pop_front();
        changed = true;
    }
    if (m_storing.poll()) {
        changed = true;
        if (!m_nextTry && !m_waiting.empty() && !m_storing.waiting())
            storeFirst();
    } else if (m_nextTry && m_clock() >= *m_nextTry) {
        storeFirst();
    }
    return changed;
}

} // namespace gripscope
