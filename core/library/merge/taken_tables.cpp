// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/merge/row_taker.h"

#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

std::span<const TakenTable> takenTables()
{
    using enum TakenTable::Kind;
    const QString version = u"version"_s, libraryVersion = u"library_version"_s;
    static const std::vector<TakenTable> tables{
        {u"types"_s},
        {u"type_versions"_s, Taken, {}, version},
        {u"library_changes"_s, Taken, {}, version},
        {u"type_states"_s, Taken, version},
        {u"pictures"_s},
        {u"type_pictures"_s},
        {u"batches"_s},
        {u"batch_ends"_s},
        {u"draft_squeezes"_s},
        {u"grasps"_s, Taken, libraryVersion},
        {u"placements"_s, Taken, version},
        {u"recordings"_s},
        {u"documents"_s},
        {u"estimates"_s},
        {u"reidentifications"_s},
        {u"determined_quantities"_s},
        {u"inspections"_s, Taken, libraryVersion, u"number"_s},
        {u"inspection_voids"_s},
        {u"measuring_chains"_s},
        {u"calibrations"_s},
        {u"reference_objects"_s},
        {u"reference_checks"_s},
        {u"studies"_s},
        {u"study_ends"_s},
        {u"study_measurements"_s},
        {u"study_undos"_s},
        {u"process_limits"_s},
        {u"gripper_adjustments"_s, Taken, libraryVersion},
        {u"adjustment_ends"_s},
        // Who may sign in, what is under way and what is counted is a station's own, and so is its trail.
        {u"people"_s, ForTheRecord},
        {u"sign_in_tries"_s, ForTheRecord},
        {u"policies"_s, ForTheRecord},
        {u"audit_entries"_s, ForTheRecord},
        {u"enrollment_drafts"_s, ForTheRecord},
        {u"inspection_tallies"_s, ForTheRecord},
        {u"schema_migrations"_s, ForTheRecord},
        {u"library_meetings"_s, ForTheRecord},
        {u"conflicts_seen"_s, ForTheRecord},
    };
    return tables;
}

} // namespace gripscope
