// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library_service.h"
#include "core/quality/drift.h"

#include <deque>
#include <optional>

namespace gripscope {

/// Holds the newest inspected squeezes against the enrolment of their types while parts are inspected
/// (findDrift(), in the thread pool); those that were recognised, so that another part is no news of the type
/// that was expected. What the library has is read once; each squeeze that is inspected joins
/// it. One look at a time; what comes meanwhile is looked at next.
class DriftWatch {
public:
    /// So many inspections are looked back at: enough for the charts of some types.
    static constexpr int newest = 400;

    explicit DriftWatch(LibraryService& library) : m_library(library) {}

    /// The types are these from now on; the squeezes are those of the library.
    void load(const TypeModels& models);
    /// One more, in the models' units. Before load() was answered it is among those of the library, or the
    /// next load()'s.
    void add(const TypeSqueeze& squeeze);
    bool poll(); ///< true when there is something new
    /// Of the last look; nothing before the first.
    [[nodiscard]] const std::optional<DriftReport>& report() const { return m_report; }

private:
    void look();

    LibraryService& m_library;
    TypeModels m_models;
    std::deque<TypeSqueeze> m_squeezes; ///< oldest first
    PendingCall m_loading, m_looking;
    bool m_isNew = false; ///< something was not looked at yet
    std::optional<DriftReport> m_report;
};

} // namespace gripscope
