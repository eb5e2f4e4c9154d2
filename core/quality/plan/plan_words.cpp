// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/plan/plan_words.h"

#include "core/base/words.h"

namespace gripscope {

Finding instruction(const StudyPlan& plan, std::size_t row)
{
    const QString person = plan.operatorName(row), station = plan.station(row);
    Finding told = person.isEmpty() ? Words::say("Put in part %1 (trial %2 of %3).")
                                    : Words::say("%1 puts in part %2 (trial %3 of %4).").arg(person);
    told = told.arg(plan.part(row)).arg(plan.rows[row].trial + 1).arg(plan.design.trials);
    if (!station.isEmpty())
        told += Words::say(" At station %1.").arg(station);
    return told;
}

Finding progressWords(const StudyProgress& progress)
{
    const std::size_t total = progress.rows.size();
    Finding told = progress.complete()
                       ? Words::say("All %1 squeezes are through.").arg(total)
                       : Words::say("Squeeze %1 of %2.").arg(progress.done + progress.skipped + 1).arg(total);
    if (progress.skipped > 0)
        told += Words::say(" Left out: %1.").arg(progress.skipped);
    if (progress.repeated > 0)
        told += Words::say(" Repeated: %1.").arg(progress.repeated);
    return told;
}

} // namespace gripscope
