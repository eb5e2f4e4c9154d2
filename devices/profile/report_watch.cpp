// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/report_watch.h"

#include "core/base/words.h"
#include "devices/profile/profile_codec.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;
using Clock = std::chrono::steady_clock;

/// What the listening thread and the owner have in common; the thread may outlive the owner.
struct ReportWatch::Shared {
    std::shared_ptr<Transport> transport;
    std::mutex mutex; ///< guards all below
    bool ending = false;
    Snapshot seen;
    std::unique_ptr<ProfileDecoder> decoder;
    std::optional<std::uint8_t> reportId; ///< the profile's
    std::vector<Sample> batch;

    void take(protocol::ReportView report, double time_s);
    void decode(protocol::ReportView report);
    void end(std::optional<Error> error);
};

void ReportWatch::Shared::take(protocol::ReportView report, double time_s)
{
    const std::lock_guard lock(mutex);
    ReportKind kind{report.size(), std::nullopt};
    if (reportId && !report.empty())
        kind.id = report[0];
    seen.kinds[kind].take(report, time_s);
    seen.newest = kind;
    decode(report);
}

void ReportWatch::Shared::decode(protocol::ReportView report)
{
    if (!decoder)
        return;
    batch.clear();
    const ReportDecoder::Taken taken = decoder->take(report, batch);
    seen.badReports += std::holds_alternative<protocol::DecodeError>(taken) ? 1 : 0;
    seen.otherReports += std::holds_alternative<ReportDecoder::Other>(taken) ? 1 : 0;
    seen.restarted = seen.restarted || std::holds_alternative<ReportDecoder::Restarted>(taken);
    const ReportDecoder::Counts counts = decoder->counts();
    seen.lostSamples = counts.lostSamples;
    seen.duplicateReports = counts.duplicateReports;
    seen.samples += batch.size();
    seen.fresh.insert(seen.fresh.end(), batch.begin(), batch.end());
    if (seen.fresh.size() > mostFresh)
        seen.fresh.erase(seen.fresh.begin(), seen.fresh.end() - static_cast<std::ptrdiff_t>(mostFresh / 2));
}

void ReportWatch::Shared::end(std::optional<Error> error)
{
    const std::lock_guard lock(mutex);
    seen.state = State::Ended;
    seen.error = std::move(error);
}

ReportWatch::ReportWatch() = default;

ReportWatch::~ReportWatch()
{
    stop();
}

void ReportWatch::run(const std::shared_ptr<Shared>& shared)
{
    if (const Expected<void> opened = shared->transport->open(); !opened)
        return shared->end(opened.error());
    {
        const std::lock_guard lock(shared->mutex);
        shared->seen.state = State::Listening;
    }
    const Clock::time_point start = Clock::now();
    Transport::Buffer buffer{};
    for (;;) {
        const Transport::ReadResult result = shared->transport->read(buffer, std::chrono::milliseconds(20));
        if (result.outcome == Transport::Outcome::Report)
            shared->take(protocol::ReportView(buffer).first(std::min(result.size, buffer.size())),
                         std::chrono::duration<double>(Clock::now() - start).count());
        if (result.outcome == Transport::Outcome::Lost)
            return shared->end(
                Error{ErrorCode::DeviceLost,
                      {Words::tr("that address"), Words::tr("it was unplugged or switched off")}});
        if (result.outcome == Transport::Outcome::Ended)
            return shared->end(std::nullopt);
        const std::lock_guard lock(shared->mutex);
        if (shared->ending)
            return;
    }
}

void ReportWatch::start(std::shared_ptr<Transport> transport)
{
    stop();
    m_shared = std::make_shared<Shared>();
    m_shared->transport = std::move(transport);
    m_shared->seen.state = State::Opening;
    use(m_profile);
    m_thread = BoundedThread([shared = m_shared] { run(shared); });
}

void ReportWatch::stop(std::chrono::milliseconds atMost)
{
    if (!m_shared)
        return;
    {
        const std::lock_guard lock(m_shared->mutex);
        m_shared->ending = true;
    }
    m_shared->transport->close();
    m_thread.finishBy(Clock::now() + atMost);
    m_shared.reset();
}

void ReportWatch::use(const std::optional<GripperProfile>& profile)
{
    m_profile = profile;
    if (!m_shared)
        return;
    const std::lock_guard lock(m_shared->mutex);
    m_shared->decoder = profile ? std::make_unique<ProfileDecoder>(*profile) : nullptr;
    const std::optional<std::uint8_t> id = profile ? profile->reportId : std::nullopt;
    Snapshot& seen = m_shared->seen;
    if (id.has_value() != m_shared->reportId.has_value())
        seen.kinds.clear(); // they are told apart by other means now
    m_shared->reportId = id;
    seen.samples = seen.lostSamples = seen.duplicateReports = seen.badReports = seen.otherReports = 0;
    seen.restarted = false;
    seen.fresh.clear();
}

ReportWatch::Snapshot ReportWatch::snapshot()
{
    if (!m_shared)
        return {};
    const std::lock_guard lock(m_shared->mutex);
    Snapshot copy = m_shared->seen;
    m_shared->seen.fresh.clear();
    return copy;
}

} // namespace gripscope
