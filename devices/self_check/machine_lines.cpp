// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/calibration/sensor_calibration.h"
#include "devices/protocol/report.h"
#include "devices/self_check/self_check.h"

#include <QStringList>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// No clock of a computer that runs this program is before it.
const QDate firstPlausibleDay{2025, 1, 1};
/// A clock that was set right by the network may go back by as much.
constexpr qint64 mayGoBack_s = 60;

CheckLine machineLine(const QString& id, const QString& name, CheckOutcome outcome, const QString& found,
                      const QString& advice = {})
{
    return {id, name, outcome, found, advice};
}

/// What is worst stands for all; what is told is all that is as bad.
struct Worst {
    CheckOutcome outcome = CheckOutcome::Ok;
    QStringList found;

    void take(CheckOutcome other, const QString& text)
    {
        if (other > outcome)
            found.clear();
        outcome = std::max(outcome, other);
        if (other == outcome)
            found << text;
    }
};

} // namespace

CheckLine calibrationLine(const std::vector<CalibratedChannel>& channels, const QDate& today)
{
    const QString id = u"calibration"_s, name = Words::tr("Calibration");
    if (channels.empty())
        return machineLine(id, name, CheckOutcome::Ok,
                           Words::tr("no gripper is plugged in, and none was calibrated"));
    Worst worst;
    for (const CalibratedChannel& one : channels) {
        const QString date = one.due ? one.due->toString(Qt::ISODate) : QString();
        switch (calibrationStatus(one.due, today)) {
        case CalibrationStatus::Missing:
            worst.take(CheckOutcome::Look, Words::tr("%1 has none of its %2").arg(one.gripper, one.channel));
            break;
        case CalibrationStatus::Overdue:
            worst.take(CheckOutcome::Look,
                       Words::tr("%1, %2: was due on %3").arg(one.gripper, one.channel, date));
            break;
        case CalibrationStatus::DueSoon:
            worst.take(CheckOutcome::Look,
                       Words::tr("%1, %2: is due on %3").arg(one.gripper, one.channel, date));
            break;
        case CalibrationStatus::Valid:
            worst.take(CheckOutcome::Ok,
                       Words::tr("%1, %2: holds until %3").arg(one.gripper, one.channel, date));
            break;
        }
    }
    return machineLine(id, name, worst.outcome, worst.found.join(u"; "_s),
                       worst.outcome == CheckOutcome::Ok
                           ? QString()
                           : Words::tr("Calibrate these channels on the page Calibrate."));
}

CheckLine clockLine(const ClockFacts& facts)
{
    const QString id = u"clock"_s, name = Words::tr("Clock");
    const QString time = facts.utc.toString(Qt::ISODate);
    const QString setIt =
        Words::tr("Set the clock; by the network, type this in a terminal: sudo timedatectl set-ntp true");
    if (facts.utc.date() < firstPlausibleDay)
        return machineLine(id, name, CheckOutcome::Broken,
                           Words::tr("it says %1, which is long gone").arg(time), setIt);
    if (facts.newestEntry.isValid() && facts.newestEntry > facts.utc.addSecs(mayGoBack_s))
        return machineLine(id, name, CheckOutcome::Broken,
                           Words::tr("it says %1, but the library was written at %2")
                               .arg(time, facts.newestEntry.toUTC().toString(Qt::ISODate)),
                           setIt);
    if (!facts.synchronised)
        return machineLine(
            id, name, CheckOutcome::Look,
            Words::tr("%1; whether it is kept right is not known here").arg(time),
            Words::tr("Neither timedatectl nor chronyc answers: compare it with another clock."));
    if (!*facts.synchronised)
        return machineLine(id, name, CheckOutcome::Look,
                           Words::tr("%1, not kept right by the network (%2)").arg(time, facts.askedOf),
                           setIt);
    return machineLine(id, name, CheckOutcome::Ok,
                       Words::tr("%1, kept right by the network (%2)").arg(time, facts.askedOf));
}

CheckLine permissionLine(const std::vector<GripperNode>& nodes, bool ruled, bool isRoot)
{
    const QString id = u"permissions"_s, name = Words::tr("Permissions");
    Worst worst;
    QStringList commands;
    for (const GripperNode& one : nodes) {
        const QString missing = missingIn(one.permission);
        if (missing.isEmpty()) {
            worst.take(CheckOutcome::Ok, Words::tr("%1 may be opened").arg(one.node.path));
            continue;
        }
        worst.take(CheckOutcome::Broken,
                   Words::tr("%1 (%2): what is missing is %3").arg(one.node.path, one.node.name, missing));
        if (!commands.contains(one.command))
            commands << one.command;
    }
    if (worst.outcome == CheckOutcome::Broken)
        return machineLine(id, name, worst.outcome, worst.found.join(u"; "_s),
                           Words::tr("Type this in a terminal: %1").arg(commands.join(u" && "_s)));
    if (!nodes.empty())
        return machineLine(id, name, CheckOutcome::Ok, worst.found.join(u"; "_s));
    if (ruled || isRoot)
        return machineLine(id, name, CheckOutcome::Ok,
                           Words::tr("no gripper is plugged in; one may be opened"));
    const HidNode own{{}, protocol::vendorId, protocol::productId, {}, {}, true, false};
    return machineLine(id, name, CheckOutcome::Look,
                       Words::tr("no gripper is plugged in, and no rule lets this user open one"),
                       Words::tr("Type this in a terminal: %1").arg(permissionCommand(own, {{}, {}, true})));
}

CheckLine versionLine(const VersionFacts& facts)
{
    const QString id = u"versions"_s, name = Words::tr("Versions");
    const QString found = u"Gripscope %1, Qt %2, SQLite %3, hidapi %4, libsodium %5, %6, %7"_s.arg(
        facts.program, facts.qt, facts.sqlite, facts.hidapi, facts.sodium, facts.kernel, facts.system);
    if (facts.qt == facts.qtBuiltWith)
        return machineLine(id, name, CheckOutcome::Ok, found);
    return machineLine(
        id, name, CheckOutcome::Look, found,
        Words::tr("The program was built with Qt %1: install the package that was built for this "
                  "system.")
            .arg(facts.qtBuiltWith));
}

std::optional<bool> synchronisedByTimedatectl(const QString& printed)
{
    const QString word = printed.trimmed();
    return word == "yes"_L1 ? std::optional(true) : word == "no"_L1 ? std::optional(false) : std::nullopt;
}

std::optional<bool> synchronisedByChronyc(const QString& printed)
{
    for (const QString& line : printed.split(u'\n')) {
        if (!line.startsWith("Leap status"_L1))
            continue;
        return !line.contains("Not synchronised"_L1);
    }
    return std::nullopt;
}

} // namespace gripscope
