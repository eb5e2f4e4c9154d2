// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/virtual_gripper/options.h"
#include "devices/hid/uhid_gripper.h"
#include "devices/virtual/virtual_plug.h"
#include "devices/virtual/virtual_transport.h"

#include <QCoreApplication>
#include <QTextStream>

#include <atomic>
#include <csignal>
#include <future>

// gripscope-virtual-gripper: virtual grippers as HID devices of this computer, for any program to find.

namespace {

using namespace gripscope;
using namespace Qt::StringLiterals;

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
