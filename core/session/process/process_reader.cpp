// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/process/process_session.h"

#include <algorithm>
#include <iterator>

namespace gripscope {

namespace {

/// A reading under way, held by the job that does its next stretch.
struct ProcessReading {
    LibraryService* library;
    ProcessQuery query;
    std::shared_ptr<const ProcessValues> known;
    std::shared_ptr<WorkWatch> watch;
    Promise<Expected<ProcessReader::Found>> answer;
    std::shared_ptr<const std::vector<qint64>> voidedBefore = {};
    ProcessPlace place;
    ProcessReader::Found found;
};

/// What was voided since it was read is there no longer. `before`, `now`: ascending numbers.
void dropVoided(ProcessValues& values, const std::vector<qint64>& before, const std::vector<qint64>& now)
{
    std::vector<qint64> since;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(since));
    if (since.empty())
        return;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::binary_search(since.begin(), since.end(), values.numbers[i]))
            kept.push_back(i);
    if (kept.size() == values.size())
        return;
    const auto keep = [&kept]<typename T>(SharedColumn<T>& column) {
        std::vector<T> left;
        left.reserve(kept.size());
        for (const std::size_t place : kept)
            left.push_back(column[place]);
        column = SharedColumn<T>(left);
    };
    keep(values.numbers);
    keep(values.times_ms);
    for (SharedColumn<double>& column : values.quantities)
        keep(column);
    for (SharedColumn<std::uint32_t>* column : {&values.stations, &values.operators, &values.batches})
        keep(*column);
}

Expected<bool> readStretch(ProcessReading& reading, Library& library)
{
    if (reading.watch->stopped())
        return failure(ErrorCode::Cancelled, {});
    if (reading.known) {
        reading.found.values = *reading.known;
        reading.voidedBefore = reading.found.values.voided;
        reading.known.reset();
    }
    ASSIGN_OR_RETURN(reading.place,
                     library.processStretch(reading.query, reading.place, reading.found.values));
    reading.watch->setShare(reading.place.share());
    if (!reading.place.through)
        return false;
    if (reading.voidedBefore && reading.place.voided)
        dropVoided(reading.found.values, *reading.voidedBefore, *reading.place.voided);
    ASSIGN_OR_RETURN(reading.found.limits, library.processLimits(reading.query.type));
    return true;
}

void goOnReading(const std::shared_ptr<ProcessReading>& reading)
{
    const auto step = std::make_shared<Pending<Expected<bool>>>(
        reading->library->run<bool>([reading](Library& library) { return readStretch(*reading, library); }));
    step->whenReady([reading, step] {
        const std::optional<Expected<bool>> done = step->take();
        if (!done)
            return;
        if (!*done)
            reading->answer.give(tl::unexpected(done->error()));
        else if (**done)
            reading->answer.give(std::move(reading->found));
        else if (reading->watch->stopped())
            reading->answer.give(failure(ErrorCode::Cancelled, {}));
        else
            goOnReading(reading);
    });
}

} // namespace

void ProcessReader::start(const ProcessQuery& query, std::shared_ptr<const ProcessValues> known)
{
    cancel();
    m_watch = std::make_shared<WorkWatch>();
    auto reading = std::make_shared<ProcessReading>();
    reading->library = m_library;
    reading->query = query;
    reading->known = std::move(known);
    reading->watch = m_watch;
    m_answer = reading->answer.pending();
    goOnReading(reading);
}

void ProcessReader::cancel()
{
    if (m_watch)
        m_watch->stop();
    m_answer.forget();
}

} // namespace gripscope
