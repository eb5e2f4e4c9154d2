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

NewGrasp exampleGrasp(const TypeSqueeze& squeeze, double bestFitPercent)
{
    Estimate estimate;
    estimate.estimator = Estimator::Arx; // what the paper used
    estimate.status = EstimateStatus::Converged;
    estimate.message = u"From the paper's appendix; the fit is the best fit it prints."_s;
    estimate.parameters = squeeze.parameters;
    estimate.fit.simulationPercent = bestFitPercent;
    NewGrasp grasp;
    grasp.estimates = {estimate};
    grasp.forceUnit = newton;
    grasp.positionUnit = metre;
    grasp.source = u"paper appendix, scaled to SI (1 time unit = 3.2 ms)"_s;
    return grasp;
}

std::vector<ExampleType> paperExamples()
{
    std::vector<ExampleType> examples;
    const std::vector<TypeSqueeze> squeezes = paperSqueezesInSi();
    QStringList names = paperAppendix().object;
    names.removeDuplicates();
    for (const QString& name : std::as_const(names)) {
        ExampleType example{name, Recipe{}, newton, metre, {}};
        for (std::size_t i = 0; i < squeezes.size(); ++i)
            if (squeezes[i].type == name)
                example.squeezes.push_back(exampleGrasp(squeezes[i], paperAppendix().bestFitPercent[i]));
        examples.push_back(std::move(example));
    }
    return examples;
}

LibraryChange exampleChange(const std::vector<ExampleType>& examples)
{
    LibraryChange change;
    change.kind = ChangeKind::Examples;
    for (const ExampleType& example : examples)
        change.squeezes += int(example.squeezes.size());
    change.operatorName = u"example"_s;
    return change;
}

Expected<void> addExampleType(Database& database, const ExampleType& example, qint64 version)
{
    ASSIGN_OR_RETURN(const auto type,
                     createType(database,
                                {example.name, example.recipe, example.forceUnit, example.positionUnit},
                                TypeStatus::Approved, version));
    for (NewGrasp grasp : example.squeezes) {
        grasp.typeId = type.id;
        RETURN_IF_ERROR(storeGrasp(database, grasp, version));
    }
    return {};
}

} // namespace

Expected<void> Library::loadExampleTypes()
{
    return loadExampleTypes(paperExamples());
}

Expected<void> Library::loadExampleTypes(const std::vector<ExampleType>& examples)
{
    return d->write<void>(Words::tr("add the example types"), [&]() -> Expected<void> {
        std::vector<ExampleType> missing;
        for (const ExampleType& example : examples) {
            ASSIGN_OR_RETURN(const auto present, type_table::findByName(*d->database, example.name));
            if (!present)
                missing.push_back(example);
        }
        if (missing.empty())
            return {};
        RETURN_IF_ERROR(requirePermission(*d->database, Permission::ApproveTypes));
        ASSIGN_OR_RETURN(const auto version, change_table::insert(*d->database, exampleChange(missing)));
        for (const ExampleType& example : missing)
            RETURN_IF_ERROR(addExampleType(*d->database, example, version));
        return {};
    });
}

} // namespace gripscope
