// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/output.h"
#include "app/cli/quality/quality_commands.h"
#include "core/quality/bias/bias_json.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QString typeOneRow(const QString& name, std::optional<double> value,
                   const std::optional<TwoSidedInterval>& interval)
{
    const auto number = [](double one) { return QString::number(one, 'g', 6); };
    return u"%1 %2  %3"_qs.arg(name, -14)
        .arg(value ? number(*value) : u"-"_qs, 12)
        .arg(interval ? u"%1 to %2"_qs.arg(number(interval->lower), number(interval->upper)) : u"-"_qs);
}

QString text(const TypeOneStudy& study, const TypeOneOptions& options)
{
    QStringList lines{u"%1 readings, mean %2; reference %3, tolerance %4"_qs.arg(study.count)
                          .arg(QString::number(study.mean, 'g', 8),
                               QString::number(options.reference, 'g', 8),
                               QString::number(options.tolerance, 'g', 8)),
                      u"%1 %2  %3"_qs.arg(u""_qs, -14).arg(u"value"_qs, 12).arg(u"95 % interval"_qs),
                      typeOneRow(u"bias"_qs, study.bias, study.biasInterval),
                      typeOneRow(u"repeatability"_qs, study.repeatability, study.repeatabilityInterval),
                      typeOneRow(u"Cg"_qs, study.cg, study.cgInterval),
                      typeOneRow(u"Cgk"_qs, study.cgk, study.cgkInterval)};
    if (study.t && study.p)
        lines << u"no bias: t %1, p %2"_qs.arg(QString::number(*study.t, 'g', 5),
                                               QString::number(*study.p, 'g', 3));
    if (study.step)
        lines << u"smallest step: %1 (%2 % of the tolerance)"_qs.arg(QString::number(*study.step, 'g', 4),
                                                                     fixed(study.stepPercent, 2));
    lines << described(study.messages);
    return lines.join(u'\n');
}

void addTypeOneOptions(CommandLine& line)
{
    line.option(u"value"_qs, u"COL"_qs, u"Column with the readings."_qs);
    line.option(u"reference"_qs, u"R"_qs, u"What the part is, by a better instrument."_qs);
    line.option(u"tolerance"_qs, u"T"_qs, u"From the lower to the upper limit of the product."_qs);
    line.option(u"share"_qs, u"PERCENT"_qs, u"Of the tolerance that the gripper may take."_qs, u"20"_qs);
    line.option(u"sigmas"_qs, u"N"_qs, u"Standard deviations that are its spread."_qs, u"6"_qs);
    line.option(u"minimum"_qs, u"C"_qs, u"Of Cg and Cgk."_qs, u"1.33"_qs);
}

TypeOneOptions readTypeOneOptions(CommandLine& line)
{
    for (const QString& name : {u"value"_qs, u"reference"_qs, u"tolerance"_qs})
        if (line.text(name).isEmpty())
            line.reject(u"--%1 is missing."_qs.arg(name));
    TypeOneOptions options;
    options.reference = line.number(u"reference"_qs);
    options.tolerance = line.number(u"tolerance"_qs, CommandLine::Range::Positive);
    options.sharePercent = line.number(u"share"_qs, CommandLine::Range::Positive);
    options.sigmas = line.number(u"sigmas"_qs, CommandLine::Range::Positive);
    options.minimum = line.number(u"minimum"_qs, CommandLine::Range::Positive);
    return options;
}

Expected<TypeOneStudy> typeOneOf(const CommandLine& line, const TypeOneOptions& options)
{
    ASSIGN_OR_RETURN(const StudyTable table, studyTable(line));
    ASSIGN_OR_RETURN(const std::vector<double> readings, table.numbers(line.text(u"value"_qs)));
    return studyTypeOne(readings, options);
}

} // namespace

int runTypeOneStudy(const QStringList& arguments)
{
    CommandLine line(
        u"study type1"_qs,
        u"One reference part squeezed many times: does the gripper scatter little, and read right, "
        "beside the tolerance? Cg = share T / (sigmas s), Cgk = (share T / 2 - |bias|) / (sigmas s "
        "/ 2)."_qs,
        u"[TABLE.csv]"_qs);
    addTableOptions(line);
    addTypeOneOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const TypeOneOptions options = readTypeOneOptions(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    return showStudy(
        typeOneOf(line, options), line, [](const TypeOneStudy& study) { return toJson(study); },
        [&options](const TypeOneStudy& study) { return text(study, options); });
}

} // namespace gripscope::cli
