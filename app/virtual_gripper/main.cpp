// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/address/device_address.h"
#include "devices/hid/uhid_gripper.h"
#include "devices/virtual/virtual_plug.h"
#include "devices/virtual/virtual_transport.h"

#include <QCoreApplication>
#include <QStringList>
#include <QTextStream>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <future>
#include <variant>
#include <vector>

// gripscope-virtual-gripper: virtual grippers as HID devices of this computer, for any program to find.

namespace {

using namespace gripscope;
using namespace Qt::StringLiterals;

struct VirtualGripperOptions {
    std::vector<VirtualAddress> grippers; ///< at least one, no two with the same serial number
    bool help = false;
};

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

/// Usage, or what is wrong with a script.
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

enum ExitCode { ExitDone = 0, ExitUsage = 2, ExitBadInput = 3, ExitDevice = 4 };

std::atomic<bool> ending{false};
void end(int)
{
    ending = true;
}

int exitFor(const Error& error)
{
    switch (error.code) {
    case ErrorCode::Usage:
        return ExitUsage;
    case ErrorCode::BadInput:
    case ErrorCode::FileUnreadable:
        return ExitBadInput;
    default:
        return ExitDevice;
    }
}

int fail(const Error& error)
{
    QTextStream(stderr) << "gripscope-virtual-gripper: " << error.describe() << '\n';
    return exitFor(error);
}

void tell(const QString& text)
{
    QTextStream(stdout) << text << '\n' << Qt::flush;
}

/// Until it is unplugged, or this program ends.
Expected<void> servePlugged(const VirtualAddress& address)
{
    ASSIGN_OR_RETURN(const std::shared_ptr<VirtualTransport> transport, VirtualTransport::make(address));
    RETURN_IF_ERROR(transport->open());
    ASSIGN_OR_RETURN(const std::unique_ptr<UhidGripper> gripper, UhidGripper::create(transport));
    tell(
        u"The virtual gripper is plugged in as hid:1209:0001:VG-%1. Ctrl-C unplugs it."_qs.arg(address.seed));
    return (gripper)->serve(ending);
}

/// Until its faults unplug it for good, or this program ends.
Expected<void> serve(const VirtualAddress& address)
{
    for (;;) {
        RETURN_IF_ERROR(servePlugged(address));
        if (ending || !virtual_plug::comesBack(address))
            return {};
        tell(u"hid:1209:0001:VG-%1 is unplugged, and comes back."_qs.arg(address.seed));
        while (!ending && !virtual_plug::isIn(address))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (ending)
            return {};
    }
}

int serveAll(const std::vector<VirtualAddress>& grippers)
{
    std::signal(SIGINT, &end);
    std::signal(SIGTERM, &end);
    std::vector<std::future<Expected<void>>> served;
    served.reserve(grippers.size());
    for (const VirtualAddress& address : grippers)
        served.push_back(std::async(std::launch::async, [&address] {
            Expected<void> done = serve(address);
            if (!done)
                ending = true; // all or none
            return done;
        }));
    int exit = ExitDone;
    for (auto& one : served)
        if (const Expected<void> done = one.get(); !done && exit == ExitDone)
            exit = fail(done.error());
    return exit;
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const Expected<VirtualGripperOptions> options =
        parseVirtualGripperOptions(QCoreApplication::arguments().mid(1));
    if (!options)
        return fail(options.error());
    if (options->help) {
        QTextStream(stdout) << virtualGripperHelp();
        return ExitDone;
    }
    return serveAll(options->grippers);
}
