// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/report_descriptor.h"
#include "devices/virtual/virtual_firmware.h"

#include <QDir>
#include <QFile>
#include <QString>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <linux/hidraw.h>
#include <mutex>
#include <optional>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>
#include <utility>

#pragma push_macro("signals") // GLib has members of that name
#undef signals
#include <umockdev.h>
#pragma pop_macro("signals")

namespace gripscope::test {

/// A system of its own for this process: /sys, /dev and the news of udev are what the test makes them. Works
/// only in a program that umockdev-wrapper started.
class MockedSystem {
public:
    MockedSystem() : m_bed(umockdev_testbed_new())
    {
        gchar* root = umockdev_testbed_get_root_dir(m_bed);
        m_root = QString::fromUtf8(root);
        g_free(root);
        // Another user works there too, see Unprivileged, and news come through sockets in it.
        ::chmod(qPrintable(m_root), 0777);
        ::umask(0);
        QDir().mkpath(m_root + QStringLiteral("/dev"));
    }
    ~MockedSystem() { g_object_unref(m_bed); }
    MockedSystem(const MockedSystem&) = delete;
    MockedSystem& operator=(const MockedSystem&) = delete;

    [[nodiscard]] UMockdevTestbed* bed() const { return m_bed; }
    [[nodiscard]] const QString& root() const { return m_root; }

private:
    UMockdevTestbed* m_bed;
    QString m_root;
};

/// While it lives, this process has no more rights than any user: root would be let in everywhere.
class Unprivileged {
public:
    static constexpr uid_t nobody = 65534;
    Unprivileged() : m_isRoot(::getuid() == 0)
    {
        if (m_isRoot && ::setresuid(nobody, nobody, 0) != 0)
            qFatal("rights cannot be given up");
    }
    ~Unprivileged()
    {
        if (m_isRoot && ::setresuid(0, 0, 0) != 0)
            qFatal("rights cannot be taken back");
    }
    Unprivileged(const Unprivileged&) = delete;
    Unprivileged& operator=(const Unprivileged&) = delete;

private:
    bool m_isRoot;
};

/// A gripper at /dev/hidrawN: the virtual gripper's firmware behind a pseudo terminal, which has no bounds
/// between reports, so that the next one is written only when the one before was read.
class MockedGripper {
public:
    MockedGripper(MockedSystem& system, int number, std::uint64_t seed)
        : m_system(system), m_firmware(options(seed))
    {
        openTerminal(QStringLiteral("/dev/hidraw%1").arg(number));
        addDevice(number, QByteArray("VG-") + QByteArray::number(static_cast<qulonglong>(seed)));
        tell("add");
    }
    ~MockedGripper() { unplug(); }
    MockedGripper(const MockedGripper&) = delete;
    MockedGripper& operator=(const MockedGripper&) = delete;

    void unplug()
    {
        if (m_master < 0)
            return;
        ::close(m_master); // readers see the end
        ::close(m_slave);
        m_master = -1;
        tell("remove");
        umockdev_testbed_remove_device(m_system.bed(), m_devicePath.constData());
        umockdev_testbed_remove_device(m_system.bed(), m_hidPath.constData());
        umockdev_testbed_detach_ioctl(m_system.bed(), qPrintable(m_node), nullptr);
        QFile::remove(m_system.root() + m_node);
        g_object_unref(m_ioctls);
    }

    /// Who may open it; told by udev, as after its rules ran.
    void setMode(mode_t mode)
    {
        ::fchmod(m_slave, mode);
        tell("change");
    }

    /// One turn of the device: takes commands, sends a report when the program has `taken` the last one.
    void turn(std::uint64_t taken)
    {
        if (m_master < 0)
            return;
        const std::lock_guard lock(m_mutex);
        takeCommands();
        while (m_firmware.outbox().empty())
            m_firmware.sample(now_us());
        if (!wasRead(taken))
            return;
        const protocol::Report& report = m_firmware.outbox().front();
        if (::write(m_master, report.data(), report.size()) != static_cast<ssize_t>(report.size()))
            qFatal("the terminal takes no report");
        m_firmware.outbox().pop_front();
        m_takenBefore = taken;
        m_written = Clock::now();
    }

private:
    using Clock = std::chrono::steady_clock;

    static VirtualFirmwareOptions options(std::uint64_t seed)
    {
        VirtualFirmwareOptions made;
        made.object = VirtualObject::fromText(QStringLiteral("A")).value();
        made.objectName = QStringLiteral("A");
        made.seed = seed;
        return made;
    }
    /// What the watchdog counts by: the computer's time, of which one turn takes 5 ms at most. A busy
    /// computer keeps the program and its heartbeats from the processor together with this device.
    std::uint64_t now_us()
    {
        const Clock::time_point now = Clock::now();
        const auto step =
            std::min<Clock::duration>(now - std::exchange(m_turned, now), std::chrono::milliseconds(5));
        m_time_us +=
            static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(step).count());
        return m_time_us;
    }

    void openTerminal(const QString& node)
    {
        m_node = node;
        char name[64] = {};
        termios raw{};
        ::cfmakeraw(&raw);
        if (::openpty(&m_master, &m_slave, name, &raw, nullptr) != 0)
            qFatal("no pseudo terminal");
        (void)::fchown(m_slave, Unprivileged::nobody, static_cast<gid_t>(-1)); // as root; else it is ours
        QFile::link(QString::fromUtf8(name), m_system.root() + node);
    }

    void addDevice(int number, const QByteArray& serial)
    {
        const QByteArray hid = "0003:1209:0001." + QByteArray::number(number).rightJustified(4, '0');
        const QByteArray port = "usb-mock-" + serial + "/input0";
        m_hidPath = take(umockdev_testbed_add_device(m_system.bed(), "hid", hid.constData(), nullptr, nullptr,
                                                     "HID_ID", "0003:00001209:00000001", "HID_NAME",
                                                     "Mocked gripper", "HID_PHYS", port.constData(),
                                                     "HID_UNIQ", serial.constData(), nullptr));
        std::vector<std::uint8_t> descriptor = protocol::reportDescriptor();
        umockdev_testbed_set_attribute_binary(m_system.bed(), m_hidPath.constData(), "report_descriptor",
                                              descriptor.data(), static_cast<int>(descriptor.size()));
        const QByteArray name = "hidraw" + QByteArray::number(number);
        m_devicePath = take(umockdev_testbed_add_device(m_system.bed(), "hidraw", name.constData(),
                                                        m_hidPath.constData(), nullptr, "DEVNAME",
                                                        qPrintable(m_node), nullptr));
        umockdev_testbed_set_attribute_link(m_system.bed(), m_devicePath.constData(), "device", "..");
        m_ioctls = umockdev_ioctl_base_new();
        g_signal_connect(m_ioctls, "handle-ioctl", G_CALLBACK(&MockedGripper::handleIoctl), this);
        if (!umockdev_testbed_attach_ioctl(m_system.bed(), qPrintable(m_node), m_ioctls, nullptr))
            qFatal("no ioctls for the mocked node");
        const QString socket = m_system.root() + QStringLiteral("/ioctl") + m_node;
        ::chmod(qPrintable(socket), 0777); // who may open the node may ask
    }

    static QByteArray take(gchar* text)
    {
        const QByteArray taken(text);
        g_free(text);
        return taken;
    }

    void tell(const char* action)
    {
        umockdev_testbed_uevent(m_system.bed(), m_devicePath.constData(), action);
    }

    void takeCommands()
    {
        for (;;) {
            pollfd waiting{m_master, POLLIN, 0};
            if (::poll(&waiting, 1, 0) <= 0 || !(waiting.revents & POLLIN))
                return;
            const ssize_t size =
                ::read(m_master, m_command.data() + m_commandSize, m_command.size() - m_commandSize);
            if (size <= 0)
                return;
            m_commandSize += static_cast<std::size_t>(size);
            if (m_commandSize < m_command.size())
                continue;
            m_firmware.receive(m_command, now_us());
            m_commandSize = 0;
        }
    }

    /// By the program's own count; but what it throws away when it begins to read is not counted.
    [[nodiscard]] bool wasRead(std::uint64_t taken) const
    {
        int waiting = 0;
        if (!m_written || ::ioctl(m_slave, FIONREAD, &waiting) != 0)
            return !m_written;
        constexpr std::chrono::milliseconds untilItShows{200};
        return waiting == 0 && (taken != m_takenBefore || Clock::now() - *m_written > untilItShows);
    }

    /// What hidapi asks of a node: the descriptor and its size, and features. On a thread of umockdev.
    static gboolean handleIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, MockedGripper* self)
    {
        const gulong request = umockdev_ioctl_client_get_request(client);
        if (_IOC_TYPE(request) != 'H')
            return FALSE;
        UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
        UMockdevIoctlData* memory = umockdev_ioctl_data_resolve(argument, 0, _IOC_SIZE(request), nullptr);
        if (!memory)
            return FALSE;
        const int result = self->answer(_IOC_NR(request), *memory);
        umockdev_ioctl_client_complete(client, result, result < 0 ? EPIPE : 0);
        g_object_unref(memory);
        return TRUE;
    }

    int answer(unsigned request, UMockdevIoctlData& memory)
    {
        const std::vector<std::uint8_t> descriptor = protocol::reportDescriptor();
        const auto put = [&](const auto* bytes, std::size_t size) {
            umockdev_ioctl_data_update(&memory, 0, const_cast<guint8*>(bytes), static_cast<gint>(size));
        };
        if (request == _IOC_NR(HIDIOCGRDESCSIZE)) {
            const int size = static_cast<int>(descriptor.size());
            put(reinterpret_cast<const guint8*>(&size), sizeof size);
            return 0;
        }
        if (request == _IOC_NR(HIDIOCGRDESC)) {
            hidraw_report_descriptor whole{};
            whole.size = static_cast<std::uint32_t>(descriptor.size());
            std::copy(descriptor.begin(), descriptor.end(), whole.value);
            put(reinterpret_cast<const guint8*>(&whole), sizeof whole);
            return 0;
        }
        if (request != _IOC_NR(HIDIOCGFEATURE(0)))
            return -1;
        const std::lock_guard lock(m_mutex);
        const std::optional<protocol::Report> report = m_firmware.feature(memory.data[0]);
        if (!report)
            return -1;
        put(report->data(), report->size());
        return static_cast<int>(report->size());
    }

    MockedSystem& m_system;
    QString m_node;
    int m_master = -1, m_slave = -1;
    QByteArray m_hidPath, m_devicePath;
    UMockdevIoctlBase* m_ioctls = nullptr;
    std::mutex m_mutex; ///< guards the firmware
    VirtualFirmware m_firmware;
    protocol::Report m_command{};
    std::size_t m_commandSize = 0;
    std::uint64_t m_takenBefore = 0;
    std::optional<Clock::time_point> m_written;
    Clock::time_point m_turned = Clock::now();
    std::uint64_t m_time_us = 1'000'000; ///< of the device
};

} // namespace gripscope::test
