// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/output.h"
#include "app/cli/quality/quality_commands.h"
#include "core/quality/bias/bias_json.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QString linearityNumber(std::optional<double> value, int digits = 5)
{
    return value ? QString::number(*value, 'g', digits) : u"-"_qs;
}

QString coefficientRow(const QString& name, double value, std::optional<double> t, std::optional<double> p)
{
    return u"%1 %2 %3 %4"_qs.arg(name, -10)
        .arg(linearityNumber(value, 7), 12)
        .arg(linearityNumber(t, 6), 10)
        .arg(linearityNumber(p, 3), 10);
}

QString biasRow(const QString& name, const ReferenceBias& bias)
{
    return u"%1 %2 %3 %4 %5 %6  %7"_qs.arg(name, -10)
        .arg(bias.count, 6)
        .arg(linearityNumber(bias.bias), 12)
        .arg(linearityNumber(bias.deviation), 10)
        .arg(linearityNumber(bias.t), 10)
        .arg(linearityNumber(bias.p, 3), 10)
        .arg(bias.band
                 ? u"%1 to %2"_qs.arg(linearityNumber(bias.band->lower), linearityNumber(bias.band->upper))
                 : u"-"_qs);
}

QString text(const LinearityStudy& study)
{
    QStringList lines{
        u"bias = intercept + slope reference, %1 readings"_qs.arg(study.count),
        u"%1 %2 %3 %4"_qs.arg(u""_qs, -10).arg(u"value"_qs, 12).arg(u"t"_qs, 10).arg(u"p"_qs, 10),
        coefficientRow(u"intercept"_qs, study.intercept, study.tIntercept, study.pIntercept),
        coefficientRow(u"slope"_qs, study.slope, study.tSlope, study.pSlope),
        u"s %1, R^2 %2, linearity %3 %"_qs.arg(linearityNumber(study.residualDeviation, 7),
                                               fixed(study.rSquared, 4),
                                               QString::number(study.percentLinearity, 'f', 2)),
        u"%1 %2 %3 %4 %5 %6  %7"_qs.arg(u"reference"_qs, -10)
            .arg(u"n"_qs, 6)
            .arg(u"bias"_qs, 12)
            .arg(u"s"_qs, 10)
            .arg(u"t"_qs, 10)
            .arg(u"p"_qs, 10)
            .arg(u"95 % band of the line"_qs)};
    for (const ReferenceBias& bias : study.references)
        lines << biasRow(linearityNumber(bias.reference, 6), bias);
    lines << biasRow(u"all"_qs, study.average);
    if (study.lackOfFit)
        lines << u"lack of fit: F %1, p %2"_qs.arg(linearityNumber(study.lackOfFit->f),
                                                   linearityNumber(study.lackOfFit->p, 3));
    lines << described(study.messages);
    return lines.join(u'\n');
}

LinearityOptions readLinearityOptions(CommandLine& line)
{
    for (const QString& name : {u"value"_qs, u"reference"_qs})
        if (line.text(name).isEmpty())
            line.reject(u"--%1 is missing: it names a column."_qs.arg(name));
    LinearityOptions options;
    if (line.isSet(u"process-variation"_qs))
        options.processVariation = line.number(u"process-variation"_qs, CommandLine::Range::Positive);
    options.deviation = static_cast<BiasDeviation>(line.choice(u"deviation"_qs, {u"own"_qs, u"pooled"_qs}));
    return options;
}

Expected<LinearityStudy> linearityOf(const CommandLine& line, const LinearityOptions& options)
{
    ASSIGN_OR_RETURN(const StudyTable table, studyTable(line));
    ASSIGN_OR_RETURN(const std::vector<double> references, table.numbers(line.text(u"reference"_qs)));
    ASSIGN_OR_RETURN(const std::vector<double> values, table.numbers(line.text(u"value"_qs)));
    return studyLinearity(references, values, options);
}

} // namespace

int runLinearityStudy(const QStringList& arguments)
{
    CommandLine line(u"study linearity"_qs,
                     u"Several reference parts squeezed many times: does the bias change over the range?"_qs,
                     u"[TABLE.csv]"_qs);
    addTableOptions(line);
    line.option(u"reference"_qs, u"COL"_qs, u"Column with what each part is."_qs);
    line.option(u"value"_qs, u"COL"_qs, u"Column with the readings."_qs);
    line.option(u"process-variation"_qs, u"S"_qs,
                u"Six standard deviations of the process, in the readings' unit."_qs);
    line.option(
        u"deviation"_qs, u"KIND"_qs,
        u"What the test at each reference rests on: own (its own scatter) or pooled (that within all)."_qs,
        u"own"_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const LinearityOptions options = readLinearityOptions(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    return showStudy(
        linearityOf(line, options), line, [](const LinearityStudy& study) { return toJson(study); },
        [](const LinearityStudy& study) { return text(study); });
}

} // namespace gripscope::cli
