// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace gripscope {

enum class ReportDirection : std::uint8_t { In, Out, Feature };

/// A report as it passed, good or bad.
struct LoggedReport {
    std::uint64_t number = 0; ///< counts all that passed
    std::chrono::steady_clock::time_point time;
    ReportDirection direction = ReportDirection::In;
    bool taken = true; ///< false: an output report that the device did not take
    std::uint8_t size = 0;
    static constexpr std::size_t longest = 128; ///< twice a report, to notice long ones
    std::array<std::uint8_t, longest> bytes{};
    [[nodiscard]] std::span<const std::uint8_t> view() const { return std::span(bytes).first(size); }
};

/// The last reports of a link in a ring that is made once. Who reads or writes the device never waits for
/// whoever looks: while the ring is being copied, reports pass without being kept, and are counted.
class ReportLog {
public:
    static constexpr std::size_t capacity = 256;

    ReportLog() : m_ring(capacity) {}
    void add(ReportDirection direction, std::span<const std::uint8_t> bytes, bool taken = true) noexcept;
    /// Oldest first.
    [[nodiscard]] std::vector<LoggedReport> last() const;
    [[nodiscard]] std::uint64_t missed() const { return m_missed.load(); }

private:
    mutable std::mutex m_mutex; ///< add() only tries it
    std::vector<LoggedReport> m_ring;
    std::uint64_t m_kept = 0;
    std::atomic<std::uint64_t> m_passed{0}, m_missed{0};
};

} // namespace gripscope
