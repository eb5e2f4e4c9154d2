// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"
#include "devices/profile/report_statistics.h"
#include "devices/transport/bounded_thread.h"
#include "devices/transport/transport.h"

#include <map>
#include <tuple>

namespace gripscope {

/// Which reports belong together: those of one length that begin with the same report ID, where they do.
struct ReportKind {
    std::size_t length = 0;
    std::optional<std::uint8_t> id; ///< only where the profile says that the first byte is one
    friend bool operator==(const ReportKind&, const ReportKind&) = default;
    friend bool operator<(const ReportKind& a, const ReportKind& b)
    {
        return std::tie(a.length, a.id) < std::tie(b.length, b.id);
    }
};

/// The bytes of a gripper as they come, and what a profile makes of them, for whoever writes that profile.
///
/// Listens in a thread of its own, beside any connection; start(), use() and snapshot() return at once.
/// Belongs to one thread.
class ReportWatch {
public:
    enum class State { Idle, Opening, Listening, Ended };
    struct Snapshot {
        State state = State::Idle;
        std::optional<Error> error;                   ///< why it ended, or could not begin
        std::map<ReportKind, ReportStatistics> kinds; ///< since start()
        ReportKind newest;                            ///< the kind of the last report
        /// By the profile, since it was set: numbers as in the last report, and what came of all.
        std::uint64_t samples = 0, lostSamples = 0, duplicateReports = 0, badReports = 0, otherReports = 0;
        bool restarted = false;
        std::vector<Sample> fresh; ///< since the snapshot before; the oldest are dropped when there are many
    };
    static constexpr std::size_t mostFresh = 20000;

    ReportWatch();
    ~ReportWatch();
    ReportWatch(const ReportWatch&) = delete;
    ReportWatch& operator=(const ReportWatch&) = delete;

    /// Ends what ran before and begins anew.
    void start(std::shared_ptr<Transport> transport);
    /// Waits so long at most for the listening thread; one that takes longer ends by itself.
    void stop(std::chrono::milliseconds atMost = std::chrono::milliseconds(0));
    /// Reads the reports by `profile` from now on; nothing: bytes only.
    void use(const std::optional<GripperProfile>& profile);
    [[nodiscard]] Snapshot snapshot();

private:
    struct Shared;
    static void run(const std::shared_ptr<Shared>& shared);

    std::shared_ptr<Shared> m_shared;
    std::optional<GripperProfile> m_profile;
    BoundedThread m_thread;
};

} // namespace gripscope
