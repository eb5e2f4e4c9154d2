// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/device_address.h"
#include "devices/hid/uhid_gripper.h"
#include "devices/virtual/virtual_transport.h"

#include <QCoreApplication>
#include <QTextStream>

#include <atomic>
#include <csignal>

// gripscope-virtual-gripper: the virtual gripper as a HID device of this computer, for any program to find.

namespace {

using namespace gripscope;
using namespace Qt::StringLiterals;

enum ExitCode { ExitDone = 0, ExitUsage = 2, ExitDevice = 4 };

std::atomic<bool> ending{false};
void end(int)
{
    ending = true;
}

int fail(const Error& error)
{
    QTextStream(stderr) << error.describe() << '\n';
    return error.code == ErrorCode::Usage ? ExitUsage : ExitDevice;
}

Expected<VirtualAddress> parseArguments(const QStringList& arguments)
{
    if (arguments.size() > 1)
        return failure(ErrorCode::Usage, {u"Name one virtual gripper, or none for the default one."_qs});
    const Expected<DeviceAddress> address = parseDeviceAddress(arguments.value(0, u"virtual:"_qs));
    if (!address)
        return tl::unexpected<Error>(address.error());
    const auto* gripper = std::get_if<VirtualAddress>(&*address);
    if (!gripper || gripper->speed == 0 || !gripper->capture.isEmpty())
        return failure(ErrorCode::Usage,
                       {u"Only virtual: addresses can be served, with a speed above 0 and no capture."_qs});
    return *gripper;
}

int serve(const VirtualAddress& address)
{
    const Expected<std::shared_ptr<VirtualTransport>> transport = VirtualTransport::make(address);
    if (!transport)
        return fail(transport.error());
    if (const Expected<void> opened = (*transport)->open(); !opened)
        return fail(opened.error());
    const Expected<std::unique_ptr<UhidGripper>> gripper = UhidGripper::create(*transport);
    if (!gripper)
        return fail(gripper.error());
    QTextStream(stdout)
        << u"The virtual gripper is plugged in as hid:1209:0001:VG-%1. Ctrl-C unplugs it.\n"_qs.arg(
               address.seed)
        << Qt::flush;
    std::signal(SIGINT, &end);
    std::signal(SIGTERM, &end);
    const Expected<void> served = (*gripper)->serve(ending);
    return served ? ExitDone : fail(served.error());
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments().mid(1);
    if (arguments.contains(u"--help"_qs) || arguments.contains(u"-h"_qs)) {
        QTextStream(stdout)
            << "usage: gripscope-virtual-gripper [ADDRESS]\n\n"
               "Plugs a virtual gripper into this computer as a HID device, through /dev/uhid.\n"
               "ADDRESS is a virtual: address, such as \"virtual:?object=B&seed=7&fault=loss:0.01\".\n";
        return ExitDone;
    }
    const Expected<VirtualAddress> address = parseArguments(arguments);
    return address ? serve(*address) : fail(address.error());
}
