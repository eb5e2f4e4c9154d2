// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <vector>

namespace gripscope {

/// A HID device as the system lists it.
struct HidNode {
    QString path; ///< what hid_open_path takes, such as /dev/hidraw0
    std::uint16_t vendor = 0, product = 0;
    QString serial, name;
    bool vendorPage = false; ///< its report descriptor begins with the vendor-defined usage page 0xFF00
    bool accessible = false; ///< this user may read and write it
    QString port{}; ///< where it is plugged in, such as usb-0000:00:14.0-2/input0; stays the same when it is
                    ///< plugged in there again
    QString instance{}; ///< another one each time it is plugged in

    friend bool operator==(const HidNode&, const HidNode&) = default;
};

/// Every HID device there is, in the order of their paths. It reads the system's own list; hidapi's
/// enumeration (before 0.15) crashes when a device goes away during the call. The folders are for tests.
[[nodiscard]] std::vector<HidNode>
listHidNodes(const QString& classFolder = QStringLiteral("/sys/class/hidraw"),
             const QString& deviceFolder = QStringLiteral("/dev"));

} // namespace gripscope
