// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/ledgered_tables.h"

#include <algorithm>
#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

std::span<const LedgeredTable> ledgeredTables()
{
    static const std::vector<LedgeredTable> tables{
        {1, u"schema_migrations"_s, u"version"_s},
        {2, u"types"_s, u"id"_s},
        {3, u"type_versions"_s, u"id"_s},
        {4, u"type_states"_s, u"id"_s},
        {5, u"type_pictures"_s, u"id"_s},
        {6, u"library_changes"_s, u"id"_s},
        {7, u"placements"_s, u"id"_s},
        {8, u"grasps"_s, u"id"_s},
        {9, u"recordings"_s, u"id"_s},
        {10, u"documents"_s, u"id"_s},
        {11, u"estimates"_s, u"id"_s},
        {12, u"reidentifications"_s, u"id"_s},
        {13, u"inspections"_s, u"id"_s},
        {14, u"batches"_s, u"id"_s},
        {15, u"batch_ends"_s, u"id"_s},
        {16, u"measuring_chains"_s, u"id"_s},
        {17, u"calibrations"_s, u"id"_s},
        {18, u"reference_objects"_s, u"id"_s},
        {19, u"reference_checks"_s, u"id"_s},
        {20, u"enrollment_drafts"_s, u"id"_s},
        {21, u"draft_squeezes"_s, u"id"_s},
        {22, u"pictures"_s, u"id"_s},
        {23, u"people"_s, u"id"_s},
        {24, u"sign_in_tries"_s, u"id"_s},
        {25, u"policies"_s, u"id"_s},
        {26, u"audit_entries"_s, u"number"_s},
        {31, u"inspection_voids"_s, u"id"_s},
        {32, u"determined_quantities"_s, u"id"_s},
        {40, u"inspection_tallies"_s, u"id"_s},
        {50, u"studies"_s, u"id"_s},
        {51, u"study_ends"_s, u"id"_s},
        {52, u"study_measurements"_s, u"id"_s},
        {53, u"study_undos"_s, u"id"_s},
        {54, u"process_limits"_s, u"id"_s},
        {60, u"gripper_adjustments"_s, u"id"_s},
        {61, u"adjustment_ends"_s, u"id"_s},
        {70, u"library_meetings"_s, u"id"_s},
        {71, u"conflicts_seen"_s, u"id"_s},
    };
    return tables;
}

const LedgeredTable* ledgeredTable(const QString& name)
{
    const auto tables = ledgeredTables();
    const auto found = std::ranges::find(tables, name, &LedgeredTable::name);
    return found == tables.end() ? nullptr : &*found;
}

const LedgeredTable* ledgeredTable(quint8 code)
{
    const auto tables = ledgeredTables();
    const auto found = std::ranges::find(tables, code, &LedgeredTable::code);
    return found == tables.end() ? nullptr : &*found;
}

} // namespace gripscope
