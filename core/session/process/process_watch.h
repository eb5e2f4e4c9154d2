// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library_service.h"

#include <optional>

namespace gripscope {

/// What the charts of a type say of its newest inspection, where somebody has fixed their limits: nothing is
/// told by limits that come from the values themselves. The kind of chart and its rules are those that the
/// limits were fixed on; subgroups are counted from the inspection after those that the limits come from.
/// Errors as ProcessReader has them.
[[nodiscard]] Expected<std::optional<Finding>> processSignalOf(Library& library, const QString& type);

/// Asks that after each inspection that is stored, on the library's thread.
class ProcessWatch {
public:
    /// So many inspections are looked back at: enough for every rule, and for the sums of slow shifts.
    static constexpr int newest = 2000;

    explicit ProcessWatch(LibraryService& library) : m_library(library) {}
    /// Of this type something was stored, or voided. Empty: of none, and nothing is to be said.
    void look(const QString& type);
    bool poll(); ///< true when there is something new
    [[nodiscard]] const std::optional<Finding>& signal() const { return m_signal; }

private:
    LibraryService& m_library;
    PendingCall m_looking;
    std::optional<Finding> m_signal;
    std::optional<QString> m_next; ///< asked for while it was looking
};

} // namespace gripscope
