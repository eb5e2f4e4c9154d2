// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/history/history_fields.h"

#include "core/base/csv.h"
#include "core/base/json_value.h"
#include "core/library/history/history_view.h"
#include "core/library/tables/estimate_tables.h"
#include "core/library/tables/inspection_tables.h"
#include "core/quality/conformity/conformity_json.h"
#include "core/signal/recording/units.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

#include <algorithm>
#include <array>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Entry = HistoryEntry;

QString exactTime(const QDateTime& time)
{
    return time.toString(Qt::ISODateWithMs); // with its offset; empty where it is not valid
}

QString exactUtc(const Entry& entry)
{
    return exactTime(entry.time.toUTC());
}

/// The times that cannot be taken at their word, as ISO 8601 writes an interval.
QString setBackText(const Entry& entry)
{
    const auto& step = entry.clockSetBack;
    return step ? exactTime(step->to.toUTC()) + u'/' + exactTime(step->from.toUTC()) : QString();
}

QJsonValue byName(const std::optional<Eigen::Vector3d>& values)
{
    if (!values)
        return {};
    return QJsonObject{{u"m"_s, jsonNumber((*values)(0))},
                       {u"b"_s, jsonNumber((*values)(1))},
                       {u"k"_s, jsonNumber((*values)(2))}};
}

/// m, b and k with their errors and units, where there are any.
QStringList parameterCells(const Entry& entry)
{
    const ParameterUnits units = parameterUnits(entry.forceUnit, entry.positionUnit);
    const std::array<QString, 3> names{units.m, units.b, units.k};
    QStringList cells;
    for (int i = 0; i < 3; ++i) {
        const auto at = [i](const auto& values) {
            return values ? std::optional((*values)(i)) : std::optional<double>();
        };
        const auto vector = entry.parameters ? std::optional(entry.parameters->vector()) : std::nullopt;
        cells << exactText(at(vector)) << exactText(at(entry.standardErrors))
              << (vector ? names[std::size_t(i)] : QString());
    }
    return cells;
}

QJsonValue unitsByName(const Entry& entry)
{
    const ParameterUnits units = parameterUnits(entry.forceUnit, entry.positionUnit);
    return QJsonObject{{u"m"_s, units.m}, {u"b"_s, units.b}, {u"k"_s, units.k}};
}

template <QString Entry::*member>
HistoryField textField(const char* name, const QString& sql)
{
    return {name,
            name,
            sql,
            [](Statement& row, Entry& entry) { entry.*member = row.takeText(); },
            [](const Entry& entry) { return QStringList{entry.*member}; },
            [](const Entry& entry) { return jsonText(entry.*member); }};
}

/// `csv`: empty for what is in JSON alone.
template <std::optional<double> Entry::*member>
HistoryField numberField(const char* name, const char* csv, const QString& sql)
{
    return {name,
            csv,
            sql,
            [](Statement& row, Entry& entry) { entry.*member = row.takeOptionalReal(); },
            [](const Entry& entry) { return QStringList{exactText(entry.*member)}; },
            [](const Entry& entry) { return jsonNumber(entry.*member); }};
}

HistoryField numberOfInspection()
{
    return {"number",
            "number",
            u"COALESCE(i.number, 0)"_s,
            [](Statement& row, Entry& entry) { entry.number = row.takeInteger(); },
            [](const Entry& entry) {
                return QStringList{entry.number > 0 ? QString::number(entry.number) : QString()};
            },
            [](const Entry& entry) { return entry.number > 0 ? QJsonValue(entry.number) : QJsonValue(); }};
}

/// `number` is of this library; what was merged into it has one there, too.
HistoryField numberAtItsStation()
{
    return {"number_there",
            "number_there",
            inspection_table::numberThereSql(u"i.id"_s),
            [](Statement& row, Entry& entry) { entry.numberThere = row.takeInteger(); },
            [](const Entry& entry) {
                return QStringList{entry.numberThere > 0 ? QString::number(entry.numberThere) : QString()};
            },
            [](const Entry& entry) {
                return entry.numberThere > 0 ? QJsonValue(entry.numberThere) : QJsonValue();
            }};
}

HistoryField kindOfSqueeze()
{
    return {"kind",
            "kind",
            u"CASE WHEN g.type_id IS NULL THEN 0 ELSE 1 END"_s,
            [](Statement& row, Entry& entry) {
                entry.kind = row.takeInteger() != 0 ? SqueezeKind::Enrollment : SqueezeKind::Inspection;
            },
            [](const Entry& entry) { return QStringList{toString(entry.kind)}; },
            [](const Entry& entry) { return QJsonValue(toString(entry.kind)); }};
}

HistoryField verdictOfInspection()
{
    return {
        "verdict",
        "verdict",
        u"COALESCE(i.verdict, '')"_s,
        [](Statement& row, Entry& entry) { entry.verdict = verdictKindFromString(row.takeText()); },
        [](const Entry& entry) { return QStringList{entry.verdict ? toString(*entry.verdict) : QString()}; },
        [](const Entry& entry) {
            return entry.verdict ? QJsonValue(toString(*entry.verdict)) : QJsonValue();
        }};
}

std::vector<HistoryField> fieldsOfTheVerdict()
{
    return {numberOfInspection(),
            {"time_utc", "time_utc", u"g.recorded_utc"_s,
             [](Statement& row, Entry& entry) { entry.time = row.takeUtc(); },
             [](const Entry& entry) { return QStringList{exactUtc(entry)}; },
             [](const Entry& entry) { return QJsonValue(exactUtc(entry)); }},
            kindOfSqueeze(),
            textField<&Entry::expectedType>("expected", u"COALESCE(i.expected_type, '')"_s),
            {"outcome",
             "outcome",
             {},
             nullptr,
             [](const Entry& entry) { return QStringList{entry.outcomeName()}; },
             [](const Entry& entry) { return jsonText(entry.outcomeName()); }},
            verdictOfInspection(),
            textField<&Entry::type>("type", historyTypeSql()),
            textField<&Entry::nearest>("nearest", u"COALESCE(i.nearest, '')"_s),
            numberField<&Entry::posterior>("posterior", "posterior", u"i.posterior"_s),
            numberField<&Entry::distance>("distance", "", u"i.distance"_s),
            numberField<&Entry::gate>("gate", "", u"i.gate"_s)};
}

std::vector<HistoryField> fieldsOfTheEstimate()
{
    return {
        {"units", "", u"g.force_unit, g.position_unit"_s,
         [](Statement& row, Entry& entry) {
             entry.forceUnit = row.takeText();
             entry.positionUnit = row.takeText();
         },
         nullptr, unitsByName},
        {"parameters", "m,m_standard_error,m_unit,b,b_standard_error,b_unit,k,k_standard_error,k_unit",
         u"e.m, e.b, e.k"_s,
         [](Statement& row, Entry& entry) { entry.parameters = estimate_table::takeParameters(row); },
         parameterCells,
         [](const Entry& entry) {
             return byName(entry.parameters ? std::optional(entry.parameters->vector()) : std::nullopt);
         }},
        {"standard_errors", "", u"e.var_m, e.var_b, e.var_k"_s,
         [](Statement& row, Entry& entry) { entry.standardErrors = estimate_table::takeStandardErrors(row); },
         nullptr, [](const Entry& entry) { return byName(entry.standardErrors); }},
        numberField<&Entry::simulationFitPercent>("simulation_fit_percent", "simulation_fit_percent",
                                                  u"e.simulation_fit_percent"_s),
        numberField<&Entry::seconds>("squeeze_s", "squeeze_s", u"i.seconds"_s)};
}

std::vector<HistoryField> fieldsOfTheRecord()
{
    return {
        textField<&Entry::operatorName>("operator", u"g.operator_name"_s),
        textField<&Entry::device>("device", u"g.device_name"_s),
        textField<&Entry::serial>("serial", u"g.device_serial"_s),
        textField<&Entry::firmware>("firmware", u"g.firmware"_s),
        textField<&Entry::source>("source", u"g.source"_s),
        textField<&Entry::part>("part", u"g.part"_s),
        {"accepted", "accepted", u"COALESCE(p.accepted, 1)"_s,
         [](Statement& row, Entry& entry) { entry.accepted = row.takeInteger() != 0; },
         [](const Entry& entry) { return QStringList{entry.accepted ? u"yes"_s : u"no"_s}; },
         [](const Entry& entry) { return QJsonValue(entry.accepted); }},
        textField<&Entry::estimator>("estimator", u"COALESCE(e.estimator, '')"_s),
        textField<&Entry::program>("software", historyProgramSql()),
        textField<&Entry::graspId>("key", u"g.id"_s),
        {"reason", "reason", u"COALESCE(i.reasons, '[]')"_s,
         [](Statement& row, Entry& entry) { entry.reason = inspection_table::joinReasons(row.takeText()); },
         [](const Entry& entry) { return QStringList{entry.reason.describe()}; },
         [](const Entry& entry) { return jsonText(entry.reason.describe()); }},
        textField<&Entry::batch>("batch", u"COALESCE(o.name, '')"_s),
        textField<&Entry::partNumber>("part_number", u"COALESCE(i.part_number, '')"_s),
        textField<&Entry::voided>("voided", historyVoidedSql())};
}

QString validityText(const Entry& entry)
{
    return entry.validity ? toString(*entry.validity) : QString();
}

template <std::optional<double> HeldTo::*member>
HistoryField rateField(const char* name, const QString& sql)
{
    return {name,
            name,
            sql,
            [](Statement& row, Entry& entry) { entry.heldTo.*member = row.takeOptionalReal(); },
            [](const Entry& entry) { return QStringList{exactText(entry.heldTo.*member)}; },
            [](const Entry& entry) { return jsonNumber(entry.heldTo.*member); }};
}

/// "none" where the channel was corrected by none; empty where that was not recorded.
QString calibrationText(const std::optional<QString>& words)
{
    return words && words->isEmpty() ? u"none"_s : words.value_or(QString());
}

template <std::optional<QString> Entry::*member>
HistoryField calibrationField(const char* name, const QString& sql)
{
    return {name,
            name,
            sql,
            [](Statement& row, Entry& entry) { entry.*member = row.takeOptionalText(); },
            [](const Entry& entry) { return QStringList{calibrationText(entry.*member)}; },
            [](const Entry& entry) { return jsonText(calibrationText(entry.*member)); }};
}

HistoryField robustField()
{
    return {"robust",
            "robust",
            u"i.robust"_s,
            [](Statement& row, Entry& entry) {
                if (const std::optional<qint64> robust = row.takeOptionalInteger())
                    entry.heldTo.robust = *robust != 0;
            },
            [](const Entry& entry) {
                const std::optional<bool>& robust = entry.heldTo.robust;
                return QStringList{!robust ? QString() : *robust ? u"yes"_s : u"no"_s};
            },
            [](const Entry& entry) {
                return entry.heldTo.robust ? QJsonValue(*entry.heldTo.robust) : QJsonValue();
            }};
}

HistoryField versionField()
{
    return {"library_version",
            "library_version",
            historyVersionSql(),
            [](Statement& row, Entry& entry) { entry.libraryVersion = row.takeOptionalInteger(); },
            [](const Entry& entry) {
                return QStringList{entry.libraryVersion ? QString::number(*entry.libraryVersion) : QString()};
            },
            [](const Entry& entry) {
                return entry.libraryVersion ? QJsonValue(*entry.libraryVersion) : QJsonValue();
            }};
}

/// The worst specific risk of its quantities.
std::optional<double> conformityRisk(const Entry& entry)
{
    std::optional<double> worst;
    if (entry.conformityValues)
        for (const std::optional<QuantityConformity>& quantity : entry.conformityValues->quantities)
            if (quantity && quantity->risk)
                worst = std::max(worst.value_or(0), *quantity->risk);
    return worst;
}

void takeConformity(Statement& row, Entry& entry)
{
    entry.conformity = conformityDecisionFromString(row.takeText());
    entry.conformityValues = conformityFromJson(QJsonDocument::fromJson(row.takeText().toUtf8()).object());
}

HistoryField conformityField()
{
    return {"conformity",
            "conformity,conformity_risk",
            u"COALESCE(i.conformity, ''), COALESCE(i.conformity_values, '')"_s,
            takeConformity,
            [](const Entry& entry) {
                return QStringList{entry.conformity ? toString(*entry.conformity) : QString(),
                                   exactText(conformityRisk(entry))};
            },
            [](const Entry& entry) {
                return entry.conformityValues ? QJsonValue(conformityJson(*entry.conformityValues))
                                              : QJsonValue();
            }};
}

/// What the measurement was worth, and what was in force then.
std::vector<HistoryField> fieldsOfThatTime()
{
    return {
        {"validity", "validity", historyValiditySql(),
         [](Statement& row, Entry& entry) { entry.validity = validityVerdictFromString(row.takeText()); },
         [](const Entry& entry) { return QStringList{validityText(entry)}; },
         [](const Entry& entry) { return jsonText(validityText(entry)); }},
        {"checks_failed", "checks_failed", u"COALESCE(i.checks_failed, '')"_s,
         [](Statement& row, Entry& entry) {
             entry.checksFailed = row.takeText().split(u' ', Qt::SkipEmptyParts);
         },
         [](const Entry& entry) { return QStringList{entry.checksFailed.join(u' ')}; },
         [](const Entry& entry) { return QJsonValue(QJsonArray::fromStringList(entry.checksFailed)); }},
        rateField<&HeldTo::falseReject>("false_reject_rate", u"i.false_reject"_s),
        rateField<&HeldTo::wrongType>("wrong_type_rate", u"i.wrong_type"_s),
        rateField<&HeldTo::strangerAccept>("stranger_accept_rate", u"i.stranger_accept"_s),
        rateField<&HeldTo::confidence>("confidence", u"i.confidence"_s),
        robustField(),
        versionField(),
        calibrationField<&Entry::forceCalibration>("force_calibration", u"g.force_calibration"_s),
        textField<&Entry::forceCalibrationId>("force_calibration_id", u"g.force_calibration_id"_s),
        calibrationField<&Entry::positionCalibration>("position_calibration", u"g.position_calibration"_s),
        textField<&Entry::positionCalibrationId>("position_calibration_id", u"g.position_calibration_id"_s),
        textField<&Entry::station>("station", u"g.station"_s),
        {"time_local", "time_local", u"g.utc_offset_s"_s,
         [](Statement& row, Entry& entry) { entry.utcOffset_s = row.takeOptionalInteger(); },
         [](const Entry& entry) { return QStringList{exactTime(entry.timeThere())}; },
         [](const Entry& entry) { return jsonText(exactTime(entry.timeThere())); }},
        {"clock_set_back",
         "clock_set_back",
         {},
         nullptr, // history_view::entries() knows
         [](const Entry& entry) { return QStringList{setBackText(entry)}; },
         [](const Entry& entry) { return jsonText(setBackText(entry)); }},
        conformityField(),
        numberAtItsStation()};
}

} // namespace

const std::vector<HistoryField>& historyFields()
{
    // What came later stands behind: whoever reads the CSV counts on the order.
    static const auto fields = [] {
        std::vector<HistoryField> all = fieldsOfTheVerdict();
        for (const auto& more : {fieldsOfTheEstimate(), fieldsOfTheRecord(), fieldsOfThatTime()})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return fields;
}

} // namespace gripscope
