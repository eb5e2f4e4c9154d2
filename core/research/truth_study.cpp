// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/truth_study.h"

#include "core/base/parallel_runs.h"
#include "core/identification/identification.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// Of the interval's variance of k: from there on it is twice as wide as without.
constexpr double doubling = 0.75;
constexpr double liesFrom = 4;

void count(const Identification& found, TruthRow& row)
{
    ++row.runs;
    if (found.validity.verdict != ValidityVerdict::Valid || !found.budget.parameters) {
        ++(found.validity.verdict == ValidityVerdict::Invalid ? row.invalid : row.suspect);
        return;
    }
    ++row.valid;
    const RealPart& part = row.setting.part;
    const Eigen::Vector3d truth(part.m, part.b, part.k);
    const BudgetLine* const friction = found.budget.find(QStringLiteral("friction"));
    const bool widened = friction != nullptr && friction->share(2) > doubling;
    row.widened += widened ? 1 : 0;
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        row.largestError[i] = std::abs(found.budget.parameters->vector()(at) - truth(at)) /
                              found.budget.combined[i].standardUncertainty;
        worst = std::max(worst, row.largestError[i]);
        const CoverageInterval& interval = found.budget.intervals[i];
        if (interval.lower <= truth(at) && truth(at) <= interval.upper)
            ++(widened ? row.coveredWidened : row.covered)[i];
    }
    row.lies += worst > liesFrom ? 1 : 0;
}

double percent(int part, int whole)
{
    return whole > 0 ? 100.0 * part / whole : 0;
}

int sum(const std::array<int, 3>& counts)
{
    return counts[0] + counts[1] + counts[2];
}

void addUp(TruthStudy& study)
{
    int family = 0;
    int validFamily = 0;
    int covered = 0;
    int coveredWidened = 0;
    int widened = 0;
    for (const TruthRow& row : study.rows) {
        study.runs += row.runs;
        study.valid += row.valid;
        study.lies += row.lies;
        widened += row.widened;
        covered += sum(row.covered);
        coveredWidened += sum(row.coveredWidened);
        family += row.setting.inFamily ? row.runs : 0;
        validFamily += row.setting.inFamily ? row.valid : 0;
    }
    study.coveredPercent = percent(covered, 3 * (study.valid - widened));
    study.coveredWidenedPercent = percent(coveredWidened, 3 * widened);
    study.validInFamilyPercent = percent(validFamily, family);
}

} // namespace

TruthStudy studyTruth(const TruthStudyOptions& options)
{
    const std::vector<TruthSetting> settings = options.settings.empty() ? truthSettings() : options.settings;
    const auto runs = static_cast<std::size_t>(std::max(options.runs, 0));
    std::vector<TruthRow> single(settings.size() * runs);
    performRuns(
        static_cast<std::int64_t>(single.size()), options.threads, options.progress, [&](std::int64_t at) {
            const auto index = static_cast<std::size_t>(at);
            TruthRow& row = single[index];
            row.setting = settings[index / runs];
            count(identify(drawSqueeze(row.setting, runSeed(options.seed, row.setting.name, index % runs))),
                  row);
        });
    TruthStudy study;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        TruthRow whole;
        whole.setting = settings[i];
        for (std::size_t run = 0; run < runs; ++run) {
            const TruthRow& one = single[i * runs + run];
            whole.runs += one.runs;
            whole.valid += one.valid;
            whole.suspect += one.suspect;
            whole.invalid += one.invalid;
            whole.lies += one.lies;
            whole.widened += one.widened;
            for (std::size_t p = 0; p < 3; ++p) {
                whole.largestError[p] = std::max(whole.largestError[p], one.largestError[p]);
                whole.covered[p] += one.covered[p];
                whole.coveredWidened[p] += one.coveredWidened[p];
            }
        }
        study.rows.push_back(whole);
    }
    addUp(study);
    return study;
}

} // namespace gripscope
