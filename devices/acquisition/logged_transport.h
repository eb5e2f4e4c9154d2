// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/acquisition/report_log.h"

#include <algorithm>
#include <utility>

namespace gripscope {

/// Any transport, with what passed last kept in a log.
class LoggedTransport : public Transport {
public:
    LoggedTransport(std::shared_ptr<Transport> inner, std::shared_ptr<ReportLog> log)
        : m_inner(std::move(inner)), m_log(std::move(log))
    {
    }

    Expected<void> open() override { return m_inner->open(); }
    Expected<protocol::Report> feature(protocol::ReportId id) override
    {
        Expected<protocol::Report> report = m_inner->feature(id);
        if (report)
            m_log->add(ReportDirection::Feature, *report);
        return report;
    }
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override
    {
        const ReadResult result = m_inner->read(buffer, timeout);
        if (result.outcome == Outcome::Report)
            m_log->add(ReportDirection::In,
                       protocol::ReportView(buffer).first(std::min(result.size, buffer.size())));
        return result;
    }
    bool write(const protocol::Report& report) override
    {
        const bool taken = m_inner->write(report);
        m_log->add(ReportDirection::Out, report, taken);
        return taken;
    }
    void close() noexcept override { m_inner->close(); }
    [[nodiscard]] Place place() const override { return m_inner->place(); }
    [[nodiscard]] bool streamsAlways() const override { return m_inner->streamsAlways(); }
    [[nodiscard]] bool waitsForReader() const override { return m_inner->waitsForReader(); }
    [[nodiscard]] bool takesCommands() const override { return m_inner->takesCommands(); }
    void note(const QString& text) override { m_inner->note(text); }
    [[nodiscard]] QString keptSession() const override { return m_inner->keptSession(); }

private:
    const std::shared_ptr<Transport> m_inner;
    const std::shared_ptr<ReportLog> m_log;
};

} // namespace gripscope
