// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/mqtt_publisher.h"

#include "devices/line/mqtt/mqtt_connection.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <fcntl.h>
#include <mutex>
#include <poll.h>
#include <unistd.h>

namespace gripscope {

namespace {

using PublisherClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds destructorPatience{40}; ///< the screen's thread may be the one that waits
constexpr std::chrono::milliseconds lastAnswersWithin{500};
constexpr std::chrono::milliseconds turnFor{500};

/// Wakes a thread that polls; from any thread.
class WakePipe {
public:
    WakePipe()
    {
        if (pipe(m_ends.data()) != 0)
            return;
        for (const int end : m_ends) {
            fcntl(end, F_SETFL, O_NONBLOCK);
            fcntl(end, F_SETFD, FD_CLOEXEC);
        }
    }
    ~WakePipe()
    {
        for (const int end : m_ends)
            if (end >= 0)
                close(end);
    }
    WakePipe(const WakePipe&) = delete;
    WakePipe& operator=(const WakePipe&) = delete;

    void wake() const { static_cast<void>(!write(m_ends[1], "w", 1)); } // a full pipe wakes as well
    void clear() const
    {
        std::array<char, 64> bytes{};
        while (read(m_ends[0], bytes.data(), bytes.size()) > 0) {
        }
    }
    [[nodiscard]] int descriptor() const { return m_ends[0]; }
    void wait(std::chrono::milliseconds most) const
    {
        pollfd watched{m_ends[0], POLLIN, 0};
        poll(&watched, 1, static_cast<int>(most.count()));
        clear();
    }

private:
    std::array<int, 2> m_ends{-1, -1};
};

} // namespace

struct MqttPublisher::Shared {
    Shared(const MqttOptions& wanted, std::shared_ptr<MqttOutbox> from)
        : options(wanted), outbox(std::move(from)), retry(wanted.retryFirst)
    {
        link.on = true;
        link.broker = options.broker();
        link.host = options.primaryHost;
        link.since = QDateTime::currentDateTimeUtc();
    }

    const MqttOptions options;
    const std::shared_ptr<MqttOutbox> outbox;
    const std::shared_ptr<WakePipe> pipe = std::make_shared<WakePipe>();
    std::atomic<bool> ending{false};
    mutable std::mutex mutex; ///< guards what follows
    std::condition_variable ended;
    bool hasEnded = false;
    QString gripper;
    MqttLink link;
    std::chrono::milliseconds retry; ///< of the thread alone

    void run();
    [[nodiscard]] Expected<void> attempt();
    [[nodiscard]] Expected<void> keepUp(MqttConnection& connection, MqttSession& session);
    void work(MqttSession& session);
    void farewell(MqttConnection& connection, MqttSession& session);
    void tell(bool connected, bool waitsForHost, const std::optional<Error>& problem);
};

void MqttPublisher::Shared::tell(bool connected, bool waitsForHost, const std::optional<Error>& problem)
{
    const std::lock_guard lock(mutex);
    if (connected != link.connected)
        link.since = QDateTime::currentDateTimeUtc();
    link.connected = connected;
    link.waitsForHost = waitsForHost;
    link.problem = problem;
}

void MqttPublisher::Shared::run()
{
    while (!ending) {
        const Expected<void> done = attempt();
        if (ending)
            break;
        tell(false, false, done ? std::nullopt : std::optional(done.error()));
        const auto again = PublisherClock::now() + retry;
        retry = std::min(2 * retry, options.retryMost);
        while (!ending && PublisherClock::now() < again)
            pipe->wait(std::chrono::ceil<std::chrono::milliseconds>(again - PublisherClock::now()));
    }
    const std::lock_guard lock(mutex);
    hasEnded = true;
    ended.notify_all();
}

Expected<void> MqttPublisher::Shared::attempt()
{
    std::optional<std::uint8_t> birth;
    if (outbox->waitUntilRead()) // what an earlier program left waits, and is to be known as such
        birth = options.sparkplug() ? outbox->nextBirth() : 0;
    if (!birth)
        return tl::make_unexpected(outbox->status().problem.value_or(Error()));
    MqttConnection connection(options);
    MqttSession session(options, *birth, connection);
    RETURN_IF_ERROR(connection.open(session));
    const Expected<void> kept = keepUp(connection, session);
    if (kept)
        farewell(connection, session);
    return kept;
}

Expected<void> MqttPublisher::Shared::keepUp(MqttConnection& connection, MqttSession& session)
{
    while (!ending && !session.left()) {
        work(session);
        RETURN_IF_ERROR(connection.turn(pipe->descriptor(), turnFor));
        pipe->clear();
    }
    return {};
}

void MqttPublisher::Shared::work(MqttSession& session)
{
    QString present;
    {
        const std::lock_guard lock(mutex);
        present = gripper;
    }
    const QDateTime now = QDateTime::currentDateTimeUtc();
    outbox->acknowledge(session.acknowledgedTo());
    session.step(present, outbox->newest(), now);
    if (session.ready() || session.waitsForHost())
        tell(session.ready(), session.waitsForHost(), {});
    if (session.ready())
        retry = options.retryFirst;
    if (const std::size_t room = session.room(); room > 0)
        session.send(outbox->waiting(session.sentTo(), room), now);
}

void MqttPublisher::Shared::farewell(MqttConnection& connection, MqttSession& session)
{
    // What was sent is acknowledged first, so that it is not sent again.
    const auto until = PublisherClock::now() + lastAnswersWithin;
    while (!session.allAcknowledged() && PublisherClock::now() < until)
        if (!connection.turn(pipe->descriptor(), std::chrono::milliseconds(50)))
            return;
    outbox->acknowledge(session.acknowledgedTo());
    if (!session.left())
        session.leave();
    connection.close();
    static_cast<void>(connection.turn(pipe->descriptor(), std::chrono::milliseconds(0)));
}

MqttPublisher::MqttPublisher(const MqttOptions& options, std::shared_ptr<MqttOutbox> outbox)
    : d(std::make_shared<Shared>(options, std::move(outbox)))
{
    d->outbox->setWake([pipe = d->pipe] { pipe->wake(); });
    m_thread = std::thread([shared = d] { shared->run(); });
}

MqttPublisher::~MqttPublisher()
{
    static_cast<void>(end(destructorPatience));
}

bool MqttPublisher::end(std::chrono::milliseconds patience)
{
    if (!m_thread.joinable())
        return true;
    d->ending = true;
    d->pipe->wake();
    d->outbox->setWake({});
    std::unique_lock lock(d->mutex);
    const bool done = d->ended.wait_for(lock, patience, [this] { return d->hasEnded; });
    lock.unlock();
    done ? m_thread.join() : m_thread.detach(); // it has all that it needs
    return done;
}

void MqttPublisher::setGripper(const QString& serial)
{
    const std::lock_guard lock(d->mutex);
    if (d->gripper == serial)
        return;
    d->gripper = serial;
    d->pipe->wake();
}

MqttLink MqttPublisher::link() const
{
    const MqttOutbox::Status outbox = d->outbox->status();
    const std::lock_guard lock(d->mutex);
    MqttLink link = d->link;
    link.waiting = outbox.waiting;
    link.refused = outbox.refused;
    link.damaged = outbox.damaged;
    link.stored = outbox.problem;
    return link;
}

} // namespace gripscope
