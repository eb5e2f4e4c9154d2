// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/type_commands.h"
#include "app/cli/line/actions.h"
#include "app/cli/line/commands.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

const std::vector<Command>& typeActions()
{
    static const std::vector<Command> all{
        {u"list"_qs, u"the types, now or at an earlier version"_qs, listTypes},
        {u"squeezes"_qs, u"the squeezes of a type, with their keys"_qs, listSqueezes},
        {u"guide"_qs, u"is a type enrolled well enough, which squeeze is an outlier, what overlaps"_qs,
         guideEnrollment},
        {u"confusion"_qs, u"what enrolled squeezes are called by models that do not know them"_qs,
         showConfusion},
        {u"rename"_qs, u"gives a type another name"_qs, renameType},
        {u"code"_qs, u"sets what a scanner reads on the parts of a type"_qs, setTypeCode},
        {u"limits"_qs, u"sets or shows the tolerance limits of a type, and what they risk"_qs, typeLimits},
        {u"merge"_qs, u"moves the squeezes of a type into another"_qs, mergeTypes},
        {u"split"_qs, u"moves some squeezes of a type into a new one"_qs, splitType},
        {u"retire"_qs, u"keeps a type, but recognises it no longer"_qs, retireType},
        {u"reinstate"_qs, u"puts a retired type back into use"_qs, reinstateType},
        {u"approve"_qs, u"signs a type off"_qs, approveType},
        {u"versions"_qs, u"every change, newest first"_qs, listVersions},
        {u"rollback"_qs, u"puts types and squeezes back to an earlier version"_qs, restoreVersion},
    };
    return all;
}

} // namespace

int runTypes(const QStringList& arguments)
{
    return runAction(
        u"types"_qs,
        u"Manages the types of a library; nothing is lost, every change is a version with who, when and why."_qs,
        typeActions(), arguments);
}

} // namespace gripscope::cli
