// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/command_line.h"
#include "app/cli/line/output.h"
#include "app/cli/study/study_commands.h"
#include "core/research/early_decision_study.h"
#include "core/research/study_json.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QString rowText(const EarlyDecisionStudy& row)
{
    return u"%1 %2 %3 %4 %5 %6 %7 %8"_qs.arg(row.setting.name(), -16)
        .arg(row.decided, 8)
        .arg(row.wrong, 6)
        .arg(row.decided > 0 ? fixed(100.0 * row.wrong / row.decided, 2) : u"-"_qs, 8)
        .arg(fixed(row.meanSamples, 1), 8)
        .arg(fixed(row.ninetyPercentSamples, 0), 8)
        .arg(row.equalFixedLength ? QString::number(*row.equalFixedLength) : u"-"_qs, 8)
        .arg(fixed(row.saving, 2), 8);
}

QString text(const std::vector<EarlyDecisionStudy>& rows, const EarlyDecisionStudyOptions& options)
{
    QStringList lines{
        u"Squeezes stopped as soon as a posterior leaves less than the stated error of %1 %; %2 of each "
        "setting, %3 % strangers among them. \"equal\": the fixed length that is wrong as seldom."_qs
            .arg(100 * options.statedError)
            .arg(options.runs)
            .arg(100 * options.strangerShare),
        u"%1  decided  wrong  wrong %     mean     90 %    equal   saving"_qs.arg(u"setting"_qs, -16)};
    for (const EarlyDecisionStudy& row : rows)
        lines << rowText(row);
    return lines.join(u'\n');
}

EarlyDecisionStudyOptions readEarlyOptions(CommandLine& line)
{
    EarlyDecisionStudyOptions options;
    readStudyOptions(line, options);
    options.statedError = line.number(u"stated-error"_qs, CommandLine::Range::Positive);
    options.strangerShare = line.number(u"strangers"_qs, CommandLine::Range::Positive);
    for (const auto& [name, value] : {std::pair(u"stated-error"_qs, options.statedError),
                                      std::pair(u"strangers"_qs, options.strangerShare)})
        if (value > 0.5)
            line.reject(u"--%1 is %2; a share of at most 0.5 was expected."_qs.arg(name).arg(value));
    return options;
}

} // namespace

int runEarlyStudy(const QStringList& arguments)
{
    CommandLine line(
        u"study early"_qs,
        u"Decides squeezes of known objects as early as the stated error allows: how often that is "
        "wrong, and how many samples it saves."_qs);
    addStudyOptions(line, 500);
    line.option(u"stated-error"_qs, u"SHARE"_qs, u"Of the squeezes decided, wrong at the most."_qs,
                u"0.01"_qs);
    line.option(u"strangers"_qs, u"SHARE"_qs, u"Of strangers among the objects."_qs, u"0.1"_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    EarlyDecisionStudyOptions options = readEarlyOptions(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    std::vector<EarlyDecisionStudy> rows;
    for (const EarlyDecisionSetting& setting : earlyDecisionSettings()) {
        options.setting = setting;
        message(setting.name());
        rows.push_back(studyEarlyDecisions(options));
    }
    if (line.isSet(u"json"_qs))
        printJson(toJson(rows, options));
    else
        print(text(rows, options));
    return 0;
}

} // namespace gripscope::cli
