// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/output.h"
#include "devices/factory/gripper_factory.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

int runDevices(const QStringList& arguments)
{
    CommandLine line(u"devices"_qs,
                     u"Lists the grippers that can be connected; the virtual one is always there."_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    QJsonArray devices;
    QString text =
        u"%1%2%3%4"_qs.arg(u"address"_qs, -28).arg(u"serial"_qs, -16).arg(u"state"_qs, -16).arg(u"name"_qs);
    for (const FoundDevice& device : findDevices()) {
        QJsonObject one{{u"address"_qs, device.address},
                        {u"serial"_qs, device.serial},
                        {u"name"_qs, device.name},
                        {u"state"_qs, device.state}};
        if (!device.toAllow.isEmpty()) {
            one.insert(u"missing"_qs, device.missing);
            one.insert(u"to_allow"_qs, device.toAllow);
        }
        devices.append(one);
        text += u"\n%1%2%3%4"_qs.arg(device.address, -28)
                    .arg(device.serial, -16)
                    .arg(device.state, -16)
                    .arg(device.name);
        if (!device.toAllow.isEmpty())
            text += u"\n  What is missing is %1. Type this in a terminal:\n  %2"_qs.arg(device.missing,
                                                                                        device.toAllow);
    }
    if (line.isSet(u"json"_qs))
        printJson({{u"devices"_qs, devices}});
    else
        print(text);
    return 0;
}

} // namespace gripscope::cli
