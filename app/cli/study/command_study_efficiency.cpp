// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/output.h"
#include "app/cli/study/study_commands.h"
#include "core/research/efficiency_study.h"
#include "core/research/study_json.h"

#include <algorithm>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

std::vector<Estimator> readEstimators(CommandLine& line)
{
    QStringList names;
    for (const Estimator estimator : studiedEstimators())
        names << toString(estimator);
    QStringList wanted = line.list(u"estimators"_qs);
    if (wanted.contains(u"all"_qs))
        wanted = names;
    std::vector<Estimator> found;
    for (const QString& name : wanted) {
        const std::optional<Estimator> estimator = estimatorFromString(name);
        if (!estimator || !names.contains(name))
            line.reject(u"the study has no estimator \"%1\"; choose from %2, or all."_qs.arg(
                name, names.join(u", "_qs)));
        else if (std::find(found.begin(), found.end(), *estimator) == found.end())
            found.push_back(*estimator);
    }
    if (found.empty())
        line.reject(u"--estimators names none."_qs);
    return found;
}

EfficiencyOptions readEfficiencyOptions(CommandLine& line)
{
    EfficiencyOptions options;
    readStudyOptions(line, options);
    options.estimators = readEstimators(line);
    options.settings = selectSettings(line.list(u"settings"_qs));
    if (options.settings.empty())
        line.reject(
            u"--settings is \"%1\"; that leaves none of A, B, C, D, prbs, multisine, 85, 90, 95, 200, "
            "1000, or names such as A-prbs-90-200."_qs.arg(line.text(u"settings"_qs)));
    return options;
}

QString coverageText(double value)
{
    return QString::number(value, 'f', 1).rightJustified(7);
}

QString rowText(const SettingEfficiency& row)
{
    QString text = u"%1 %2"_qs.arg(row.setting.name(), -22).arg(toString(row.estimator), -14);
    if (row.used == 0)
        return text + u"  no run gave an estimate"_qs;
    for (const ParameterEfficiency& parameter : row.parameters)
        text += QString::number(parameter.ratio, 'f', 3).rightJustified(8);
    text += u"  "_qs;
    for (const ParameterEfficiency& parameter : row.parameters)
        text += coverageText(parameter.coveragePercent);
    return text + QString::number(row.runs - row.used).rightJustified(8);
}

QString pooledText(const PooledEfficiency& pooled)
{
    if (pooled.used == 0)
        return u"%1: no run gave an estimate."_qs.arg(toString(pooled.estimator));
    static const QStringList names{u"m"_qs, u"b"_qs, u"k"_qs};
    return u"%1: error over bound %2 pooled, at most %3 (%4 of %5); 95 % intervals cover %6 %; %7 of %8 runs "
           "failed and are left out."_qs.arg(
               toString(pooled.estimator), QString::number(pooled.ratio, 'f', 4),
               QString::number(pooled.worstRatio, 'f', 3), names[pooled.worstParameter], pooled.worstSetting,
               QString::number(pooled.coveragePercent, 'f', 2), QString::number(pooled.runs - pooled.used),
               QString::number(pooled.runs));
}

QString text(const EfficiencyStudy& study)
{
    QStringList lines{
        u"Root-mean-square error over the Cramer-Rao bound, and how many 95 % intervals hold the "
        "truth; x0, v0 and offset free."_qs,
        u"%1 %2       m       b       k       m %    b %    k %  failed"_qs.arg(u"setting"_qs, -22)
            .arg(u"estimator"_qs, -14)};
    for (const SettingEfficiency& row : study.rows)
        lines << rowText(row);
    for (const PooledEfficiency& pooled : study.pooled)
        lines << pooledText(pooled);
    return lines.join(u'\n');
}

} // namespace

int runEfficiencyStudy(const QStringList& arguments)
{
    CommandLine line(u"study efficiency"_qs,
                     u"Repeats experiments with known truth: how close the estimators come to the Cramer-Rao "
                     "bound, and how often their 95 % intervals hold the truth."_qs);
    addStudyOptions(line, 500);
    line.option(u"estimators"_qs, u"LIST"_qs, u"Estimators, or all."_qs, u"oe"_qs);
    line.option(
        u"settings"_qs, u"LIST"_qs,
        u"Only these: types (A to D), prbs, multisine, fits (85, 90, 95), samples (200, 1000), or names "
        "such as A-prbs-90-200. Without it all 48."_qs);
    line.option(
        u"models"_qs, u"LIST"_qs,
        u"In place of these, parts of which a model is true under four levels of force: oe, friction, "
        "zener, duffing, or all."_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    if (line.isSet(u"models"_qs)) {
        for (const QString& other : {u"estimators"_qs, u"settings"_qs})
            if (line.isSet(other))
                line.reject(
                    u"--models has settings and estimators of its own; leave --%1 out."_qs.arg(other));
        return runModelStudy(line, line.list(u"models"_qs));
    }
    EfficiencyOptions options = readEfficiencyOptions(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    options.progress = progressLines();
    const EfficiencyStudy study = studyEfficiency(options);
    if (line.isSet(u"json"_qs))
        printJson(toJson(study, options));
    else
        print(text(study));
    return 0;
}

} // namespace gripscope::cli
