// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/address/device_address.h"
#include "devices/hid/hid_discovery.h"
#include "devices/hid/hid_transport.h"
#include "devices/inspection/device_facts.h"
#include "devices/protocol/report_descriptor.h"

#include <QFile>
#include <QFileInfo>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

std::vector<std::uint8_t> descriptorOf(const HidNode& node)
{
    QFile file(u"/sys/class/hidraw/%1/device/report_descriptor"_qs.arg(QFileInfo(node.path).fileName()));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray bytes = file.readAll();
    return {bytes.begin(), bytes.end()};
}

} // namespace

DeviceFacts findDeviceFacts(const QString& address, const QString& serial)
{
    const Expected<DeviceAddress> parsed = parseDeviceAddress(address);
    if (!parsed)
        return {};
    if (std::holds_alternative<VirtualAddress>(*parsed))
        return {{}, {}, protocol::reportDescriptor()};
    const auto* hid = std::get_if<HidAddress>(&*parsed);
    if (!hid)
        return {};
    HidAddress wanted = *hid;
    if (wanted.serial.isEmpty())
        wanted.serial = serial;
    const Expected<HidNode> node = chooseHidNode(wanted, listHidNodes());
    if (!node)
        return {};
    const auto hex = [](std::uint16_t id) { return u"%1"_qs.arg(id, 4, 16, QLatin1Char('0')); };
    return {node->path, hex(node->vendor) + u':' + hex(node->product), descriptorOf(*node)};
}

} // namespace gripscope
