// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "devices/hid/uhid_gripper.h"
#include "devices/protocol/codec.h"
#include "devices/protocol/report_descriptor.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/uhid.h>
#include <poll.h>
#include <thread>
#include <unistd.h>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const QString uhidPath = u"/dev/uhid"_qs;

/// A text in a field of `size` bytes that are zero, the last of which stays so.
void putText(std::uint8_t* field, std::size_t size, const std::string& text)
{
    std::copy_n(text.begin(), std::min(text.size(), size - 1), field);
}

tl::unexpected<Error> cannotOpen(int reason)
{
    if (reason == EACCES || reason == EPERM)
        return failure(
            ErrorCode::DevicePermission,
            {uhidPath,
             Words::tr(
                 "Start this program with sudo, or let your user write to it until the next start of the "
                 "computer: sudo setfacl -m u:$USER:rw /dev/uhid")});
    return failure(
        ErrorCode::DeviceNotFound,
        {uhidPath,
         Words::tr("Load the kernel's module first: sudo modprobe uhid. (Containers and some virtual "
                   "machines do not have it; virtual: works everywhere.)")});
}

} // namespace

struct UhidGripper::Private {
    int file = -1;
    std::shared_ptr<Transport> transport;

    ~Private() { ::close(file); }
    [[nodiscard]] Expected<void> send(const uhid_event& event) const;
    [[nodiscard]] Expected<void> plugIn() const;
    [[nodiscard]] Expected<void> takeEvents(int wait_ms) const;
    [[nodiscard]] Expected<void> take(const uhid_event& event) const;
    void forward(const std::uint8_t* data, std::size_t size) const;
    [[nodiscard]] Expected<void> stream(const std::atomic<bool>& ending, const std::atomic<bool>& over) const;
};

Expected<void> UhidGripper::Private::send(const uhid_event& event) const
{
    if (::write(file, &event, sizeof event) == static_cast<ssize_t>(sizeof event))
        return {};
    return failure(ErrorCode::DeviceLost, {uhidPath, QString::fromLocal8Bit(std::strerror(errno))});
}

Expected<void> UhidGripper::Private::plugIn() const
{
    ASSIGN_OR_RETURN(const protocol::Report report, transport->feature(protocol::ReportId::Identity));
    const auto identity = protocol::decodeIdentity(report);
    if (!identity)
        return failure(ErrorCode::DeviceRefused,
                       {Words::tr("say what it is"), protocol::describe(identity.error())});
    const std::vector<std::uint8_t> descriptor = protocol::reportDescriptor();
    uhid_event event{};
    event.type = UHID_CREATE2;
    putText(event.u.create2.name, sizeof event.u.create2.name, identity->name);
    putText(event.u.create2.uniq, sizeof event.u.create2.uniq, identity->serial);
    event.u.create2.rd_size = static_cast<std::uint16_t>(descriptor.size());
    event.u.create2.bus = BUS_USB;
    event.u.create2.vendor = protocol::vendorId;
    event.u.create2.product = protocol::productId;
    std::copy(descriptor.begin(), descriptor.end(), event.u.create2.rd_data);
    return send(event);
}

void UhidGripper::Private::forward(const std::uint8_t* data, std::size_t size) const
{
    if (size != protocol::reportSize)
        return; // no report of this protocol; a device drops it too
    protocol::Report report;
    std::copy_n(data, size, report.begin());
    // What a gripper does not take now is as lost as on the cable.
    static_cast<void>(transport->write(report));
}

Expected<void> UhidGripper::Private::take(const uhid_event& event) const
{
    uhid_event answer{};
    switch (event.type) {
    case UHID_OUTPUT:
        forward(event.u.output.data, event.u.output.size);
        return {};
    case UHID_SET_REPORT:
        forward(event.u.set_report.data, event.u.set_report.size);
        answer.type = UHID_SET_REPORT_REPLY;
        answer.u.set_report_reply.id = event.u.set_report.id;
        return send(answer);
    case UHID_GET_REPORT: {
        const auto report = transport->feature(static_cast<protocol::ReportId>(event.u.get_report.rnum));
        answer.type = UHID_GET_REPORT_REPLY;
        answer.u.get_report_reply.id = event.u.get_report.id;
        answer.u.get_report_reply.err = report ? 0 : EIO;
        if (report) {
            answer.u.get_report_reply.size = protocol::reportSize;
            std::copy(report->begin(), report->end(), answer.u.get_report_reply.data);
        }
        return send(answer);
    }
    default:
        return {}; // start, stop, open, close: nothing to do
    }
}

Expected<void> UhidGripper::Private::takeEvents(int wait_ms) const
{
    pollfd waiting{file, POLLIN, 0};
    while (::poll(&waiting, 1, wait_ms) > 0) {
        uhid_event event{};
        if (::read(file, &event, sizeof event) <= 0)
            return failure(ErrorCode::DeviceLost, {uhidPath, Words::tr("the system closed it")});
        RETURN_IF_ERROR(take(event));
    }
    return {};
}

UhidGripper::UhidGripper(std::unique_ptr<Private> made) : d(std::move(made)) {}

UhidGripper::~UhidGripper()
{
    uhid_event event{};
    event.type = UHID_DESTROY;
    static_cast<void>(d->send(event)); // closing the file would do it too
}

Expected<std::unique_ptr<UhidGripper>> UhidGripper::create(std::shared_ptr<Transport> transport)
{
    const int file = ::open(uhidPath.toLatin1().constData(), O_RDWR | O_CLOEXEC);
    if (file < 0)
        return cannotOpen(errno);
    return createOn(file, std::move(transport));
}

Expected<std::unique_ptr<UhidGripper>> UhidGripper::createOn(int file, std::shared_ptr<Transport> transport)
{
    auto made = std::make_unique<Private>();
    made->file = file;
    made->transport = std::move(transport);
    RETURN_IF_ERROR(made->plugIn());
    return std::unique_ptr<UhidGripper>(new UhidGripper(std::move(made)));
}

Expected<void> UhidGripper::serve(const std::atomic<bool>& ending)
{
    // The host's questions have a thread of their own, so that a gripper whose answer hangs goes on
    // streaming.
    std::atomic<bool> over{false};
    Expected<void> answered;
    std::thread answering([&] {
        constexpr int wait_ms = 20;
        while (!over && answered)
            answered = d->takeEvents(wait_ms);
        over = true;
    });
    const Expected<void> streamed = d->stream(ending, over);
    over = true;
    answering.join();
    return answered ? streamed : answered;
}

Expected<void> UhidGripper::Private::stream(const std::atomic<bool>& ending,
                                            const std::atomic<bool>& over) const
{
    Transport::Buffer buffer{};
    while (!ending && !over) {
        const Transport::ReadResult result = transport->read(buffer, std::chrono::milliseconds(1));
        if (result.outcome == Transport::Outcome::Lost || result.outcome == Transport::Outcome::Ended)
            return {};
        if (result.outcome == Transport::Outcome::Timeout)
            continue;
        uhid_event event{};
        event.type = UHID_INPUT2;
        event.u.input2.size = static_cast<std::uint16_t>(std::min(result.size, buffer.size()));
        std::copy_n(buffer.begin(), event.u.input2.size, event.u.input2.data);
        RETURN_IF_ERROR(send(event));
    }
    return {};
}

} // namespace gripscope
