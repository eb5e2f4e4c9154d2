// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/output.h"
#include "app/cli/study/study_commands.h"
#include "core/research/model_efficiency.h"
#include "core/research/study_json.h"

#include <algorithm>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

std::vector<ModelSetting> settingsOf(CommandLine& line, const QStringList& models)
{
    std::vector<ModelSetting> all = modelSettings();
    QStringList names;
    for (const ModelSetting& setting : all)
        if (!names.contains(toString(setting.estimator)))
            names << toString(setting.estimator);
    for (const QString& model : models)
        if (model != u"all"_qs && !names.contains(model))
            line.reject(u"--models: there is no model \"%1\" in the study; choose from %2, or all."_qs.arg(
                model, names.join(u", "_qs)));
    if (!models.contains(u"all"_qs))
        std::erase_if(
            all, [&](const ModelSetting& setting) { return !models.contains(toString(setting.estimator)); });
    return all;
}

QString rowText(const ModelEfficiencyRow& row)
{
    QString text = u"%1 %2 %3"_qs.arg(row.setting.squeeze.name, -32)
                       .arg(toString(row.setting.estimator), -9)
                       .arg(row.runs - row.used, 6);
    if (row.used == 0)
        return text + u"  no run gave an estimate"_qs;
    for (const ModelParameterEfficiency& p : row.parameters)
        text +=
            u"  %1 %2 (%3 %)"_qs.arg(toString(p.parameter), fixed(p.ratio, 3), fixed(p.coveragePercent, 1));
    if (row.nearZero)
        text += u"  near zero; limit holds %1 %"_qs.arg(fixed(row.limitPercent, 1));
    return text;
}

QString pooledText(const PooledModelEfficiency& pooled)
{
    if (pooled.used == 0)
        return u"%1: no run gave an estimate."_qs.arg(toString(pooled.estimator));
    const QString limit = pooled.limitPercent
                              ? u"; limits of friction hold %1 %"_qs.arg(fixed(*pooled.limitPercent, 1))
                              : QString();
    return u"%1: error over bound %2 pooled; 95 % intervals cover %3 %%4; %5 of %6 runs failed and are left "
           "out."_qs.arg(toString(pooled.estimator), fixed(pooled.ratio, 4), fixed(pooled.coveragePercent, 2),
                         limit, QString::number(pooled.runs - pooled.used), QString::number(pooled.runs));
}

} // namespace

int runModelStudy(CommandLine& line, const QStringList& models)
{
    ModelEfficiencyOptions options;
    readStudyOptions(line, options);
    options.settings = settingsOf(line, models);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    options.progress = progressLines();
    const ModelEfficiencyStudy study = studyModelEfficiency(options);
    if (line.isSet(u"json"_qs)) {
        printJson(toJson(study, options));
        return 0;
    }
    QStringList lines{u"Squeezes of parts of which the model is true: root-mean-square error over the "
                      u"Cramer-Rao bound, and "
                      "how many 95 % intervals hold the truth."_qs,
                      u"%1 %2 failed"_qs.arg(u"setting"_qs, -32).arg(u"estimator"_qs, -9)};
    for (const ModelEfficiencyRow& row : study.rows)
        lines << rowText(row);
    for (const PooledModelEfficiency& pooled : study.pooled)
        lines << pooledText(pooled);
    print(lines.join(u'\n'));
    return 0;
}

} // namespace gripscope::cli
