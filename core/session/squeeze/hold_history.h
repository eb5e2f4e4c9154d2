// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <vector>

namespace gripscope {

/// What the squeezes so far say about the force hold, for each gripper (the recording's `serial`; recordings
/// without one count as one gripper) and each declaration of hold, lag and the lag's uncertainty. A recording
/// that comes again, as it was, is the same squeeze and counts once.
class HoldHistory {
public:
    /// What goes into IdentificationOptions::earlierHold for `recording`.
    [[nodiscard]] HoldEvidence before(const Recording& recording, const IdentificationOptions& options) const;
    /// Counts a squeeze, unless its measurement is invalid.
    void add(const Recording& recording, const Identification& identification);

private:
    struct Entry {
        QString serial;
        std::size_t fingerprint = 0; ///< of the samples
        HoldEvidence evidence;
    };
    std::vector<Entry> m_entries;
};

} // namespace gripscope
