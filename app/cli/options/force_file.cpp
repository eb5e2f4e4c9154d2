// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/options/force_file.h"

#include "app/cli/line/output.h"

#include <utility>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

bool ofLevels(const CommandLine& line)
{
    return line.text(u"excitation"_qs) == toString(ExcitationKind::Levels);
}

} // namespace

void addForceFile(CommandLine& line)
{
    line.option(
        u"force-file"_qs, u"FILE"_qs,
        u"Squeeze with the force in a table, such as a recording or what design wrote: a column \"force\" "
        "at equal steps, from its times (time_s, or \"# sample_time_s:\") or else --bit. It goes again "
        "from its start after its end. --bias, --peak and --bit, where given, take the place of its own."_qs);
}

void checkForceFile(CommandLine& line)
{
    const bool given = line.isSet(u"force-file"_qs);
    if (given && line.isSet(u"excitation"_qs) && !ofLevels(line))
        line.reject(u"--force-file has the force: --excitation %1 is another one."_qs.arg(
            line.text(u"excitation"_qs)));
    if (!given && ofLevels(line))
        line.reject(u"--excitation levels needs --force-file FILE, which has them."_qs);
}

Expected<std::optional<ForceLevels>> takeForceFile(const CommandLine& line, ExcitationOptions& excitation)
{
    if (!line.isSet(u"force-file"_qs))
        return std::nullopt;
    ASSIGN_OR_RETURN(ForceLevels force, readForceLevels(line.text(u"force-file"_qs), excitation.bit_s));
    excitation.kind = ExcitationKind::Levels;
    excitation.levels = force.levels;
    if (!line.isSet(u"bias"_qs))
        excitation.bias = force.bias;
    if (!line.isSet(u"peak"_qs))
        excitation.peak = force.peak;
    if (!line.isSet(u"bit"_qs))
        excitation.bit_s = force.bit_s;
    return std::optional(std::move(force));
}

} // namespace gripscope::cli
