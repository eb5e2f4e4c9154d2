// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/commands.h"
#include "app/cli/line/output.h"
#include "app/cli/quality/quality_commands.h"
#include "app/cli/study/study_commands.h"

#include <algorithm>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

struct Study {
    QString name, summary;
    int (*run)(const QStringList& arguments);
};

const std::vector<Study>& studies()
{
    static const std::vector<Study> all{
        {u"efficiency"_qs, u"the estimators' errors against the Cramer-Rao bound, and their intervals"_qs,
         runEfficiencyStudy},
        {u"recognition"_qs, u"the rates a verdict states beside those that are found"_qs,
         runRecognitionStudy},
        {u"early"_qs, u"squeezes that stop as soon as the stated error allows"_qs, runEarlyStudy},
        {u"truth"_qs, u"what is said of parts that rub, yield and bend beside what is so"_qs, runTruthStudy},
        {u"gauge"_qs, u"gauge repeatability and reproducibility of a table"_qs, runGaugeStudy},
        {u"type1"_qs, u"one reference part squeezed many times: Cg, Cgk and bias"_qs, runTypeOneStudy},
        {u"linearity"_qs, u"the bias over several reference parts"_qs, runLinearityStudy},
        {u"attributes"_qs, u"how well verdicts agree, with one another and with a reference"_qs,
         runAttributeStudy},
        {u"capability"_qs, u"a process against limits: Cp, Cpk, Pp, Ppk, Cpm with their intervals"_qs,
         runCapabilityStudy},
        {u"chart"_qs, u"control charts of a table's values: limits, rules, signals, run lengths"_qs,
         runChartStudy},
        {u"guardband"_qs, u"risks and guard bands of limits on parts"_qs, runGuardBandStudy},
    };
    return all;
}

} // namespace

void addStudyOptions(CommandLine& line, int runs)
{
    line.option(u"runs"_qs, u"N"_qs, u"Repetitions of each row."_qs, QString::number(runs));
    line.option(u"seed"_qs, u"N"_qs, u"Seed of everything that is drawn."_qs, u"1"_qs);
    line.option(u"threads"_qs, u"N"_qs,
                u"Threads, 0 for as many as the machine has; no figure depends on it."_qs, u"0"_qs);
}

std::function<void(std::int64_t, std::int64_t)> progressLines()
{
    return [told = std::int64_t(0)](std::int64_t done, std::int64_t total) mutable {
        const std::int64_t twentieths = total > 0 ? 20 * done / total : 20;
        if (twentieths > told)
            message(u"%1 % of %2 runs"_qs.arg(5 * twentieths).arg(total));
        told = std::max(told, twentieths);
    };
}

int runStudy(const QStringList& arguments)
{
    QStringList names, lines;
    for (const Study& study : studies()) {
        names << study.name;
        lines << u"%1: %2"_qs.arg(study.name, study.summary);
    }
    CommandLine line(
        u"study"_qs,
        u"Repeats experiments with known truth, or judges gauges, processes and limits. %1. \"study NAME --help\" tells a study's options."_qs
            .arg(lines.join(u"; "_qs)),
        u"NAME"_qs);
    addStudyOptions(line, 500);
    // The first that is a study's name: a column may be called "truth".
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        const qsizetype study = names.indexOf(arguments[i]);
        if (study < 0)
            continue;
        QStringList others = arguments;
        others.removeAt(i);
        return studies()[std::size_t(study)].run(others);
    }
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    line.reject(u"there is no study \"%1\"; the name of one was expected first: %2."_qs.arg(
        line.files().join(u' '), names.join(u", "_qs)));
    return line.finish().value_or(2);
}

} // namespace gripscope::cli
