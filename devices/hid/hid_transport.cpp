// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/hid_transport.h"

#include "core/base/words.h"
#include "devices/hid/node_permission.h"

#include <QStringList>
#include <hidapi/hidapi.h>

#include <algorithm>
#include <mutex>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// hid_open_path keeps its error in one text for the whole program.
std::mutex& openingMutex()
{
    static std::mutex mutex;
    return mutex;
}

/// A connection that was closed lets go of its node once its threads have ended, which is bounded by a
/// second.
constexpr std::chrono::milliseconds formerLinkMayTake{1500};

bool matches(const HidAddress& address, const HidNode& node)
{
    const bool named = address.vendor || address.product;
    if (!named && !node.vendorPage)
        return false;
    return node.vendor == address.vendor.value_or(protocol::vendorId) &&
           node.product == address.product.value_or(protocol::productId) &&
           (address.serial.isEmpty() || address.serial == node.serial) &&
           (address.port.isEmpty() || address.port == node.port);
}

QString addressText(const HidAddress& address)
{
    const auto hex = [](std::uint16_t id) { return u"%1"_qs.arg(id, 4, 16, QLatin1Char('0')); };
    QString text = u"hid:"_qs;
    if (address.vendor || address.product)
        text += hex(address.vendor.value_or(protocol::vendorId)) + u':' +
                hex(address.product.value_or(protocol::productId));
    if (!address.serial.isEmpty())
        text += u':' + address.serial;
    return address.port.isEmpty() ? text : text + u"?port="_qs + address.port;
}

} // namespace

std::vector<HidNode> matchingNodes(const HidAddress& address, const std::vector<HidNode>& nodes)
{
    std::vector<HidNode> found;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(found),
                 [&](const HidNode& node) { return matches(address, node); });
    return found;
}

QString addressOf(const HidNode& node, const std::vector<HidNode>& nodes)
{
    HidAddress address{node.vendor, node.product, node.serial};
    const auto alike = std::count_if(nodes.begin(), nodes.end(), [&](const HidNode& other) {
        return other.vendor == node.vendor && other.product == node.product && other.serial == node.serial;
    });
    if (alike > 1)
        address.port = node.port;
    return addressText(address);
}

std::vector<HidNode> grippersAmong(const std::vector<HidNode>& nodes)
{
    return matchingNodes({}, nodes);
}

Expected<HidNode> chooseHidNode(const HidAddress& address, const std::vector<HidNode>& nodes)
{
    const std::vector<HidNode> found = matchingNodes(address, nodes);
    if (found.empty())
        return failure(ErrorCode::DeviceNotFound,
                       {addressText(address),
                        Words::tr("Plug it in and switch it on, or try virtual: without hardware.")});
    if (found.size() > 1) {
        QStringList addresses;
        for (const HidNode& node : found)
            addresses << addressOf(node, nodes);
        return failure(ErrorCode::DeviceAmbiguous, {addresses.join(u", "_qs)});
    }
    if (!found.front().accessible)
        return failure(ErrorCode::DevicePermission, {found.front().path, permissionAdvice(found.front())});
    return found.front();
}

void HidTransport::Closer::operator()(hid_device_* device) const
{
    hid_close(device);
}

HidTransport::HidTransport(HidAddress address) : m_address(std::move(address)) {}

HidTransport::~HidTransport() = default;

Expected<void> HidTransport::open()
{
    const std::vector<HidNode> nodes = listHidNodes();
    ASSIGN_OR_RETURN(const HidNode node, chooseHidNode(m_address, nodes));
    m_path = node.path;
    m_place = {addressOf(node, nodes), node.port};
    ASSIGN_OR_RETURN(NodeClaim claim, NodeClaim::take(m_path, formerLinkMayTake));
    m_claim = std::move(claim);
    const std::lock_guard lock(openingMutex());
    m_reader.reset(hid_open_path(m_path.toUtf8().constData()));
    m_writer.reset(hid_open_path(m_path.toUtf8().constData()));
    if (!m_reader || !m_writer)
        return failure(ErrorCode::DeviceLost, {m_path, QString::fromWCharArray(hid_error(nullptr))});
    return {};
}

Expected<protocol::Report> HidTransport::feature(protocol::ReportId id)
{
    protocol::Report report{};
    report[0] = static_cast<std::uint8_t>(id);
    const int size = hid_get_feature_report(m_writer.get(), report.data(), report.size());
    if (size < 0)
        return failure(ErrorCode::DeviceLost, {m_path, QString::fromWCharArray(hid_error(m_writer.get()))});
    return report; // a short one fails its CRC
}

Transport::ReadResult HidTransport::read(Buffer& buffer, std::chrono::milliseconds timeout)
{
    if (m_closed)
        return {Outcome::Lost};
    if (!m_freshened) {
        // What queued up while the device was asked what it is would be followed by a gap.
        m_freshened = true;
        constexpr int kernelRing = 64;
        for (int i = 0;
             i < kernelRing && hid_read_timeout(m_reader.get(), buffer.data(), buffer.size(), 0) > 0; ++i) {
        }
    }
    const int size =
        hid_read_timeout(m_reader.get(), buffer.data(), buffer.size(), static_cast<int>(timeout.count()));
    if (size < 0)
        return {Outcome::Lost};
    if (size == 0)
        return {Outcome::Timeout};
    return {Outcome::Report, static_cast<std::size_t>(size)};
}

bool HidTransport::write(const protocol::Report& report)
{
    return !m_closed &&
           hid_write(m_writer.get(), report.data(), report.size()) == static_cast<int>(report.size());
}

QString hidapiVersion()
{
    return QString::fromLatin1(hid_version_str());
}

} // namespace gripscope
