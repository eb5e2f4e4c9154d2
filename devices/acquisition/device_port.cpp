// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/device_port.h"

#include "core/session/connection/report_log.h"
#include "devices/acquisition/device_link.h"
#include "devices/transport/bounded_thread.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

namespace gripscope {

namespace {

/// Those of this program that are open.
struct OpenLinks {
    std::mutex mutex;
    std::vector<std::weak_ptr<DeviceLink>> open;
};

OpenLinks& links()
{
    static OpenLinks all;
    return all;
}

void addOpenLink(const std::shared_ptr<DeviceLink>& link)
{
    const std::lock_guard lock(links().mutex);
    std::erase_if(links().open, [](const std::weak_ptr<DeviceLink>& one) { return one.expired(); });
    links().open.push_back(link);
}

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
    void writeOnCrash(const protocol::Report& report) override { m_inner->writeOnCrash(report); }
    [[nodiscard]] Place place() const override { return m_inner->place(); }
    [[nodiscard]] bool streamsAlways() const override { return m_inner->streamsAlways(); }
    [[nodiscard]] bool keepsComputerTime() const override { return m_inner->keepsComputerTime(); }
    [[nodiscard]] bool waitsForReader() const override { return m_inner->waitsForReader(); }
    [[nodiscard]] bool takesCommands() const override { return m_inner->takesCommands(); }
    void note(const QString& text) override { m_inner->note(text); }
    [[nodiscard]] QString keptSession() const override { return m_inner->keptSession(); }

private:
    const std::shared_ptr<Transport> m_inner;
    const std::shared_ptr<ReportLog> m_log;
};

} // namespace

namespace {
/// close() in all: below the second it promises.
constexpr std::chrono::milliseconds writerMayTake{250};
constexpr std::chrono::milliseconds othersMayTake{500};
} // namespace

struct DevicePort::Private {
    QString address;
    TransportMaker makeTransport;
    DecoderMaker makeDecoder;
    std::size_t queueCapacity;
    LinkLimits limits;
    std::shared_ptr<ReportLog> log = std::make_shared<ReportLog>();
    /// Guards the pointer only: stop() and confirmAlive() may come from any thread while open() puts a new
    /// link.
    mutable std::mutex mutex;
    std::shared_ptr<DeviceLink> link;
    BoundedThread opener, reader, writer;

    [[nodiscard]] std::shared_ptr<DeviceLink> current() const
    {
        const std::lock_guard lock(mutex);
        return link;
    }
};

DevicePort::DevicePort(QString address, TransportMaker makeTransport, std::size_t queueCapacity,
                       DecoderMaker makeDecoder, const LinkLimits& limits)
    : d(std::make_unique<Private>())
{
    d->address = std::move(address);
    d->makeTransport = std::move(makeTransport);
    d->makeDecoder = std::move(makeDecoder);
    d->queueCapacity = queueCapacity;
    d->limits = limits;
}

DevicePort::~DevicePort()
{
    close();
}

void DevicePort::open()
{
    close();
    auto transport = std::make_shared<LoggedTransport>(d->makeTransport(), d->log);
    auto link = std::make_shared<DeviceLink>(std::move(transport), d->makeDecoder(), d->address,
                                             d->queueCapacity, d->limits);
    {
        const std::lock_guard lock(d->mutex);
        d->link = link;
    }
    addOpenLink(link);
    d->opener = BoundedThread([link] { link->runOpener(); });
    d->reader = BoundedThread([link] { link->runReader(); });
    d->writer = BoundedThread([link] { link->runWriter(); });
}

void DevicePort::close()
{
    const std::shared_ptr<DeviceLink> link = d->current();
    if (!link)
        return;
    const auto now = std::chrono::steady_clock::now();
    link->beginClosing();
    d->writer.finishBy(now + writerMayTake);
    link->closeTransport();
    d->reader.finishBy(now + writerMayTake + othersMayTake);
    d->opener.finishBy(now + writerMayTake + othersMayTake);
    link->finishClosing();
}

LinkState DevicePort::state() const
{
    const auto link = d->current();
    return link ? link->state() : LinkState::Closed;
}

std::optional<Error> DevicePort::lastError() const
{
    const auto link = d->current();
    return link ? link->lastError() : std::nullopt;
}

GripperIdentity DevicePort::identity() const
{
    const auto link = d->current();
    return link ? link->identity() : GripperIdentity{};
}

LinkCounters DevicePort::counters() const
{
    const auto link = d->current();
    return link ? link->counters() : LinkCounters{};
}

std::size_t DevicePort::drain(std::vector<Sample>& samples, std::size_t most)
{
    const auto link = d->current();
    return link ? link->drain(samples, most) : 0;
}

void DevicePort::arm(const ArmingOrder& order)
{
    if (order.person().isEmpty())
        return;
    if (const auto link = d->current())
        link->arm();
}

void DevicePort::disarm()
{
    if (const auto link = d->current())
        link->disarm();
}

void DevicePort::startExcitation(const AdmittedExcitation& excitation)
{
    if (const auto link = d->current())
        link->startExcitation(excitation);
}

SqueezeState DevicePort::squeezeState() const
{
    const auto link = d->current();
    return link ? link->squeezeState() : SqueezeState::Idle;
}

StopState DevicePort::stopState() const
{
    const auto link = d->current();
    return link ? link->stopState() : StopState::None;
}

std::optional<Error> DevicePort::disarmReason() const
{
    const auto link = d->current();
    return link ? link->disarmReason() : std::nullopt;
}

void DevicePort::finishExcitation()
{
    if (const auto link = d->current())
        link->finishExcitation();
}

void DevicePort::stop() noexcept
{
    if (const auto link = d->current())
        link->stop();
}

void DevicePort::note(const QString& text)
{
    if (const auto link = d->current())
        link->note(text);
}

void DevicePort::confirmAlive() noexcept
{
    if (const auto link = d->current())
        link->confirmAlive();
}

const ReportLog* DevicePort::reportLog() const
{
    return d->log.get();
}

void stopOpenLinks() noexcept
{
    const std::lock_guard lock(links().mutex);
    for (const std::weak_ptr<DeviceLink>& one : links().open)
        if (const auto link = one.lock())
            link->stop();
}

} // namespace gripscope
