// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/history/history_fields.h"
#include "core/library/history/history_view.h"
#include "core/signal/recording/units.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Entry = HistoryEntry;

template <double MassDampingStiffness::*member>
QVariant inSi(const Entry& entry)
{
    if (!entry.parameters)
        return {};
    return (*entry.parameters).*member * siFactor(entry.forceUnit, entry.positionUnit).value_or(1);
}

template <QString Entry::*member>
QVariant textOf(const Entry& entry)
{
    return entry.*member;
}

QVariant numberOr(const std::optional<double>& number)
{
    return number ? QVariant(*number) : QVariant();
}

QString word(const QString& column)
{
    return u"LOWER(NULLIF(%1, ''))"_s.arg(column);
}

QString validityOrderSql()
{
    return u"CASE %1 WHEN 'valid' THEN 0 WHEN 'suspect' THEN 1 WHEN 'invalid' THEN 2 END"_s.arg(
        historyValiditySql());
}

QString conformityOrderSql()
{
    return u"CASE i.conformity WHEN 'conforms' THEN 0 WHEN 'does_not_conform' THEN 1 WHEN "
           "'too_near_the_limit' THEN 2 WHEN 'not_decidable' THEN 3 END"_s;
}

std::vector<HistoryColumnFacts> columnsOfTheVerdict()
{
    return {{HistoryColumn::Number, ColumnFormat::Count, QT_TRANSLATE_NOOP("Words", "Number"),
             [](const Entry& entry) { return entry.number > 0 ? QVariant(entry.numberText()) : QVariant(); },
             u"i.number"_s, HistorySelection::Inspections},
            {HistoryColumn::Time,
             ColumnFormat::Time,
             QT_TRANSLATE_NOOP("Words", "Time"),
             [](const Entry& entry) { return QVariant(entry.time); },
             {}},
            {HistoryColumn::Kind, ColumnFormat::Kind, QT_TRANSLATE_NOOP("Words", "Kind"),
             [](const Entry& entry) { return QVariant(int(entry.kind)); },
             u"CASE WHEN g.type_id IS NULL THEN 0 ELSE 1 END"_s},
            {HistoryColumn::Outcome, ColumnFormat::Outcome, QT_TRANSLATE_NOOP("Words", "Outcome"),
             [](const Entry& entry) {
                 const std::optional<InspectionOutcome> outcome = entry.outcome();
                 return outcome ? QVariant(int(*outcome)) : QVariant();
             },
             historyOutcomeSql(), HistorySelection::Inspections},
            {HistoryColumn::Validity, ColumnFormat::Validity, QT_TRANSLATE_NOOP("Words", "Validity"),
             [](const Entry& entry) {
                 const int place = entry.validity ? int(*entry.validity) : -1;
                 return entry.verdict ? QVariant(place) : QVariant();
             },
             validityOrderSql(), HistorySelection::Inspections},
            {HistoryColumn::Expected, ColumnFormat::Text, QT_TRANSLATE_NOOP("Words", "Expected"),
             textOf<&Entry::expectedType>, word(u"i.expected_type"_s), HistorySelection::Inspections},
            {HistoryColumn::Type, ColumnFormat::Text, QT_TRANSLATE_NOOP("Words", "Type"),
             textOf<&Entry::type>, word(historyTypeSql()),
             HistorySelection::Inspections | HistorySelection::Types},
            {HistoryColumn::Posterior, ColumnFormat::Probability, QT_TRANSLATE_NOOP("Words", "Posterior"),
             [](const Entry& entry) { return numberOr(entry.tellingPosterior()); },
             u"CASE WHEN i.verdict IN ('type', 'inconclusive') THEN i.posterior END"_s,
             HistorySelection::Inspections}};
}

std::vector<HistoryColumnFacts> columnsOfTheEstimate()
{
    return {{HistoryColumn::Mass, ColumnFormat::Quantity, QT_TRANSLATE_NOOP("Words", "Mass m"),
             inSi<&MassDampingStiffness::m>, historySiSql(u"e.m"_s), HistorySelection::Estimates},
            {HistoryColumn::Damping, ColumnFormat::Quantity, QT_TRANSLATE_NOOP("Words", "Damping b"),
             inSi<&MassDampingStiffness::b>, historySiSql(u"e.b"_s), HistorySelection::Estimates},
            {HistoryColumn::Stiffness, ColumnFormat::Quantity, QT_TRANSLATE_NOOP("Words", "Stiffness k"),
             inSi<&MassDampingStiffness::k>, historySiSql(u"e.k"_s), HistorySelection::Estimates},
            {HistoryColumn::Fit, ColumnFormat::Percent, QT_TRANSLATE_NOOP("Words", "Simulation fit"),
             [](const Entry& entry) { return numberOr(entry.simulationFitPercent); },
             u"e.simulation_fit_percent"_s, HistorySelection::Estimates},
            {HistoryColumn::Seconds, ColumnFormat::Seconds, QT_TRANSLATE_NOOP("Words", "Length"),
             [](const Entry& entry) { return numberOr(entry.seconds); }, u"i.seconds"_s,
             HistorySelection::Inspections}};
}

std::vector<HistoryColumnFacts> columnsOfTheRecord()
{
    return {
        {HistoryColumn::Operator, ColumnFormat::Text, QT_TRANSLATE_NOOP("Words", "Operator"),
         textOf<&Entry::operatorName>, word(u"g.operator_name"_s)},
        {HistoryColumn::Device, ColumnFormat::Text, QT_TRANSLATE_NOOP("Words", "Gripper"),
         [](const Entry& entry) { return QVariant(u"%1 %2"_s.arg(entry.device, entry.serial).trimmed()); },
         word(historyDeviceSql())},
        {HistoryColumn::Batch, ColumnFormat::Text, QT_TRANSLATE_NOOP("Words", "Batch"), textOf<&Entry::batch>,
         word(u"o.name"_s), HistorySelection::Batches},
        {HistoryColumn::Estimator, ColumnFormat::Estimator, QT_TRANSLATE_NOOP("Words", "Estimator"),
         textOf<&Entry::estimator>, u"e.estimator"_s, HistorySelection::Estimates},
        {HistoryColumn::Program, ColumnFormat::Text, QT_TRANSLATE_NOOP("Words", "Software"),
         textOf<&Entry::program>, historyProgramSql(),
         HistorySelection::Estimates | HistorySelection::Inspections},
        {HistoryColumn::LibraryVersion, ColumnFormat::Count, QT_TRANSLATE_NOOP("Words", "Library version"),
         [](const Entry& entry) {
             return entry.libraryVersion ? QVariant(*entry.libraryVersion) : QVariant();
         },
         historyVersionSql(), HistorySelection::Inspections},
        {HistoryColumn::Voided, ColumnFormat::Text, QT_TRANSLATE_NOOP("Words", "Voided"),
         textOf<&Entry::voided>, word(historyVoidedSql()), HistorySelection::Inspections},
        {HistoryColumn::Conformity, ColumnFormat::Conformity, QT_TRANSLATE_NOOP("Words", "Tolerance limits"),
         [](const Entry& entry) { return entry.conformity ? QVariant(int(*entry.conformity)) : QVariant(); },
         conformityOrderSql(), HistorySelection::Inspections}};
}

} // namespace

const std::vector<HistoryColumnFacts>& historyColumns()
{
    static const auto columns = [] {
        std::vector<HistoryColumnFacts> all = columnsOfTheVerdict();
        for (const auto& more : {columnsOfTheEstimate(), columnsOfTheRecord()})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return columns;
}

const HistoryColumnFacts& factsOf(HistoryColumn column)
{
    return historyColumns()[std::size_t(column)];
}

} // namespace gripscope
