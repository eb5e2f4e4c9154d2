// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/uhid_gripper.h"
#include "devices/protocol/codec.h"
#include "devices/protocol/report_descriptor.h"
#include "devices/virtual/virtual_transport.h"
#include "tests/devices/port_helpers.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <atomic>
#include <linux/uhid.h>
#include <poll.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

using namespace gripscope;
using namespace gripscope::test;
using namespace gripscope::protocol;
using namespace Qt::StringLiterals;

namespace {

/// Stands where the kernel is: the other end of a pair of sockets that keep messages apart as /dev/uhid does.
class Kernel {
public:
    explicit Kernel(const QString& address)
    {
        int files[2] = {-1, -1};
        if (::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, files) != 0)
            return;
        m_file = files[0];
        const auto transport =
            *VirtualTransport::make(std::get<VirtualAddress>(*parseDeviceAddress(address)));
        if (!transport->open())
            return;
        m_gripper = UhidGripper::createOn(files[1], transport).value();
        m_thread = std::thread([this] { served = m_gripper->serve(ending).has_value(); });
    }
    ~Kernel()
    {
        ending = true;
        m_thread.join();
        m_gripper.reset();
        ::close(m_file);
    }

    /// The next event of a type, others passed over; nothing when none comes.
    std::optional<uhid_event> next(std::uint32_t type)
    {
        for (;;) {
            pollfd waiting{m_file, POLLIN, 0};
            if (::poll(&waiting, 1, static_cast<int>(std::chrono::milliseconds(patience).count())) <= 0)
                return std::nullopt;
            uhid_event event{};
            if (::read(m_file, &event, sizeof event) <= 0)
                return std::nullopt;
            if (event.type == type)
                return event;
        }
    }
    void send(const uhid_event& event)
    {
        QCOMPARE(::write(m_file, &event, sizeof event), ssize_t(sizeof event));
    }
    void output(const Report& report)
    {
        uhid_event event{};
        event.type = UHID_OUTPUT;
        event.u.output.size = reportSize;
        event.u.output.rtype = UHID_OUTPUT_REPORT;
        std::copy(report.begin(), report.end(), event.u.output.data);
        send(event);
    }
    template <typename Message>
    std::optional<Message> input()
    {
        while (const std::optional<uhid_event> event = next(UHID_INPUT2)) {
            const auto message = decodeInput({event->u.input2.data, event->u.input2.size});
            if (message && std::holds_alternative<Message>(*message))
                return std::get<Message>(*message);
        }
        return std::nullopt;
    }

    std::atomic<bool> ending{false};
    std::atomic<bool> served{false};

private:
    int m_file = -1;
    std::unique_ptr<UhidGripper> m_gripper;
    std::thread m_thread;
};

} // namespace

class UhidGripperTest : public QObject {
    Q_OBJECT
private slots:
    void plugsInADeviceWithTheProtocolsIdentity()
    {
        Kernel kernel(u"virtual:?seed=9"_qs);
        const std::optional<uhid_event> event = kernel.next(UHID_CREATE2);
        QVERIFY(event.has_value());
        const uhid_create2_req& device = event->u.create2;
        QCOMPARE(std::uint32_t(device.vendor), 0x1209U);
        QCOMPARE(std::uint32_t(device.product), 1U);
        QCOMPARE(QString::fromUtf8(reinterpret_cast<const char*>(device.uniq)), u"VG-9"_qs);
        const std::vector<std::uint8_t> descriptor = reportDescriptor();
        QCOMPARE(std::size_t(device.rd_size), descriptor.size());
        QVERIFY(std::equal(descriptor.begin(), descriptor.end(), device.rd_data));
    }

    void answersFeaturesAndCommandsAndStreams()
    {
        Kernel kernel(u"virtual:"_qs);
        QVERIFY(kernel.next(UHID_CREATE2).has_value());
        uhid_event ask{};
        ask.type = UHID_GET_REPORT;
        ask.u.get_report.id = 77;
        ask.u.get_report.rnum = static_cast<std::uint8_t>(ReportId::Limits);
        kernel.send(ask);
        const std::optional<uhid_event> reply = kernel.next(UHID_GET_REPORT_REPLY);
        QVERIFY(reply.has_value());
        QCOMPARE(std::uint32_t(reply->u.get_report_reply.id), 77U);
        QCOMPARE(int(reply->u.get_report_reply.err), 0);
        QVERIFY(decodeLimits({reply->u.get_report_reply.data, reply->u.get_report_reply.size}).has_value());
        ask.u.get_report.rnum = 0x3F;
        kernel.send(ask);
        QVERIFY(kernel.next(UHID_GET_REPORT_REPLY)->u.get_report_reply.err != 0);

        kernel.output(encode(Command{5, ArmCommand{}}));
        const std::optional<Acknowledgement> answer = kernel.input<Acknowledgement>();
        QVERIFY(answer.has_value());
        QCOMPARE(answer->commandNumber, std::uint16_t(5));
        QVERIFY(answer->status & StatusArmed);
        QVERIFY(kernel.input<StreamReport>().has_value());
    }

    void anUnplugThatWasAskedForEndsTheDevice()
    {
        Kernel kernel(u"virtual:?fault=unplug:0.02"_qs);
        QVERIFY(waitFor([&] { return kernel.served.load(); }));
    }
};

GRIPSCOPE_TEST(UhidGripperTest)
#include "uhid_gripper_test.moc"
