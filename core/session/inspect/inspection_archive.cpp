// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/inspect_session_private.h"

#include <algorithm>

namespace gripscope {

InspectionArchive::~InspectionArchive()
{
    for (const Waiting& waiting : m_waiting)
        if (waiting.spilled == Spilled::NotYet)
            static_cast<void>(m_spill->add(waiting.inspection)); // done before the file is closed
    if (m_obstacle)
        return;
    if (m_storing.waiting())
        m_waiting.pop_front(); // it is on its way
    for (const Waiting& waiting : m_waiting)
        static_cast<void>(m_library.run<Kept>(storing(waiting)));
}

Expected<InspectionArchive::Standing>
InspectionArchive::standing(Library& library, const Expected<std::optional<BatchRecord>>& batch, qint64 after)
{
    if (!batch)
        return tl::unexpected<Error>(batch.error());
    ASSIGN_OR_RETURN(const InspectionCounts counts, library.inspectionCounts());
    if (after <= 0)
        return Standing{counts, counts, *batch};
    ASSIGN_OR_RETURN(const InspectionCounts shift, library.inspectionCounts(after));
    return Standing{counts, shift, *batch};
}

Expected<InspectionArchive::Loaded> InspectionArchive::read(Library& library, qint64 after)
{
    ASSIGN_OR_RETURN(const qint64 version, library.version());
    ASSIGN_OR_RETURN(std::vector<TypeRecord> types, library.types());
    ASSIGN_OR_RETURN(const std::vector<TypeSqueeze> squeezes, library.approvedSqueezes());
    ASSIGN_OR_RETURN(std::vector<AdjustmentStanding> adjustments, library.adjustmentsInForce());
    ASSIGN_OR_RETURN(const qint64 versionNow, library.version());
    if (versionNow != version)
        return read(library, after); // somebody changed the types meanwhile
    ASSIGN_OR_RETURN(Standing now, standing(library, library.batchUnderWay(), after));
    ComparableTypes comparable(types, squeezes);
    return Loaded{std::move(types), std::move(comparable), std::move(now), version, std::move(adjustments)};
}

Expected<InspectionArchive::Kept> InspectionArchive::store(Library& library, const NewInspection& inspection,
                                                           qint64 after)
{
    ASSIGN_OR_RETURN(const InspectionRecord added, library.addInspection(inspection));
    Expected<std::optional<BatchRecord>> batch = library.batchUnderWay();
    if (batch && *batch && (*batch)->id == inspection.batchId && (*batch)->whole()) {
        ASSIGN_OR_RETURN(const BatchRecord ended,
                         library.endBatch(inspection.batchId, inspection.grasp.operatorName));
        *batch = ended;
    }
    return standing(library, batch, after).map([&](const Standing& now) { return Kept{added.number, now}; });
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

const AdjustmentStanding* InspectionArchive::adjustmentOf(const QString& gripperSerial) const
{
    const auto found =
        std::ranges::find(m_adjustments, gripperSerial, [](const AdjustmentStanding& standing) {
            return standing.record.adjustment.gripperSerial;
        });
    return found == m_adjustments.end() ? nullptr : &*found;
}

void InspectionArchive::load(std::function<void(const Expected<void>&)> done)
{
    m_loading = PendingCall(
        m_library.run<Loaded>([after = m_shiftStart](Library& library) { return read(library, after); }),
        [this, request = ++m_requests, done = std::move(done)](Expected<Loaded> answer) {
            if (!answer)
                return done(tl::unexpected<Error>(answer.error()));
            m_types = std::move(answer->types);
            m_comparable = std::move(answer->comparable);
            m_version = answer->version;
            m_adjustments = std::move(answer->adjustments);
            take(std::move(answer->standing), request);
            done({});
        });
}

bool InspectionArchive::poll()
{
    bool changed = m_loading.poll();
    changed = m_openingSpill.poll() || changed;
    changed = m_spilling.poll() || changed;
    while (!m_answers.empty() && m_answers.front().poll()) {
        m_answers.pop_front();
        changed = true;
    }
    changed = m_storing.poll() || changed;
    if (m_nextTry && m_clock() >= *m_nextTry)
        m_nextTry.reset();
    if (m_nextSpillTry && m_clock() >= *m_nextSpillTry)
        tryToOpenSpill();
    storeNext();
    return changed;
}

void InspectionArchive::changeBatch(std::function<Expected<BatchRecord>(Library&)> work,
                                    std::function<void(const Expected<void>&)> done)
{
    change(
        [work = std::move(work)](Library& library) {
            return work(library).map(
                [](const BatchRecord& batch) { return std::optional<BatchRecord>(batch); });
        },
        std::move(done));
}

void InspectionArchive::voidInspection(qint64 number, const QString& reason, const QString& operatorName,
                                       std::function<void(const Expected<void>&)> done)
{
    change(
        [number, reason, operatorName,
         shown = m_standing.batch](Library& library) -> Expected<std::optional<BatchRecord>> {
            RETURN_IF_ERROR(library.voidInspection(number, reason, operatorName));
            ASSIGN_OR_RETURN(auto batch, library.batchUnderWay());
            if (batch || !shown)
                return batch;
            return library.batch(shown->id); // one that ended may have one less now
        },
        std::move(done));
}

void InspectionArchive::setShiftStart(qint64 after)
{
    if (after == m_shiftStart)
        return;
    m_shiftStart = after;
    change([](Library& library) { return library.batchUnderWay(); }, [](const Expected<void>&) {});
}

void InspectionArchive::change(std::function<Expected<std::optional<BatchRecord>>(Library&)> work,
                               std::function<void(const Expected<void>&)> done)
{
    ++m_changing;
    m_answers.emplace_back(
        m_library.run<Standing>([work = std::move(work), after = m_shiftStart](Library& library) {
            return standing(library, work(library), after);
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

} // namespace gripscope
