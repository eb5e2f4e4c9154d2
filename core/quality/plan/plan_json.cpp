// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/plan/plan_json.h"

#include "core/base/words.h"

#include <QJsonArray>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QStringList labelsFromJson(const QJsonValue& value)
{
    QStringList labels;
    for (const QJsonValue label : value.toArray())
        labels << label.toString();
    return labels;
}

Error badPlan(const QString& found, const Finding& expected)
{
    return Error{ErrorCode::BadInput, {Words::say("The plan of a study"), found, expected}};
}

std::optional<PlanRow> planRowFromJson(const QJsonArray& numbers, const PlanDesign& design)
{
    const auto placeIn = [](const QJsonValue& value, qsizetype size) {
        const int place = value.toInt(-1);
        return place >= 0 && place < std::max<qsizetype>(1, size) ? place : -1;
    };
    const PlanRow row{placeIn(numbers.at(0), design.parts.size()),
                      placeIn(numbers.at(1), design.operators.size()),
                      placeIn(numbers.at(2), design.stations.size()), placeIn(numbers.at(3), design.trials)};
    const bool whole = numbers.size() == 4 && row.part >= 0 && row.operators >= 0 && row.station >= 0;
    return whole && row.trial >= 0 ? std::optional(row) : std::nullopt;
}

Expected<PlanDesign> designFromJson(const QJsonObject& json)
{
    const auto kind = studyKindFromString(json[u"kind"].toString());
    const auto order = planOrderFromString(json[u"order"].toString());
    const auto quantity = studyQuantityFromString(json[u"quantity"].toString());
    bool isNumber = false;
    const std::uint64_t seed = json[u"seed"].toString().toULongLong(&isNumber);
    if (!kind || !order || !quantity || !isNumber)
        return tl::unexpected<Error>(
            badPlan(json[u"kind"].toString(), Words::say("kind, order, quantity and seed of a study")));
    PlanDesign design;
    design.kind = *kind;
    design.order = *order;
    design.quantity = *quantity;
    design.seed = seed;
    design.parts = labelsFromJson(json[u"parts"]);
    design.operators = labelsFromJson(json[u"operators"]);
    design.stations = labelsFromJson(json[u"stations"]);
    design.references = labelsFromJson(json[u"references"]);
    design.trials = json[u"trials"].toInt();
    design.blind = json[u"blind"].toBool(true);
    if (const auto problem = designProblem(design))
        return tl::unexpected<Error>(*problem);
    return design;
}

} // namespace

QJsonObject planJson(const StudyPlan& plan)
{
    const PlanDesign& design = plan.design;
    QJsonArray rows;
    for (const PlanRow& row : plan.rows)
        rows.append(QJsonArray{row.part, row.operators, row.station, row.trial});
    return {{u"kind"_s, toString(design.kind)},
            {u"order"_s, toString(design.order)},
            {u"quantity"_s, toString(design.quantity)},
            {u"seed"_s, QString::number(design.seed)}, // 64 bits, which a number of JSON does not hold
            {u"parts"_s, QJsonArray::fromStringList(design.parts)},
            {u"operators"_s, QJsonArray::fromStringList(design.operators)},
            {u"stations"_s, QJsonArray::fromStringList(design.stations)},
            {u"references"_s, QJsonArray::fromStringList(design.references)},
            {u"trials"_s, design.trials},
            {u"blind"_s, design.blind},
            {u"rows"_s, rows}};
}

Expected<StudyPlan> planFromJson(const QJsonObject& json)
{
    StudyPlan plan;
    ASSIGN_OR_RETURN(plan.design, designFromJson(json));
    const QJsonArray rows = json[u"rows"].toArray();
    if (rows.isEmpty() || std::size_t(rows.size()) > mostPlanRows)
        return tl::unexpected<Error>(
            badPlan(u"%1 rows"_s.arg(rows.size()), Words::say("1 to %1 rows").arg(int(mostPlanRows))));
    for (const QJsonValue row : rows) {
        const std::optional<PlanRow> read = planRowFromJson(row.toArray(), plan.design);
        if (!read)
            return tl::unexpected<Error>(badPlan(u"row %1"_s.arg(plan.rows.size() + 1),
                                                 Words::say("places in the lists of the plan")));
        plan.rows.push_back(*read);
    }
    return plan;
}

} // namespace gripscope
