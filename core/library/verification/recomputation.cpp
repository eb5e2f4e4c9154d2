// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/identification/identification.h"
#include "core/library/records/enrollment_draft.h"
#include "core/library/tables/draft_tables.h"
#include "core/library/tables/grasp_table.h"
#include "core/library/tables/recording_table.h"
#include "core/library/verification/library_checks.h"
#include "core/library/verification/library_verification.h"
#include "core/recognition/verdict/identified_squeeze.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct Place {
    QString row, graspId;
};

QString recomputing()
{
    return Words::tr("be worked out again");
}

Expected<std::vector<Place>> placesOf(Database& database, const QString& sql)
{
    std::vector<Place> places;
    Statement query(database, recomputing(), sql);
    const auto done = query.forEach([&](Statement& row) {
        Place place;
        place.row = row.takeText();
        place.graspId = row.takeText();
        places.push_back(std::move(place));
    });
    if (!done)
        return tl::unexpected(done.error());
    return places;
}

/// Whether the new number is within a standard error of the stored one, or the same to rounding.
bool agrees(double stored, double again, double variance)
{
    constexpr double rounding = 1e-6;
    return std::abs(again - stored) <=
           std::max(std::sqrt(std::max(variance, 0.0)), rounding * std::abs(stored));
}

/// What is determined both then and now is the same; what is hardly known may be on one side alone.
bool agree(const DeterminedQuantities& then, const DeterminedQuantities& now)
{
    for (int i = 0; i < then.space.dimensions(); ++i) {
        const std::optional<int> place =
            now.space.placeOf(then.space.quantities[static_cast<std::size_t>(i)]);
        if (place && !agrees(then.log[i], now.log[*place], then.covariance ? (*then.covariance)(i, i) : 0))
            return false;
    }
    return true;
}

/// Nothing where the stored estimate follows from the recording, or there is none to compare.
std::optional<QString> problemOf(const GraspRecord& stored, const Recording& recording)
{
    const bool isLinear = stored.parameters && stored.covariance;
    if (!isLinear && !stored.determined)
        return {};
    const Identification identification = identify(recording);
    if (stored.determined) {
        const auto now = determinedQuantities(identification, stored.forceUnit, stored.positionUnit);
        if (now && !agree(*stored.determined, *now))
            return Words::tr("what it determines is not what its recording does");
    }
    if (!isLinear)
        return {};
    const std::optional<CorrectedParameters> again = identification.object();
    if (!again)
        return Words::tr("its m, b and k cannot be found in its recording");
    const MassDampingStiffness& then = *stored.parameters;
    const MassDampingStiffness& now = again->parameters;
    const Eigen::Matrix3d& covariance = *stored.covariance;
    const bool same = agrees(then.m, now.m, covariance(0, 0)) && agrees(then.b, now.b, covariance(1, 1)) &&
                      agrees(then.k, now.k, covariance(2, 2));
    return same ? std::nullopt : std::optional(Words::tr("its m, b and k are not those of its recording"));
}

void recomputeSqueeze(Database& database, const Place& place, LibraryVerification& found)
{
    const auto recording = recording_table::read(database, place.graspId);
    if (!recording)
        return found.differs(u"recordings"_s, place.row, recording.error().describe());
    const auto stored = grasp_table::find(database, place.graspId);
    if (!stored || !*stored)
        return; // told already
    if (const auto problem = problemOf(**stored, *recording))
        found.differs(u"estimates"_s, place.graspId, *problem);
}

template <typename Check>
void forEachPlace(Database& database, LibraryVerification& found, const QString& table, const QString& sql,
                  const Check& check)
{
    const auto places = placesOf(database, sql);
    if (!places)
        return found.differs(table, {}, places.error().describe());
    for (const Place& place : *places)
        check(place);
}

} // namespace

void recompute(Database& database, LibraryVerification& found)
{
    forEachPlace(database, found, u"recordings"_s, u"SELECT id, grasp_id FROM recordings ORDER BY id"_s,
                 [&](const Place& place) { recomputeSqueeze(database, place, found); });
    forEachPlace(database, found, u"draft_squeezes"_s, u"SELECT id, id FROM draft_squeezes ORDER BY id"_s,
                 [&](const Place& place) {
                     if (const auto read = draft_squeeze_table::read(database, place.row); !read)
                         found.differs(u"draft_squeezes"_s, place.row, read.error().describe());
                 });
    forEachPlace(database, found, u"pictures"_s, u"SELECT id, id FROM pictures ORDER BY id"_s,
                 [&](const Place& place) {
                     if (const auto read = picture_table::read(database, place.row); !read)
                         found.differs(u"pictures"_s, place.row, read.error().describe());
                 });
}

} // namespace gripscope
