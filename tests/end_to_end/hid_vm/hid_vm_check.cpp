// SPDX-License-Identifier: GPL-3.0-or-later
// Runs as root in a virtual machine with a kernel of its own (hid_vm.sh): the program's device side against
// real hidraw nodes, which the virtual gripper makes through /dev/uhid. Prints a table; exits with the number
// of rows that failed.
#include "devices/hid/hid_transport.h"
#include "devices/hid/uhid_gripper.h"
#include "devices/protocol/report_descriptor.h"
#include "devices/virtual/virtual_transport.h"
#include "tests/devices/connected_program.h"

#include <QCoreApplication>
#include <QProcess>
#include <QTextStream>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fcntl.h>
#include <linux/hidraw.h>
#include <linux/uhid.h>
#include <random>
#include <sys/ioctl.h>
#include <thread>
#include <unistd.h>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

const QString address = u"hid:1209:0001:VG-7"_qs;

/// One gripper in a USB socket, as far as the kernel can tell.
class PluggedIn {
public:
    explicit PluggedIn(int seed = 7, const QString& faults = {})
    {
        const auto virtualAddress =
            std::get<VirtualAddress>(*parseDeviceAddress(u"virtual:?seed=%1"_qs.arg(seed) + faults));
        m_sender = *VirtualTransport::make(virtualAddress);
        if (!m_sender->open())
            qFatal("the virtual gripper does not open");
        auto gripper = UhidGripper::create(m_sender);
        if (!gripper)
            qFatal("%s", qPrintable(gripper.error().describe()));
        m_gripper = std::move(*gripper);
        m_thread = std::thread([this] { (void)m_gripper->serve(m_ending); });
    }
    ~PluggedIn() { unplug(); }
    void unplug()
    {
        m_ending = true;
        if (m_thread.joinable())
            m_thread.join();
        m_gripper.reset();
    }
    /// What it put on the wire so far.
    [[nodiscard]] FaultCounts sent() const { return m_sender->faultCounts(); }

private:
    std::shared_ptr<VirtualTransport> m_sender;
    std::atomic<bool> m_ending{false};
    std::unique_ptr<UhidGripper> m_gripper;
    std::thread m_thread;
};

/// A device that is there and never answers a feature request.
class Mute {
public:
    Mute() : m_file(::open("/dev/uhid", O_RDWR | O_CLOEXEC))
    {
        uhid_event event{};
        event.type = UHID_CREATE2;
        std::copy_n("VG-7", 5, event.u.create2.uniq);
        const std::vector<std::uint8_t> descriptor = protocol::reportDescriptor();
        event.u.create2.rd_size = static_cast<std::uint16_t>(descriptor.size());
        event.u.create2.bus = BUS_USB;
        event.u.create2.vendor = protocol::vendorId;
        event.u.create2.product = protocol::productId;
        std::copy(descriptor.begin(), descriptor.end(), event.u.create2.rd_data);
        if (::write(m_file, &event, sizeof event) != static_cast<ssize_t>(sizeof event))
            qFatal("/dev/uhid takes no device");
    }
    ~Mute() { unplug(); }
    void unplug()
    {
        if (m_file >= 0)
            ::close(m_file);
        m_file = -1;
    }

private:
    int m_file;
};

bool isListed()
{
    const std::vector<FoundDevice> found = findDevices();
    return std::any_of(found.begin(), found.end(),
                       [](const FoundDevice& device) { return device.address == address; });
}

int failures = 0;
void row(const char* what, bool good, const QString& figure)
{
    failures += good ? 0 : 1;
    QTextStream(stdout) << (good ? "ok    " : "FAIL  ") << QString::fromUtf8(what).leftJustified(52) << figure
                        << '\n'
                        << Qt::flush;
}

QString counted(const LinkCounters& counters)
{
    return u"%1 samples, %2 lost, %3 duplicates, %4 bad"_qs.arg(counters.samples)
        .arg(counters.lostSamples)
        .arg(counters.duplicateReports)
        .arg(counters.badReports);
}

bool isWhole(const LinkCounters& counters)
{
    return counters.lostSamples == 0 && counters.duplicateReports == 0 && counters.badReports == 0;
}

/// The program as it is delivered, in a process of its own; unplugged by killing it.
void theVirtualGripperProgramIsFound()
{
    QProcess program;
    program.start(QCoreApplication::applicationDirPath() + u"/gripscope-virtual-gripper"_qs,
                  {u"virtual:?seed=7"_qs});
    const bool listed = program.waitForStarted() && waitFor(isListed);
    bool ready = false;
    if (listed) {
        OpenPort gripper(address);
        ready = gripper.ready();
    }
    program.kill();
    program.waitForFinished();
    row("gripscope-virtual-gripper is found and opened", listed && ready,
        listed ? address : u"not listed"_qs);
    row("killed, it is gone", waitFor([] { return !isListed(); }), {});
}

void fiveSecondsLoseNothing()
{
    const PluggedIn plugged;
    OpenPort gripper(address);
    if (!gripper.ready())
        return row("5 s of stream", false,
                   gripper.port->lastError() ? gripper.port->lastError()->describe() : u"?"_qs);
    const bool came = gripper.pollUntil([&] {
        return gripper.samples.size() > 1 &&
               gripper.samples.back().time_s - gripper.samples.front().time_s > 5;
    });
    const LinkCounters counters = gripper.port->counters();
    row("5 s of stream, 1,000 reports a second", came && isWhole(counters), counted(counters));
}

/// How long it took from Stop to the gripper's answer; nothing when none came.
std::optional<std::chrono::milliseconds> stopInTime(OpenPort& gripper)
{
    const auto before = std::chrono::steady_clock::now();
    gripper.port->stop();
    if (!gripper.pollUntil([&] { return gripper.port->squeezeState() == SqueezeState::Stopped; }))
        return {};
    return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - before);
}

QString inWords(const std::optional<std::chrono::milliseconds>& took)
{
    return took ? u"acknowledged after %1 ms"_qs.arg(took->count()) : u"not acknowledged"_qs;
}

void commandsAreObeyed()
{
    const PluggedIn plugged;
    OpenPort gripper(address);
    const SqueezeState squeezed = gripper.squeeze(usualForce(500));
    gripper.port->drain(gripper.samples);
    const std::size_t moved = samplesMoving(gripper.samples).size();
    row("armed, uploaded, squeezed", squeezed == SqueezeState::Finished && moved == 500,
        u"%1 samples while moving, %2"_qs.arg(moved).arg(counted(gripper.port->counters())));
    const bool running = gripper.gate.start(usualForce(20000)).has_value() && gripper.pollUntil([&] {
        return gripper.port->squeezeState() == SqueezeState::Running;
    });
    const std::optional<std::chrono::milliseconds> took = stopInTime(gripper);
    row("stopped while it squeezes", running && took, inWords(took));
}

/// Another program asks the device what it is, and gets no answer for five seconds.
void stoppedWhileAFeatureIsAwaited()
{
    constexpr double hangsFrom_s = 2;
    const PluggedIn plugged(7, u"&fault=hang-feature:%1"_qs.arg(hangsFrom_s));
    OpenPort gripper(address);
    const bool running = gripper.ready() && gripper.arm() &&
                         gripper.gate.start(usualForce(20000)).has_value() && gripper.pollUntil([&] {
                             return gripper.port->squeezeState() == SqueezeState::Running &&
                                    !gripper.samples.empty() &&
                                    gripper.samples.back().time_s > hangsFrom_s + 0.2;
                         });
    std::atomic<bool> asks{false};
    std::atomic<bool> answered{false};
    // Not by a HidTransport, which would find the node held.
    std::thread other([&] {
        const std::vector<HidNode> nodes = grippersAmong(listHidNodes());
        const int file = nodes.empty() ? -1 : ::open(qPrintable(nodes.front().path), O_RDWR | O_CLOEXEC);
        if (file < 0)
            return;
        protocol::Report report{static_cast<std::uint8_t>(protocol::ReportId::Identity)};
        asks = true;
        answered = ::ioctl(file, HIDIOCGFEATURE(protocol::reportSize), report.data()) >= 0;
        ::close(file);
    });
    const auto waited = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
    const bool waits = gripper.pollUntil([&] { return asks && std::chrono::steady_clock::now() > waited; });
    const std::optional<std::chrono::milliseconds> took = stopInTime(gripper);
    other.join();
    row("stopped while a feature request waits",
        running && waits && took && !answered && *took < std::chrono::milliseconds(200), inWords(took));
}

void unpluggedWhile(const char* what, const std::function<bool(OpenPort&)>& busy)
{
    PluggedIn plugged;
    OpenPort gripper(address);
    const bool began = gripper.ready() && busy(gripper);
    const auto before = std::chrono::steady_clock::now();
    plugged.unplug();
    const bool lost = gripper.pollUntil([&] { return gripper.port->state() == LinkState::Lost; });
    const auto took =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - before);
    row(what, began && lost && isWhole(gripper.port->counters()),
        u"noticed after %1 ms, %2"_qs.arg(took.count()).arg(counted(gripper.port->counters())));
}

void unpluggedWhileAFeatureIsAwaited()
{
    Mute device;
    const bool listed = waitFor(isListed);
    auto port = DeviceFactory().create(address).value();
    port->open();
    const bool waits = waitFor([&] { return port->state() == LinkState::Opening; });
    std::this_thread::sleep_for(std::chrono::milliseconds(300)); // the request is on its way
    device.unplug();
    const bool given =
        waitFor([&] { return port->state() == LinkState::Lost || port->state() == LinkState::Closed; });
    row("unplugged while a feature request waits", listed && waits && given,
        port->lastError() ? port->lastError()->describe() : u"no words"_qs);
}

void replugged(int times)
{
    int good = 0;
    double longest_ms = 0;
    for (int i = 0; i < times; ++i) {
        const auto before = std::chrono::steady_clock::now();
        PluggedIn plugged;
        if (!waitFor(isListed))
            continue;
        OpenPort gripper(address);
        const bool streams =
            gripper.ready() && gripper.pollUntil([&] { return gripper.samples.size() > 20; });
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - before;
        longest_ms = std::max(longest_ms, took.count());
        plugged.unplug();
        const bool lost = gripper.pollUntil([&] { return gripper.port->state() == LinkState::Lost; });
        good += streams && lost && isWhole(gripper.port->counters()) && waitFor([] { return !isListed(); })
                    ? 1
                    : 0;
    }
    row("replugged: found, streaming, lost, gone", good == times,
        u"%1 of %2, to the stream in at most %3 ms"_qs.arg(good).arg(times).arg(longest_ms, 0, 'f', 0));
}

/// The same session before and after: armed by nobody but a person, and with nothing lost in between but what
/// the gripper did not measure.
void sessionsAreKept(int times)
{
    ConnectedProgram program;
    auto plugged = std::make_unique<PluggedIn>();
    bool good = program.connectTo(u"hid:"_qs) && program.arm();
    std::vector<double> took_ms;
    for (int i = 0; good && i < times; ++i) {
        good = program.untilSamples(20);
        plugged.reset();
        good = good && program.untilState(ConnectSession::State::Lost);
        const auto before = std::chrono::steady_clock::now();
        plugged = std::make_unique<PluggedIn>();
        good = good && program.untilSamples(1) && !program.connection.armed();
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - before;
        took_ms.push_back(took.count());
    }
    std::sort(took_ms.begin(), took_ms.end());
    const bool kept = good && program.connection.reconnections() == times &&
                      program.connection.identity().serial == u"VG-7"_qs &&
                      isWhole(program.connection.counters());
    row("a session kept through replugs, by kernel events", kept && took_ms.back() < 1000,
        took_ms.empty() ? u"did not begin"_qs
                        : u"%1 of %2; to the first sample %3 ms (median), %4 ms (longest)"_qs
                              .arg(program.connection.reconnections())
                              .arg(times)
                              .arg(took_ms[took_ms.size() / 2], 0, 'f', 0)
                              .arg(took_ms.back(), 0, 'f', 0));
}

void twoAtOnce()
{
    const PluggedIn one(7);
    const PluggedIn two(8);
    (void)waitFor([] { return findDevices().size() == 3; }); // with the virtual one
    OpenPort any(u"hid:"_qs);
    const bool refused =
        waitForState(*any.port, LinkState::Lost) && any.port->lastError()->code == ErrorCode::DeviceAmbiguous;
    row("two at once: hid: names both", refused,
        any.port->lastError() ? any.port->lastError()->describe() : u"no words"_qs);
    ConnectedProgram seven, eight;
    const bool open = seven.connectTo(address) && eight.connectTo(u"hid:1209:0001:VG-8"_qs);
    const bool stream = waitFor([&] {
        seven.poll();
        eight.poll();
        return seven.connection.counters().samples > 500 && eight.connection.counters().samples > 500;
    });
    const bool right =
        seven.connection.identity().serial == u"VG-7"_qs && eight.connection.identity().serial == u"VG-8"_qs;
    row("two at once, each chosen by its serial number",
        open && stream && right && isWhole(seven.connection.counters()) &&
            isWhole(eight.connection.counters()),
        counted(eight.connection.counters()));
}

/// Whatever the moment, while it streams or squeezes: what came and what is missing make up all there was
/// between the first sample and the last.
void unpluggedAtAnyMoment(int times)
{
    std::mt19937 engine(5);
    int good = 0;
    std::uint64_t samples = 0, lost = 0;
    for (int i = 0; i < times; ++i) {
        PluggedIn plugged;
        if (!waitFor(isListed))
            continue;
        OpenPort gripper(address);
        bool began = gripper.ready();
        if (i % 2 == 0)
            began = began && gripper.arm() && gripper.gate.start(usualForce(500)).has_value();
        const auto moment = std::chrono::steady_clock::now() + std::chrono::microseconds(engine() % 300'000);
        (void)gripper.pollUntil([&] { return std::chrono::steady_clock::now() >= moment; });
        plugged.unplug();
        const bool gone = gripper.pollUntil([&] { return gripper.port->state() == LinkState::Lost; });
        gripper.port->drain(gripper.samples);
        const LinkCounters counters = gripper.port->counters();
        // Counted where they were sent, less what went before the first that came and after the last.
        const FaultCounts sent = plugged.sent();
        const bool accounted =
            gripper.samples.empty() ||
            (sent.first && counters.samples + counters.lostSamples ==
                               sent.samples - (gripper.samples.front().sequence - *sent.first) -
                                   (sent.last - gripper.samples.back().sequence));
        good += began && gone && accounted && counters.samples == gripper.samples.size() ? 1 : 0;
        samples += counters.samples;
        lost += counters.lostSamples;
    }
    row("unplugged at any moment, every sample accounted for", good == times,
        u"%1 of %2; %3 samples, %4 lost"_qs.arg(good).arg(times).arg(samples).arg(lost));
}

/// Two processors: devices come and go while the list is read.
void racing(int times)
{
    std::atomic<int> plugs{0};
    std::atomic<bool> ending{false};
    std::thread coming([&] {
        for (; plugs < times; ++plugs) {
            PluggedIn plugged;
            std::this_thread::yield();
        }
        ending = true;
    });
    long long looks = 0, seen = 0;
    while (!ending) {
        seen += isListed() ? 1 : 0;
        ++looks;
    }
    coming.join();
    row("plugged and unplugged while the list is read", plugs == times && looks > 0,
        u"%1 times, %2 looks, %3 saw it"_qs.arg(plugs.load()).arg(looks).arg(seen));
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    QTextStream(stdout) << '\n'; // what the machine said while it started ends here
    if (application.arguments().value(1) == u"race"_qs) {
        racing(application.arguments().value(2, u"300"_qs).toInt());
        return failures;
    }
    if (application.arguments().value(1) == u"moments"_qs) {
        unpluggedAtAnyMoment(application.arguments().value(2, u"1000"_qs).toInt());
        return failures;
    }
    theVirtualGripperProgramIsFound();
    fiveSecondsLoseNothing();
    commandsAreObeyed();
    stoppedWhileAFeatureIsAwaited();
    unpluggedWhile("unplugged while reading", [](OpenPort& gripper) {
        return gripper.pollUntil([&] { return gripper.samples.size() > 500; });
    });
    unpluggedWhile("unplugged while writing", [](OpenPort& gripper) {
        return gripper.arm() && gripper.gate.start(usualForce(20000)).has_value() &&
               gripper.port->squeezeState() == SqueezeState::Uploading;
    });
    unpluggedWhileAFeatureIsAwaited();
    sessionsAreKept(20);
    twoAtOnce();
    replugged(application.arguments().value(2, u"100"_qs).toInt());
    return failures;
}
