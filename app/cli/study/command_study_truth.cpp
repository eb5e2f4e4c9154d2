// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/command_line.h"
#include "app/cli/line/output.h"
#include "app/cli/study/study_commands.h"
#include "core/research/study_json.h"
#include "core/research/truth_study.h"

#include <algorithm>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QString rowText(const TruthRow& row)
{
    QString covered;
    for (std::size_t i = 0; i < 3; ++i)
        covered += row.valid > 0
                       ? u"%1"_qs.arg(100.0 * (row.covered[i] + row.coveredWidened[i]) / row.valid, 5, 'f', 0)
                       : u"    -"_qs;
    return u"%1 %2 %3 %4 %5 %6 %7 %8"_qs.arg(row.setting.name, -58)
        .arg(row.valid, 6)
        .arg(row.suspect, 8)
        .arg(row.invalid, 8)
        .arg(row.lies, 5)
        .arg(fixed(*std::ranges::max_element(row.largestError), 1), 6)
        .arg(covered)
        .arg(row.widened, 8);
}

QString text(const TruthStudy& study, int runs)
{
    QStringList lines{
        u"Parts that are not ideal, %1 squeezes each. A lie: valid, and m, b or k more than four stated "
        "standard uncertainties from the truth; \"widened\": friction that may hide has doubled the interval "
        "of k."_qs.arg(runs),
        u"%1  valid  suspect  invalid  lies  worst  m    b    k %  widened"_qs.arg(u"setting"_qs, -58)};
    for (const TruthRow& row : study.rows)
        lines << rowText(row);
    lines << u"%1 of %2 valid ones lie (%3 %); their intervals hold the truth in %4 %, widened ones in %5 %; "
             "%6 % of the squeezes whose physics is in the family are valid."_qs.arg(study.lies)
                 .arg(study.valid)
                 .arg(fixed(study.valid > 0 ? 100.0 * study.lies / study.valid : 0, 2))
                 .arg(fixed(study.coveredPercent, 1), fixed(study.coveredWidenedPercent, 1),
                      fixed(study.validInFamilyPercent, 1));
    return lines.join(u'\n');
}

/// Those whose name holds one of the words; all where there is none.
std::vector<TruthSetting> chosen(CommandLine& line)
{
    const QStringList words = line.list(u"settings"_qs);
    std::vector<TruthSetting> settings = truthSettings();
    if (words.isEmpty())
        return settings;
    std::erase_if(settings, [&](const TruthSetting& setting) {
        return std::ranges::none_of(
            words, [&](const QString& word) { return setting.name.contains(word.trimmed()); });
    });
    if (settings.empty())
        line.reject(u"--settings: no setting's name holds \"%1\"; without the option all are studied and "
                    "named."_qs.arg(words.join(u", "_qs)));
    return settings;
}

} // namespace

int runTruthStudy(const QStringList& arguments)
{
    CommandLine line(
        u"study truth"_qs,
        u"Squeezes parts with friction, hysteresis, relaxation and bent springs, simulated apart "
        "from the estimators: how often a valid result is wrong, and how often its intervals "
        "hold the truth."_qs);
    addStudyOptions(line, 30);
    line.option(u"settings"_qs, u"LIST"_qs,
                u"Only settings whose names hold one of these words (friction, jitter, Hz...)."_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    TruthStudyOptions options;
    readStudyOptions(line, options);
    options.settings = chosen(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    options.progress = progressLines();
    const TruthStudy study = studyTruth(options);
    if (line.isSet(u"json"_qs))
        printJson(toJson(study, options));
    else
        print(text(study, options.runs));
    return 0;
}

} // namespace gripscope::cli
