// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/draft_table.h"

#include "core/store/recipe_columns.h"
#include "core/store/rows.h"
#include "core/words.h"

#include <array>

namespace gripscope::draft_table {

using namespace Qt::StringLiterals;

namespace {

const auto kept = u"type_name, step, recipe_name, peak_n, bias_n, bit_s, seconds, max_force_n, "
                  "max_travel_m, part, picture_id, pending_id, remark"_s;

struct StepName {
    EnrollmentDraft::Step step;
    const char16_t* name;
};
constexpr std::array<StepName, 3> stepNames{{{EnrollmentDraft::Step::Recipe, u"recipe"},
                                             {EnrollmentDraft::Step::Squeeze, u"squeeze"},
                                             {EnrollmentDraft::Step::Review, u"review"}}};

QString toString(EnrollmentDraft::Step step)
{
    for (const StepName& known : stepNames)
        if (known.step == step)
            return QString::fromUtf16(known.name);
    return {};
}

EnrollmentDraft::Step stepFromString(const QString& text)
{
    for (const StepName& known : stepNames)
        if (QString::fromUtf16(known.name) == text)
            return known.step;
    return EnrollmentDraft::Step::Recipe; // the earliest asks for the least to be there
}

EnrollmentDraft take(Statement& row)
{
    EnrollmentDraft draft;
    draft.name = row.takeText();
    draft.step = stepFromString(row.takeText());
    draft.recipe = takeRecipe(row);
    draft.part = row.takeText();
    draft.pictureId = row.takeText();
    draft.pendingId = row.takeText();
    draft.remark = row.takeText();
    draft.operatorName = row.takeText();
    draft.changed = row.takeUtc();
    return draft;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const EnrollmentDraft& draft)
{
    Statement row(
        database, Words::tr("store the enrolment under way"),
        u"INSERT INTO enrollment_drafts (id, station, created_utc, state, "_s + kept +
            u", operator_name) VALUES (?, ?, ?, 'open', ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(draft.name).bind(toString(draft.step));
    bindRecipe(row, draft.recipe);
    row.bind(draft.part);
    row.bindOrNull(draft.pictureId).bindOrNull(draft.pendingId).bind(draft.remark);
    return row.bind(draft.operatorName).run();
}

Expected<void> end(Database& database, const RowStamp& stamp, const QString& name, DraftEnd end,
                   const QString& operatorName)
{
    Statement row(database, Words::tr("store the enrolment under way"),
                  u"INSERT INTO enrollment_drafts (id, station, created_utc, state, "_s + kept +
                      u", operator_name) SELECT ?, ?, ?, ?, "_s + kept +
                      u", ? FROM enrollment_drafts d WHERE d.state = 'open' AND d.id = "
                      "(SELECT MAX(o.id) FROM enrollment_drafts o WHERE o.type_name = ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc);
    row.bind(end == DraftEnd::Approved ? u"approved"_s : u"discarded"_s);
    return row.bind(operatorName).bind(name).run();
}

Expected<std::vector<EnrollmentDraft>> open(Database& database, const QString& name)
{
    Statement query(database, Words::tr("read the enrolments under way"),
                    u"SELECT "_s + kept +
                        u", operator_name, created_utc FROM enrollment_drafts d "
                        "WHERE d.state = 'open' AND ? IN ('', d.type_name) AND d.id = "
                        "(SELECT MAX(o.id) FROM enrollment_drafts o WHERE o.type_name = d.type_name) "
                        "ORDER BY d.id DESC"_s);
    return allRows(query.bind(name), take);
}

} // namespace gripscope::draft_table
