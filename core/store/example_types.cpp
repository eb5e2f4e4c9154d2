// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/paper_appendix.h"
#include "core/store/approval_table.h"
#include "core/store/grasp_writer.h"
#include "core/store/library_private.h"
#include "core/store/type_table.h"
#include "core/store/type_writer.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const auto newton = u"N"_s;
const auto metre = u"m"_s;

NewGrasp exampleGrasp(const QString& typeId, const TypeSqueeze& squeeze, double bestFitPercent)
{
    Estimate estimate;
    estimate.estimator = Estimator::Arx; // what the paper used
    estimate.status = EstimateStatus::Converged;
    estimate.message = "From the paper's appendix; the fit is the best fit it prints.";
    estimate.parameters = squeeze.parameters;
    estimate.fit.simulationPercent = bestFitPercent;
    NewGrasp grasp;
    grasp.typeId = typeId;
    grasp.estimates = {estimate};
    grasp.forceUnit = newton;
    grasp.positionUnit = metre;
    grasp.source = u"paper appendix, scaled to SI (1 time unit = 3.2 ms)"_s;
    return grasp;
}

Expected<void> addExampleType(Database& database, const QString& name)
{
    const auto type = createType(database, {name, Recipe{}, newton, metre});
    if (!type)
        return tl::unexpected(type.error());
    const std::vector<TypeSqueeze> squeezes = paperSqueezesInSi();
    for (std::size_t i = 0; i < squeezes.size(); ++i) {
        if (squeezes[i].type != name)
            continue;
        const NewGrasp grasp = exampleGrasp(type->id, squeezes[i], paperAppendix().bestFitPercent[i]);
        if (const auto id = storeGrasp(database, grasp); !id)
            return tl::unexpected(id.error());
    }
    return approval_table::insert(database, RowStamp::now(), type->id, u"example"_s);
}

} // namespace

Expected<void> Library::loadExampleTypes()
{
    return d->write<void>(u"add the example types"_s, [&]() -> Expected<void> {
        QStringList names = paperAppendix().object;
        names.removeDuplicates();
        for (const QString& name : std::as_const(names)) {
            const auto present = type_table::findByName(*d->database, name);
            if (!present)
                return tl::unexpected(present.error());
            if (*present)
                continue;
            if (auto done = addExampleType(*d->database, name); !done)
                return done;
        }
        return {};
    });
}

} // namespace gripscope
