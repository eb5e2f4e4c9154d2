// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/library_private.h"
#include "core/library/tables/change_table.h"
#include "core/library/tables/grasp_writer.h"
#include "core/library/tables/type_tables.h"
#include "core/library/tables/type_writer.h"
#include "core/recognition/types/paper_appendix.h"

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
    estimate.message = u"From the paper's appendix; the fit is the best fit it prints."_s;
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
    ASSIGN_OR_RETURN(const auto type,
                     createType(database, {name, Recipe{}, newton, metre}, TypeStatus::Approved, version));
    const std::vector<TypeSqueeze> squeezes = paperSqueezesInSi();
    for (std::size_t i = 0; i < squeezes.size(); ++i) {
        if (squeezes[i].type != name)
            continue;
        const NewGrasp grasp = exampleGrasp(type.id, squeezes[i], paperAppendix().bestFitPercent[i]);
        RETURN_IF_ERROR(storeGrasp(database, grasp, version));
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
            ASSIGN_OR_RETURN(const auto present, type_table::findByName(*d->database, name));
            if (present)
                continue;
            if (version == 0) {
                RETURN_IF_ERROR(requirePermission(*d->database, Permission::ApproveTypes));
                ASSIGN_OR_RETURN(const auto begun, change_table::insert(*d->database, exampleChange()));
                version = begun;
            }
            RETURN_IF_ERROR(addExampleType(*d->database, name, version));
        }
        return {};
    });
}

} // namespace gripscope
