// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/output.h"
#include "app/cli/quality/quality_commands.h"
#include "core/base/json_value.h"
#include "core/quality/limits/guard_bands.h"

#include <array>
#include <utility>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

constexpr std::array<double, 3> guardRisks{0.05, 0.01, 0.001};

std::optional<double> given(CommandLine& line, const QString& name)
{
    return line.isSet(name) ? std::optional(line.number(name)) : std::nullopt;
}

struct GuardBands {
    double guard = 0;
    GlobalRisks risks;
    std::vector<std::pair<double, std::optional<double>>> forRisk;
};

Expected<GuardBands> findGuardBands(const MeasuredProcess& process, double guard)
{
    GuardBands found;
    found.guard = guard;
    ASSIGN_OR_RETURN(found.risks, globalRisks(process, guard));
    for (const double risk : guardRisks) {
        ASSIGN_OR_RETURN(const std::optional<double> band, guardForRisk(process, risk));
        found.forRisk.emplace_back(risk, band);
    }
    return found;
}

QJsonObject toJson(const GuardBands& found, double uncertainty)
{
    QJsonObject forRisk;
    for (const auto& [risk, band] : found.forRisk)
        forRisk[QString::number(risk)] = jsonNumber(band);
    return {{u"guard"_qs, found.guard},
            {u"consumers_risk"_qs, jsonNumber(found.risks.consumers)},
            {u"producers_risk"_qs, jsonNumber(found.risks.producers)},
            {u"guard_for_risk"_qs, forRisk},
            {u"guard_for_specific_risk"_qs,
             QJsonObject{{u"0.05"_qs, guardForSpecificRisk(uncertainty, 0.05)},
                         {u"0.025"_qs, guardForSpecificRisk(uncertainty, 0.025)}}}};
}

QString text(const GuardBands& found, double uncertainty)
{
    QStringList lines{
        u"With a guard band of %1, %2 % of all parts are accepted though they do not conform (consumer's "
        "risk), and %3 % are rejected though they do (producer's risk)."_qs.arg(found.guard)
            .arg(100 * found.risks.consumers, 0, 'g', 6)
            .arg(100 * found.risks.producers, 0, 'g', 6)};
    for (const auto& [risk, band] : found.forRisk)
        lines
            << (band
                    ? u"Guard band for a consumer's risk of %1 %: %2"_qs.arg(100 * risk).arg(*band, 0, 'g', 6)
                    : u"Guard band for a consumer's risk of %1 %: none is needed, or none is enough"_qs.arg(
                          100 * risk));
    lines << u"Guard band by which a value at the acceptance limit is wrong in 5 % (ISO 14253-1): %1"_qs.arg(
        guardForSpecificRisk(uncertainty, 0.05), 0, 'g', 6);
    return lines.join(u'\n');
}

} // namespace

int runGuardBandStudy(const QStringList& arguments)
{
    CommandLine line(
        u"study guardband"_qs,
        u"How often a measurement with this uncertainty accepts parts that do not conform, and rejects "
        "parts that do (JCGM 106), and by which guard band less often."_qs);
    line.option(u"lower"_qs, u"L"_qs, u"Lower tolerance limit; left out: none."_qs);
    line.option(u"upper"_qs, u"U"_qs, u"Upper tolerance limit; left out: none."_qs);
    line.option(u"process-mean"_qs, u"M"_qs, u"Mean of the parts."_qs);
    line.option(u"process-sigma"_qs, u"S"_qs, u"Standard deviation of the parts."_qs);
    line.option(u"measurement-sigma"_qs, u"U"_qs, u"Standard uncertainty of a measurement."_qs);
    line.option(u"guard"_qs, u"W"_qs,
                u"By how much acceptance limits lie within the tolerance limits; below zero: beyond them."_qs,
                u"0"_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    for (const QString& name : {u"process-mean"_qs, u"process-sigma"_qs, u"measurement-sigma"_qs})
        if (!line.isSet(name))
            line.reject(u"--%1 is missing."_qs.arg(name));
    MeasuredProcess process;
    process.limits = {given(line, u"lower"_qs), given(line, u"upper"_qs)};
    process.mean = given(line, u"process-mean"_qs).value_or(0);
    process.deviation = given(line, u"process-sigma"_qs).value_or(1);
    process.uncertainty = given(line, u"measurement-sigma"_qs).value_or(1);
    const double guard = line.number(u"guard"_qs);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    return showStudy(
        findGuardBands(process, guard), line,
        [&](const auto& found) { return toJson(found, process.uncertainty); },
        [&](const auto& found) { return text(found, process.uncertainty); });
}

} // namespace gripscope::cli
