// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/inspect_session_private.h"

namespace gripscope {

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
                             std::function<void(const Expected<qint64>&)> done)
{
    ++m_keeping;
    m_answers.emplace_back(
        m_library.run<Kept>([inspection](Library& library) { return store(library, inspection); }),
        [this, request = ++m_requests, done = std::move(done)](Expected<Kept> kept) {
            --m_keeping;
            if (!kept)
                return done(tl::unexpected<Error>(kept.error()));
            take(std::move(kept->standing), request);
            done(kept->number);
        });
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
    return changed;
}

} // namespace gripscope
