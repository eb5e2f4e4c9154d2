// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/commands.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

const std::vector<Command>& commands()
{
    static const std::vector<Command> table{
        {u"demo"_qs, u"enrols and inspects virtual cans through the whole chain"_qs, runDemo},
        {u"devices"_qs, u"lists the grippers that can be connected"_qs, runDevices},
        {u"profile"_qs, u"teaches Gripscope the reports of other makers' grippers"_qs, runProfile},
        {u"device"_qs, u"says what a gripper is and does, and tests it without moving it"_qs, runDevice},
        {u"self-check"_qs,
         u"says what is wrong with library, clock, disk and permissions of this computer"_qs, runSelfCheck},
        {u"record"_qs, u"squeezes, or only listens, and writes a recording"_qs, runRecord},
        {u"replay"_qs, u"cuts the squeezes out of captured sessions, bit for bit"_qs, runReplay},
        {u"captures"_qs, u"lists, verifies and prunes kept sessions"_qs, runCaptures},
        {u"simulate"_qs, u"writes a synthetic recording of a known object"_qs, runSimulate},
        {u"identify"_qs, u"finds mass, damping and stiffness in recordings"_qs, runIdentify},
        {u"cluster"_qs, u"groups a table of features without labels"_qs, runCluster},
        {u"enroll"_qs, u"adds recordings to a type of a library"_qs, runEnroll},
        {u"classify"_qs, u"says which enrolled type each recording shows"_qs, runClassify},
        {u"types"_qs, u"renames, merges, splits, retires and rolls back enrolled types"_qs, runTypes},
        {u"history"_qs, u"lists the squeezes of a library, inspected or enrolled, as a table, CSV or JSON"_qs,
         runHistory},
        {u"audit"_qs, u"lists and verifies who did what, when and why"_qs, runAudit},
        {u"library"_qs, u"verifies that every row of a library is as it was written"_qs, runLibrary},
        {u"drift"_qs, u"says whether inspected parts have moved since the enrolment, and what moved"_qs,
         runDrift},
        {u"transfer"_qs, u"compares two grippers by squeezes of the same types"_qs, runTransfer},
        {u"reproduce-paper"_qs, u"Table 1 of the paper, and what Gripscope adds"_qs, runReproducePaper},
        {u"calibrate"_qs, u"fits the curve of a sensor, and inverts it"_qs, runCalibrate},
        {u"design"_qs, u"finds the excitation that best tells given objects apart"_qs, runDesign},
        {u"study"_qs, u"repeats experiments with known truth: how good the estimates are"_qs, runStudy},
    };
    return table;
}

} // namespace gripscope::cli
