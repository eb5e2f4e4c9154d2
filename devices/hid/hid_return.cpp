// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/hid_return.h"

#include "devices/hid/hid_transport.h"

namespace gripscope {

namespace {

constexpr int mostAttempts = 6; ///< at one state of things; 3 s in all
constexpr std::chrono::milliseconds firstPause{50};

QStringList instancesOf(const std::vector<HidNode>& nodes)
{
    QStringList instances;
    for (const HidNode& node : nodes)
        instances << node.instance;
    return instances;
}

} // namespace

std::optional<HidNode> returnedNode(const HidAddress& lost, const QString& port,
                                    const std::vector<HidNode>& nodes, const QStringList& thereBefore)
{
    const HidAddress anywhere{lost.vendor, lost.product, lost.serial};
    std::vector<HidNode> alike = matchingNodes(anywhere, nodes);
    if (lost.serial.isEmpty())
        return alike.size() == 1 && alike.front().port == port ? std::optional(alike.front()) : std::nullopt;
    alike.erase(std::remove_if(alike.begin(), alike.end(),
                               [&](const HidNode& node) {
                                   return node.port != port && thereBefore.contains(node.instance);
                               }),
                alike.end());
    return alike.size() == 1 ? std::optional(alike.front()) : std::nullopt;
}

HidReturn::HidReturn(HidAddress asked, AwaitedGripper awaited, PortMaker makePort)
    : m_asked(std::move(asked)), m_awaited(std::move(awaited)), m_makePort(std::move(makePort))
{
}

std::optional<HidNode> HidReturn::choose(const std::vector<HidNode>& nodes) const
{
    const Expected<DeviceAddress> parsed = parseDeviceAddress(m_awaited.identity.address);
    const auto* lost = parsed ? std::get_if<HidAddress>(&*parsed) : nullptr;
    if (!lost) { // none was connected yet: whichever the person meant
        const std::vector<HidNode> found = matchingNodes(m_asked, nodes);
        return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
    }
    const std::optional<HidNode> node = returnedNode(*lost, m_awaited.identity.port, nodes, *m_thereBefore);
    // One that opens and stays silent would only be opened and lost again and again.
    if (node && !m_awaited.worthATry && m_thereBefore->contains(node->instance))
        return std::nullopt;
    return node;
}

std::unique_ptr<GripperPort> HidReturn::take()
{
    const std::uint64_t revision = m_watcher.revision();
    if (revision == 0)
        return nullptr;
    const bool news = revision != m_triedRevision;
    const Clock::time_point now = Clock::now();
    if (!news && (m_attempts >= mostAttempts || now < m_nextAttempt))
        return nullptr;
    const HidWatcher::Snapshot seen = m_watcher.snapshot();
    if (!m_thereBefore)
        m_thereBefore = instancesOf(seen.nodes);
    if (news)
        m_attempts = 0;
    m_triedRevision = seen.revision;
    const std::optional<HidNode> node = choose(seen.nodes);
    if (!node) {
        m_attempts = mostAttempts;
        return nullptr;
    }
    m_nextAttempt = now + firstPause * (1 << m_attempts++);
    return m_makePort({node->vendor, node->product, node->serial, m_asked.capture, node->port});
}

} // namespace gripscope
