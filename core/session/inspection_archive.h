// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/comparable_units.h"
#include "core/session/library_answer.h"
#include "core/store/batch.h"
#include "core/store/library_service.h"

#include <functional>
#include <list>

namespace gripscope {

/// What inspections read from the library and write into it, on the library's thread while the owner polls:
/// the types, the counts, and the batch that inspections belong to.
class InspectionArchive {
public:
    explicit InspectionArchive(LibraryService& library) : m_library(library) {}

    /// Reads all of it again.
    void load(std::function<void(const Expected<void>&)> done);
    /// Stores an inspection, and ends its batch when that is whole by it; gives the inspection's number.
    void keep(const NewInspection& inspection, std::function<void(const Expected<qint64>&)> done);
    void beginBatch(const NewBatch& batch, std::function<void(const Expected<void>&)> done);
    void endBatch(const QString& operatorName, std::function<void(const Expected<void>&)> done);
    bool poll();                                                        ///< true when an answer came
    [[nodiscard]] bool storing() const { return m_keeping > 0; }        ///< an inspection is on its way
    [[nodiscard]] bool changingBatch() const { return m_changing > 0; } ///< its begin or end is on its way

    [[nodiscard]] const std::vector<TypeRecord>& types() const { return m_types; }
    [[nodiscard]] const ComparableTypes& comparable() const { return m_comparable; }
    [[nodiscard]] const InspectionCounts& counts() const { return m_standing.counts; }
    /// The one under way here, or the one that was ended last, until the next begins.
    [[nodiscard]] const std::optional<BatchRecord>& batch() const { return m_standing.batch; }

private:
    /// How things stand after a request.
    struct Standing {
        InspectionCounts counts;
        std::optional<BatchRecord> batch;
    };
    struct Loaded {
        std::vector<TypeRecord> types;
        ComparableTypes comparable;
        Standing standing;
    };
    struct Kept {
        qint64 number = 0;
        Standing standing;
    };
    [[nodiscard]] static Expected<Loaded> read(Library& library);
    [[nodiscard]] static Expected<Kept> store(Library& library, const NewInspection& inspection);
    [[nodiscard]] static Expected<Standing> standing(Library& library,
                                                     const Expected<std::optional<BatchRecord>>& batch);
    void changeBatch(std::function<Expected<BatchRecord>(Library&)> work,
                     std::function<void(const Expected<void>&)> done);
    void take(Standing standing, std::uint64_t request);

    LibraryService& m_library;
    LibraryAnswer m_loading;
    std::list<LibraryAnswer> m_answers; ///< in the order in which they were asked for
    int m_keeping = 0, m_changing = 0;
    std::vector<TypeRecord> m_types;
    ComparableTypes m_comparable;
    Standing m_standing;
    std::uint64_t m_requests = 0, m_stood = 0; ///< the number of the last, and of the one m_standing is from
};

} // namespace gripscope
