// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/hid_watcher.h"
#include "devices/transport/bounded_thread.h"

#include <QByteArray>
#include <QFile>
#include <QLoggingCategory>

#include <array>
#include <atomic>
#include <cerrno>
#include <libudev.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

// News of hidraw nodes on Linux: from udev, which tells of a node when its rules have run; from the kernel
// where no udev runs (containers, small systems); and from /dev itself, for permissions that a person
// changes, which neither of the two tells.

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Q_LOGGING_CATEGORY(logWatcher, "gripscope.devices.watcher")

/// After news the list is read again after so many milliseconds each.
constexpr std::array settling_ms{20, 100, 500, 2000};

class File {
public:
    explicit File(int file) : m_file(file) {}
    ~File()
    {
        if (m_file >= 0)
            ::close(m_file);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    [[nodiscard]] int number() const { return m_file; }

private:
    int m_file;
};

/// What udev or the kernel tells of hidraw nodes.
class DeviceEvents {
public:
    DeviceEvents() : m_udev(udev_new())
    {
        const bool udevRuns = QFile::exists(u"/run/udev/control"_qs);
        if (m_udev)
            m_monitor.reset(udev_monitor_new_from_netlink(m_udev.get(), udevRuns ? "udev" : "kernel"));
        if (!m_monitor ||
            udev_monitor_filter_add_match_subsystem_devtype(m_monitor.get(), "hidraw", nullptr) < 0 ||
            udev_monitor_enable_receiving(m_monitor.get()) < 0) {
            qCWarning(logWatcher) << "no events from udev or the kernel; only /dev is watched";
            m_monitor.reset();
        }
    }
    [[nodiscard]] int file() const { return m_monitor ? udev_monitor_get_fd(m_monitor.get()) : -1; }
    /// Takes out what is there; true when there was something.
    [[nodiscard]] bool take()
    {
        bool any = false;
        while (udev_device* device = udev_monitor_receive_device(m_monitor.get())) {
            udev_device_unref(device);
            any = true;
        }
        return any;
    }

private:
    struct Release {
        void operator()(udev* context) const { udev_unref(context); }
        void operator()(udev_monitor* monitor) const { udev_monitor_unref(monitor); }
    };
    std::unique_ptr<udev, Release> m_udev;
    std::unique_ptr<udev_monitor, Release> m_monitor;
};

/// What happens to the nodes in /dev.
class NodeEvents {
public:
    NodeEvents() : m_file(inotify_init1(IN_CLOEXEC | IN_NONBLOCK))
    {
        if (m_file.number() < 0 ||
            inotify_add_watch(m_file.number(), "/dev", IN_CREATE | IN_DELETE | IN_ATTRIB) < 0)
            qCWarning(logWatcher) << "/dev cannot be watched; changes of permission show at the next plug";
    }
    [[nodiscard]] int file() const { return m_file.number(); }
    [[nodiscard]] bool take()
    {
        bool any = false;
        alignas(inotify_event) std::array<char, 4096> buffer{};
        for (ssize_t size = 0; (size = ::read(m_file.number(), buffer.data(), buffer.size())) > 0;)
            for (ssize_t at = 0; at < size;) {
                const auto* event = reinterpret_cast<const inotify_event*>(buffer.data() + at);
                any = any ||
                      (event->len > 0 && qstrncmp(static_cast<const char*>(event->name), "hidraw", 6) == 0);
                at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
            }
        return any;
    }

private:
    File m_file;
};

} // namespace

/// What the thread and its owner share; the thread's too, so that it may be left behind.
struct HidWatcher::Shared {
    File wake{eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)}; ///< readable: it is over
    std::mutex mutex;
    Snapshot snapshot; ///< guarded by the mutex
    std::atomic<std::uint64_t> revision{0};

    void look()
    {
        std::vector<HidNode> nodes = listHidNodes();
        const std::lock_guard lock(mutex);
        if (snapshot.revision > 0 && nodes == snapshot.nodes)
            return;
        snapshot = {snapshot.revision + 1, std::move(nodes)};
        revision = snapshot.revision;
    }

    void watch()
    {
        DeviceEvents devices;
        NodeEvents nodes;
        look(); // after the ears are open, so that nothing falls between
        std::size_t settling = settling_ms.size();
        for (;;) {
            std::array<pollfd, 3> waiting{
                {{wake.number(), POLLIN, 0}, {devices.file(), POLLIN, 0}, {nodes.file(), POLLIN, 0}}};
            const int patience_ms = settling < settling_ms.size() ? settling_ms.at(settling) : -1;
            const int ready = ::poll(waiting.data(), waiting.size(), patience_ms);
            if ((ready < 0 && errno != EINTR) || waiting[0].revents != 0)
                return;
            if (ready == 0) {
                ++settling;
                look();
                continue;
            }
            const bool told = waiting[1].revents != 0 && devices.take();
            const bool changed = waiting[2].revents != 0 && nodes.take();
            if (told || changed) {
                settling = 0;
                look();
            }
        }
    }
};

struct HidWatcher::Private {
    std::shared_ptr<Shared> shared = std::make_shared<Shared>();
    BoundedThread thread;
};

HidWatcher::HidWatcher() : d(std::make_unique<Private>())
{
    d->thread = BoundedThread([shared = d->shared] { shared->watch(); });
}

HidWatcher::~HidWatcher()
{
    const std::uint64_t over = 1;
    if (::write(d->shared->wake.number(), &over, sizeof over) != sizeof over)
        qCWarning(logWatcher) << "the watcher's thread cannot be woken";
    constexpr std::chrono::milliseconds mayTake{200}; // reading a list; far more than it needs
    d->thread.finishBy(std::chrono::steady_clock::now() + mayTake);
}

std::uint64_t HidWatcher::revision() const
{
    return d->shared->revision;
}

HidWatcher::Snapshot HidWatcher::snapshot() const
{
    const std::lock_guard lock(d->shared->mutex);
    return d->shared->snapshot;
}

} // namespace gripscope
