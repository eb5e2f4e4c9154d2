// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library_service.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace gripscope {

namespace {

struct Job {
    Acting acting; ///< who asked for it
    std::function<void(Expected<Library*>)> work;
    std::function<void(const Acting&)> closed = {}; ///< instead, without the library
    std::chrono::steady_clock::time_point asked = std::chrono::steady_clock::now();
};

} // namespace

struct LibraryService::Private {
    QString file;
    mutable std::mutex mutex; ///< guards jobs, acting, guest and ending
    std::condition_variable wake;
    std::deque<Job> jobs;
    Acting acting;
    std::weak_ptr<LibraryGuest> guest;
    bool ending = false;
    std::thread thread;

    /// The next job, or none when the service ends and the queue is empty.
    std::optional<Job> next()
    {
        std::unique_lock lock(mutex);
        wake.wait(lock, [this] { return ending || !jobs.empty(); });
        if (jobs.empty())
            return {};
        Job job = std::move(jobs.front());
        jobs.pop_front();
        return job;
    }

    /// While nobody in this program has the file open.
    void runAlone(const Job& job)
    {
        std::shared_ptr<LibraryGuest> other;
        {
            const std::lock_guard lock(mutex);
            other = guest.lock();
        }
        if (other)
            other->leave();
        job.closed(job.acting);
        if (other)
            other->comeBack();
    }

    /// A library that does not open is tried again with the next job: a disk may have come back. A server
    /// that does not answer takes seconds to say so: who has asked meanwhile has that answer.
    void loop()
    {
        std::unique_ptr<Library> library;
        std::optional<Error> problem;
        std::chrono::steady_clock::time_point tried;
        while (auto job = next()) {
            if (job->closed) {
                library.reset();
                runAlone(*job);
                continue;
            }
            if (!library) {
                if (problem && job->asked < tried && Library::isOnServer(file)) {
                    job->work(tl::unexpected(*problem));
                    continue;
                }
                auto opened = Library::open(file);
                tried = std::chrono::steady_clock::now();
                if (!opened) {
                    problem = opened.error();
                    job->work(tl::unexpected(opened.error()));
                    continue;
                }
                library = std::move(*opened);
            }
            library->actAs(job->acting);
            job->work(library.get());
        }
    }
};

LibraryService::LibraryService(QString file) : d(std::make_unique<Private>())
{
    d->file = std::move(file);
    d->thread = std::thread([p = d.get()] { p->loop(); });
}

LibraryService::~LibraryService()
{
    {
        const std::lock_guard lock(d->mutex);
        d->ending = true;
    }
    d->wake.notify_one();
    d->thread.join();
}

QString LibraryService::file() const
{
    return d->file;
}

void LibraryService::setGuest(std::weak_ptr<LibraryGuest> guest)
{
    const std::lock_guard lock(d->mutex);
    d->guest = std::move(guest);
}

void LibraryService::actAs(const Acting& acting)
{
    const std::lock_guard lock(d->mutex);
    d->acting = acting;
}

void LibraryService::post(std::function<void(Expected<Library*>)> job)
{
    {
        const std::lock_guard lock(d->mutex);
        d->jobs.push_back({d->acting, std::move(job)});
    }
    d->wake.notify_one();
}

void LibraryService::postClosed(std::function<void(const Acting&)> job)
{
    {
        const std::lock_guard lock(d->mutex);
        d->jobs.push_back({d->acting, {}, std::move(job)});
    }
    d->wake.notify_one();
}

} // namespace gripscope
