// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/sql/library_location.h"
#include "devices/line/mqtt/mqtt_publisher.h"
#include "devices/line/mqtt/outbox_file.h"
#include "devices/line/mqtt/report_json.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace gripscope {

namespace {

/// A disk that is full, or a file that another program has, is asked again.
constexpr std::chrono::seconds diskAgainAfter{1};

} // namespace

struct MqttOutbox::Private {
    QString name;
    Limits limits;
    mutable std::mutex mutex;
    mutable std::condition_variable news, answered;
    bool ending = false, isRead = false;
    std::deque<LineReport> handed, waiting;
    quint64 newest = 0, acknowledged = 0, written = 0; ///< acknowledged: by the broker; written: in the file
    bool birthAsked = false;
    std::optional<std::uint8_t> birth;
    Status status;
    std::function<void()> wake;
    std::unique_ptr<OutboxFile> file; ///< of the thread alone
    std::thread thread;

    void run();
    [[nodiscard]] bool openFile();
    [[nodiscard]] bool work(std::unique_lock<std::mutex>& lock);
    [[nodiscard]] bool store(std::unique_lock<std::mutex>& lock);
    void note(const std::optional<Error>& problem) { status.problem = problem; }
    [[nodiscard]] bool hasWork() const { return birthAsked || acknowledged > written || !handed.empty(); }
};

void MqttOutbox::Private::run()
{
    std::unique_lock lock(mutex);
    while (true) {
        news.wait(lock, [this] { return ending || hasWork() || !file; });
        lock.unlock();
        const bool opened = file || openFile();
        lock.lock();
        const bool done = opened && (!hasWork() || work(lock));
        if (!done) {
            birthAsked = false; // there is none
            answered.notify_all();
        }
        if (ending && (!done || !hasWork()))
            return;
        if (!done)
            news.wait_for(lock, diskAgainAfter, [this] { return ending; });
    }
}

bool MqttOutbox::Private::openFile()
{
    Expected<std::unique_ptr<OutboxFile>> opened = OutboxFile::open(name);
    std::optional<Error> problem;
    if (!opened)
        problem = opened.error();
    else if (!*opened)
        problem =
            Error{ErrorCode::FileUnwritable,
                  {name, Words::say("another program on this computer sends the results of this library")}};
    std::deque<LineReport> kept;
    bool damaged = false;
    if (!problem) {
        file = std::move(*opened);
        damaged = file->contents().damaged;
        for (const OutboxFile::Waiting& one : file->contents().waiting) {
            Expected<LineReport> report = reportFromJson(one.bytes);
            damaged = damaged || !report;
            if (report)
                kept.push_back(std::move(*report));
        }
    }
    const std::lock_guard lock(mutex);
    note(problem);
    if (!file)
        return false;
    isRead = true;
    status.damaged = damaged;
    waiting = std::move(kept);
    newest = file->contents().next - 1;
    written = acknowledged = waiting.empty() ? newest : waiting.front().sequence - 1;
    answered.notify_all();
    if (wake)
        wake();
    return true;
}

bool MqttOutbox::Private::work(std::unique_lock<std::mutex>& lock)
{
    if (acknowledged > written) {
        const quint64 to = acknowledged;
        lock.unlock();
        const Expected<void> done = file->acknowledge(to);
        lock.lock();
        if (!done)
            return note(done.error()), false;
        written = to;
    }
    if (birthAsked) {
        lock.unlock();
        const Expected<std::uint8_t> number = file->nextBirth();
        lock.lock();
        if (!number)
            return note(number.error()), false;
        birthAsked = false;
        birth = *number;
        answered.notify_all();
    }
    return handed.empty() || store(lock);
}

bool MqttOutbox::Private::store(std::unique_lock<std::mutex>& lock)
{
    LineReport report = handed.front();
    const bool full = waiting.size() >= limits.mostWaiting;
    lock.unlock();
    report.sequence = file->contents().next;
    std::optional<Error> problem;
    if (full) {
        if (const Expected<void> skipped = file->skip(); !skipped)
            problem = skipped.error();
    } else if (const auto added = file->add(reportJson(report, false)); !added) {
        problem = added.error();
    }
    lock.lock();
    note(problem);
    if (problem)
        return false; // it stays where it is
    handed.pop_front();
    newest = report.sequence;
    if (full)
        ++status.refused;
    else
        waiting.push_back(std::move(report));
    if (wake)
        wake();
    return true;
}

QString mqttFile(const QString& library)
{
    return fileWithLibrary(library, QStringLiteral(".mqtt"));
}

MqttOutbox::MqttOutbox(const QString& file, const Limits& limits) : d(std::make_unique<Private>())
{
    d->name = file;
    d->limits = limits;
    d->thread = std::thread([p = d.get()] { p->run(); });
}

MqttOutbox::~MqttOutbox()
{
    {
        const std::lock_guard lock(d->mutex);
        d->ending = true;
        d->news.notify_all();
        d->answered.notify_all();
    }
    d->thread.join();
}

void MqttOutbox::offer(const LineReport& report)
{
    const std::lock_guard lock(d->mutex);
    if (d->handed.size() >= d->limits.mostHanded) {
        ++d->status.refused;
        return;
    }
    d->handed.push_back(report);
    d->news.notify_all();
}

bool MqttOutbox::waitUntilRead() const
{
    std::unique_lock lock(d->mutex);
    d->answered.wait(lock, [this] { return d->ending || d->isRead || d->status.problem; });
    return d->isRead;
}

std::vector<LineReport> MqttOutbox::waiting(quint64 behind, std::size_t most) const
{
    const std::lock_guard lock(d->mutex);
    std::vector<LineReport> found;
    auto at =
        std::upper_bound(d->waiting.begin(), d->waiting.end(), behind,
                         [](quint64 sequence, const LineReport& one) { return sequence < one.sequence; });
    for (; at != d->waiting.end() && found.size() < most; ++at)
        found.push_back(*at);
    return found;
}

quint64 MqttOutbox::newest() const
{
    const std::lock_guard lock(d->mutex);
    return d->newest + d->handed.size();
}

void MqttOutbox::acknowledge(quint64 sequence)
{
    const std::lock_guard lock(d->mutex);
    if (sequence <= d->acknowledged)
        return;
    d->acknowledged = sequence;
    while (!d->waiting.empty() && d->waiting.front().sequence <= sequence)
        d->waiting.pop_front();
    d->news.notify_all();
}

std::optional<std::uint8_t> MqttOutbox::nextBirth()
{
    std::unique_lock lock(d->mutex);
    d->birth.reset();
    d->birthAsked = true;
    d->news.notify_all();
    d->answered.wait(lock, [this] { return d->ending || !d->birthAsked; });
    return d->birth;
}

void MqttOutbox::setWake(std::function<void()> wake)
{
    const std::lock_guard lock(d->mutex);
    d->wake = std::move(wake);
}

MqttOutbox::Status MqttOutbox::status() const
{
    const std::lock_guard lock(d->mutex);
    Status status = d->status;
    status.waiting = d->waiting.size() + d->handed.size();
    return status;
}

} // namespace gripscope
