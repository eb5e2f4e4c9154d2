// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QEvent>
#include <QFile>
#include <QString>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

#ifdef Q_OS_LINUX
#include <unistd.h>
#endif

namespace gripscope::test {

/// Watches the thread that made it: another thread sends it an event, again and again, and takes the time
/// until it is answered. The longest wait is how long a click would have waited. Time during which the thread
/// wanted to run and the machine was busy with others is not counted, where the system tells (Linux).
class ScreenWatch {
public:
    ScreenWatch() : m_receiver(*this), m_schedule(scheduleFile()), m_pinger([this] { ping(); }) {}
    ~ScreenWatch()
    {
        {
            const std::lock_guard lock(m_mutex);
            m_closing = true;
        }
        m_answered.notify_all();
        m_pinger.join();
        QCoreApplication::removePostedEvents(&m_receiver);
    }
    ScreenWatch(const ScreenWatch&) = delete;
    ScreenWatch& operator=(const ScreenWatch&) = delete;

    /// What is being done from now on.
    void step(const QString& name)
    {
        const std::lock_guard lock(m_mutex);
        m_step = name;
    }
    /// The longest wait of each step, in milliseconds.
    [[nodiscard]] std::map<QString, double> longest_ms() const
    {
        const std::lock_guard lock(m_mutex);
        return m_longest_ms;
    }
    [[nodiscard]] long answers() const { return m_count; }

private:
    using Clock = std::chrono::steady_clock;

    class Receiver : public QObject {
    public:
        explicit Receiver(ScreenWatch& watch) : m_watch(&watch) {}
        bool event(QEvent* event) override
        {
            if (event->type() != QEvent::User)
                return QObject::event(event);
            const std::lock_guard lock(m_watch->m_mutex);
            m_watch->m_waiting = false;
            m_watch->m_answered.notify_all();
            return true;
        }

    private:
        ScreenWatch* m_watch;
    };

    static QString scheduleFile()
    {
#ifdef Q_OS_LINUX
        return QStringLiteral("/proc/self/task/%1/schedstat").arg(gettid());
#else
        return {};
#endif
    }
    /// Milliseconds that the watched thread has waited for a processor so far.
    [[nodiscard]] double starved_ms() const
    {
        QFile file(m_schedule);
        if (m_schedule.isEmpty() || !file.open(QIODevice::ReadOnly))
            return 0;
        const QList<QByteArray> fields = file.readAll().split(' ');
        return fields.size() < 2 ? 0 : 1e-6 * fields[1].toDouble();
    }

    void ping()
    {
        std::unique_lock lock(m_mutex);
        while (!m_closing) {
            const QString step = m_step;
            const double starvedBefore_ms = starved_ms();
            const Clock::time_point posted = Clock::now();
            m_waiting = true;
            QCoreApplication::postEvent(&m_receiver, new QEvent(QEvent::User), Qt::HighEventPriority);
            m_answered.wait(lock, [this] { return !m_waiting || m_closing; });
            const double waited_ms =
                std::chrono::duration<double, std::milli>(Clock::now() - posted).count() -
                (starved_ms() - starvedBefore_ms);
            double& longest_ms = m_longest_ms[step];
            longest_ms = std::max(longest_ms, waited_ms);
            ++m_count;
            m_answered.wait_for(lock, std::chrono::milliseconds(2), [this] { return m_closing; });
        }
    }

    mutable std::mutex m_mutex; ///< guards all but the count
    std::condition_variable m_answered;
    bool m_waiting = false, m_closing = false;
    QString m_step = QStringLiteral("start");
    std::map<QString, double> m_longest_ms;
    std::atomic<long> m_count{0};
    Receiver m_receiver;
    const QString m_schedule;
    std::thread m_pinger; ///< last: it uses all the others
};

} // namespace gripscope::test
