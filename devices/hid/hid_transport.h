// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/address/device_address.h"
#include "devices/hid/hid_discovery.h"
#include "devices/hid/node_claim.h"
#include "devices/transport/transport.h"

#include <atomic>
#include <memory>

struct hid_device_;

namespace gripscope {

/// The node that an address means. DeviceNotFound, DeviceAmbiguous (with the addresses that would each be
/// clear), DevicePermission.
[[nodiscard]] Expected<HidNode> chooseHidNode(const HidAddress& address, const std::vector<HidNode>& nodes);
/// Those that an address may mean, whether or not they may be opened.
[[nodiscard]] std::vector<HidNode> matchingNodes(const HidAddress& address,
                                                 const std::vector<HidNode>& nodes);
/// The address that means `node` and no other of `nodes`: `hid:1209:0001:SERIAL`, and where another one has
/// the same serial number, or both have none, the port with it.
[[nodiscard]] QString addressOf(const HidNode& node, const std::vector<HidNode>& nodes);
/// Those with the identity of the Gripscope protocol.
[[nodiscard]] std::vector<HidNode> grippersAmong(const std::vector<HidNode>& nodes);

/// A gripper on USB-HID through hidapi. Reading and writing go through handles of their own: hidapi keeps the
/// last error's text in the handle without a lock, so one handle may not be used by two threads at a time.
class HidTransport : public Transport {
public:
    explicit HidTransport(HidAddress address);
    ~HidTransport() override;

    Expected<void> open() override;
    Expected<protocol::Report> feature(protocol::ReportId id) override;
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override;
    bool write(const protocol::Report& report) override;
    void writeOnCrash(const protocol::Report& report) override { m_claim.writeOnCrash(report); }
    [[nodiscard]] Place place() const override { return m_place; }
    /// The handles stay open until the last user of this object lets go of it: hidapi must not close one that
    /// another thread is using.
    void close() noexcept override { m_closed = true; }

private:
    struct Closer {
        void operator()(hid_device_* device) const;
    };
    using Handle = std::unique_ptr<hid_device_, Closer>;

    HidAddress m_address;
    QString m_path;
    Place m_place;     ///< set by open()
    NodeClaim m_claim; ///< held until the handles are closed
    Handle m_reader, m_writer;
    bool m_freshened = false; ///< reader's own: old reports were thrown away
    std::atomic<bool> m_closed{false};
};

/// Of the hidapi that runs.
[[nodiscard]] QString hidapiVersion();

} // namespace gripscope
