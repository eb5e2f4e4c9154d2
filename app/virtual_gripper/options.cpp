// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/virtual_gripper/options.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

tl::unexpected<Error> usage(const QString& reason)
{
    return failure(ErrorCode::Usage, {reason});
}

Expected<VirtualAddress> parseGripper(const QString& text)
{
    ASSIGN_OR_RETURN(const DeviceAddress address, parseDeviceAddress(text));
    const auto* gripper = std::get_if<VirtualAddress>(&address);
    if (!gripper || gripper->speed == 0 || !gripper->capture.isEmpty())
        return usage(
            u"%1: only virtual: addresses can be served, with a speed above 0 and no capture."_qs.arg(text));
    return *gripper;
}

/// The script of all that name none of their own; looked at now, so that a mistake is told before anything is
/// plugged in.
Expected<void> giveScript(const QString& script, std::vector<VirtualAddress>& grippers)
{
    for (VirtualAddress& gripper : grippers) {
        if (gripper.script.isEmpty())
            gripper.script = script;
        if (gripper.script.isEmpty())
            continue;
        RETURN_IF_ERROR(readFaultScript(gripper.script));
    }
    return {};
}

} // namespace

Expected<VirtualGripperOptions> parseVirtualGripperOptions(const QStringList& arguments)
{
    VirtualGripperOptions options;
    QString script;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        const QString& argument = arguments[i];
        if (argument == u"--help" || argument == u"-h") {
            options.help = true;
            return options;
        }
        if (argument == u"--script") {
            if (++i == arguments.size())
                return usage(u"--script needs the name of a file."_qs);
            script = arguments[i];
        } else if (argument.startsWith(u'-')) {
            return usage(u"%1 is not an option; --help lists them."_qs.arg(argument));
        } else {
            ASSIGN_OR_RETURN(const VirtualAddress gripper, parseGripper(argument));
            const auto same = [&](const VirtualAddress& other) { return other.seed == gripper.seed; };
            if (std::any_of(options.grippers.begin(), options.grippers.end(), same))
                return usage(
                    u"Two grippers would have the serial number VG-%1; give them another seed each."_qs.arg(
                        gripper.seed));
            options.grippers.push_back(gripper);
        }
    }
    if (options.grippers.empty())
        options.grippers.emplace_back();
    RETURN_IF_ERROR(giveScript(script, options.grippers));
    return options;
}

QString virtualGripperHelp()
{
    return u"usage: gripscope-virtual-gripper [--script FILE] [ADDRESS...]\n\n"
           "Plugs virtual grippers into this computer as HID devices, through /dev/uhid, where any program "
           "finds\n"
           "them. Without ADDRESS it is one with can A. It needs the kernel's module uhid (sudo modprobe "
           "uhid) and\n"
           "the right to write to /dev/uhid (sudo).\n\n"
           "ADDRESS       virtual:?OPTION=VALUE&..., in quotes; the options are\n"
           "  object=A        can A, B, C or D, or m,b,k in kg, N s/m and N/m\n"
           "  seed=7          other squeezes of it; the serial number is VG-7, another one for each gripper\n"
           "  noise=20e-6     standard deviation of the position, m\n"
           "  speed=2         seconds of the gripper in one of yours\n"
           "  fault=LIST      with commas between: loss:P duplicate:P crc:P saturate:N stuck units from the\n"
           "                  beginning on; stall:S unplug:S deaf:S hang-feature:S hang-write:S broken:S "
           "button:S\n"
           "                  after so many seconds; replug:S so long after the unplug\n"
           "  script=FILE     faults of this one\n"
           "--script FILE  faults that come and go, of all that name no script of their own. A line for "
           "each:\n"
           "               seconds, word, value. Words: loss duplicate crc saturate stuck stall resume "
           "clock\n"
           "               unplug replug deaf hang-feature hang-write broken button; the manual explains "
           "them.\n"
           "--help         this\n\n"
           "Exit: 0 ended by Ctrl-C or unplugged for good by a fault; 2 usage; 3 a script is not "
           "understood;\n"
           "4 /dev/uhid cannot be used.\n"_qs;
}

} // namespace gripscope
