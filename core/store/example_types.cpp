// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/paper_appendix.h"
#include "core/store/change_table.h"
#include "core/store/grasp_writer.h"
#include "core/store/library_private.h"
#include "core/store/type_table.h"
#include "core/store/type_writer.h"
#include "core/words.h"

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

LibraryChange exampleChange()
{
    LibraryChange change;
    change.kind = ChangeKind::Examples;
    change.squeezes = int(paperSqueezesInSi().size());
    change.operatorName = u"example"_s;
    return change;
}

Expected<void> addExampleType(Database& database, const QString& name, qint64 version)
{
    const auto type = createType(database, {name, Recipe{}, newton, metre}, TypeStatus::Approved, version);
    if (!type)
        return tl::unexpected(type.error());
    const std::vector<TypeSqueeze> squeezes = paperSqueezesInSi();
    for (std::size_t i = 0; i < squeezes.size(); ++i) {
        if (squeezes[i].type != name)
            continue;
        const NewGrasp grasp = exampleGrasp(type->id, squeezes[i], paperAppendix().bestFitPercent[i]);
        if (const auto id = storeGrasp(database, grasp, version); !id)
            return tl::unexpected(id.error());
    }
    return {};
}

} // namespace

Expected<void> Library::loadExampleTypes()
{
    return d->write<void>(Words::tr("add the example types"), [&]() -> Expected<void> {
        QStringList names = paperAppendix().object;
        names.removeDuplicates();
        qint64 version = 0;
        for (const QString& name : std::as_const(names)) {
            const auto present = type_table::findByName(*d->database, name);
            if (!present)
                return tl::unexpected(present.error());
            if (*present)
                continue;
            if (version == 0) {
                if (auto may = requirePermission(*d->database, Permission::ApproveTypes); !may)
                    return may;
                const auto begun = change_table::insert(*d->database, exampleChange());
                if (!begun)
                    return tl::unexpected(begun.error());
                version = *begun;
            }
            if (auto done = addExampleType(*d->database, name, version); !done)
                return done;
        }
        return {};
    });
}

} // namespace gripscope
