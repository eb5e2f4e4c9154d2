// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "devices/hid/node_claim.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace gripscope {

Expected<NodeClaim> NodeClaim::take(const QString& path, std::chrono::milliseconds patience)
{
    const int descriptor = ::open(path.toUtf8().constData(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        return failure(ErrorCode::DeviceLost, {path, QString::fromLocal8Bit(std::strerror(errno))});
    NodeClaim claim(descriptor);
    const auto until = std::chrono::steady_clock::now() + patience;
    while (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK)
            return failure(ErrorCode::DeviceLost, {path, QString::fromLocal8Bit(std::strerror(errno))});
        if (std::chrono::steady_clock::now() > until)
            return failure(ErrorCode::DeviceRefused,
                           {Words::tr("be opened"),
                            Words::tr("another program uses it. Close that program or disconnect the gripper "
                                      "there, then connect again")});
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return claim;
}

NodeClaim::NodeClaim(NodeClaim&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1)), m_onCrash(std::move(other.m_onCrash))
{
}

NodeClaim& NodeClaim::operator=(NodeClaim&& other) noexcept
{
    std::swap(m_descriptor, other.m_descriptor);
    m_onCrash = std::move(other.m_onCrash);
    return *this;
}

NodeClaim::~NodeClaim()
{
    m_onCrash = {};
    if (m_descriptor >= 0)
        close(m_descriptor); // the lock goes with it
}

} // namespace gripscope
