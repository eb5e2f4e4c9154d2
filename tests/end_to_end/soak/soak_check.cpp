// SPDX-License-Identifier: GPL-3.0-or-later
// One gripper after another for as many minutes as asked (soak.sh), each with faults of its own: every sample
// is received or counted as lost, memory stays where it is, no thread is left behind. Exits with 1 when not.
#include "devices/acquisition/device_port.h"
#include "devices/virtual/virtual_transport.h"
#include "tests/devices/port_helpers.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTextStream>

#include <random>
#include <unistd.h>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using Clock = std::chrono::steady_clock;

namespace {

std::size_t residentBytes()
{
    QFile file(u"/proc/self/statm"_qs);
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    return file.readAll().split(' ').value(1).toULongLong() * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

qsizetype threads()
{
    return QDir(u"/proc/self/task"_qs).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size();
}

struct Totals {
    std::uint64_t links = 0, squeezes = 0, received = 0, lost = 0, duplicates = 0, bad = 0, unaccounted = 0;
};

/// "loss:0.013,crc:0.002,unplug:3.1": each fault in every other link or so.
QString drawFaults(std::mt19937& engine)
{
    const auto share = [&engine](int thousandths) { return double(engine() % unsigned(thousandths)) / 1000; };
    QStringList faults;
    if (engine() % 2 == 0)
        faults << u"loss:%1"_qs.arg(share(50));
    if (engine() % 2 == 0)
        faults << u"duplicate:%1"_qs.arg(share(50));
    if (engine() % 2 == 0)
        faults << u"crc:%1"_qs.arg(share(50));
    if (engine() % 3 == 0)
        faults << u"unplug:%1"_qs.arg(0.5 + share(5000));
    else if (engine() % 5 == 0)
        faults << u"stall:%1"_qs.arg(0.5 + share(5000));
    return faults.isEmpty() ? QString() : u"&fault="_qs + faults.join(u',');
}

/// What is drained of one link, without keeping it.
struct Drained {
    std::vector<Sample> batch;
    std::optional<std::uint64_t> first, last;
    std::uint64_t count = 0;

    void take(GripperPort& port)
    {
        batch.clear();
        port.drain(batch);
        count += batch.size();
        if (batch.empty())
            return;
        first = first.value_or(batch.front().sequence);
        last = batch.back().sequence;
    }
};

void runLink(std::mt19937& engine, Totals& totals)
{
    const QString address = u"virtual:?seed=%1%2"_qs.arg(engine() % 1000).arg(drawFaults(engine));
    const std::shared_ptr<VirtualTransport> sender =
        *VirtualTransport::make(std::get<VirtualAddress>(*parseDeviceAddress(address)));
    OpenPort gripper(std::make_unique<DevicePort>(
        address, [sender] { return sender; }, SampleQueue::defaultCapacity, &GripscopeDecoder::make,
        limitsForABusyProgram()));
    Drained drained;
    const auto end = Clock::now() + std::chrono::milliseconds(2000 + engine() % 4000);
    bool squeezed = false;
    while (Clock::now() < end && gripper.port->state() != LinkState::Lost) {
        gripper.port->confirmAlive();
        drained.take(*gripper.port);
        const LinkState state = gripper.port->state();
        if (state == LinkState::Ready && !squeezed)
            (void)gripper.gate.arm(u"soak"_qs);
        if (state == LinkState::Armed && !squeezed)
            squeezed = gripper.gate.start(usualForce(1000)).has_value();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    gripper.port->close();
    drained.take(*gripper.port);
    const LinkCounters counters = gripper.port->counters();
    // What the sender put on the wire, less what went before the first that came and after the last.
    const FaultCounts sent = sender->faultCounts();
    const std::uint64_t range =
        drained.first ? sent.samples - (*drained.first - *sent.first) - (sent.last - *drained.last) : 0;
    const std::uint64_t known = drained.count + counters.lostSamples;
    ++totals.links;
    totals.squeezes += squeezed ? 1 : 0;
    totals.received += drained.count;
    totals.lost += counters.lostSamples;
    totals.duplicates += counters.duplicateReports;
    totals.bad += counters.badReports;
    totals.unaccounted += known > range ? known - range : range - known;
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const double minutes = application.arguments().value(1, u"2"_qs).toDouble();
    std::mt19937 engine(application.arguments().value(2, u"1"_qs).toUInt());
    Totals totals;
    const auto end = Clock::now() + std::chrono::duration<double, std::ratio<60>>(minutes);
    for (int i = 0; i < 3; ++i) // what is made once and kept
        runLink(engine, totals);
    const std::size_t before = residentBytes();
    const qsizetype threadsBefore = threads();
    while (Clock::now() < end)
        runLink(engine, totals);
    const bool quiet = waitFor([&] { return threads() <= threadsBefore; });
    const double grown = (double(residentBytes()) - double(before)) / (1 << 20);
    QTextStream(stdout)
        << u"links %1, squeezes begun %2; samples received %3, counted lost %4, unaccounted for %5; "
           "duplicates %6, damaged %7; memory %8 MB more; threads %9\n"_qs.arg(totals.links)
               .arg(totals.squeezes)
               .arg(totals.received)
               .arg(totals.lost)
               .arg(totals.unaccounted)
               .arg(totals.duplicates)
               .arg(totals.bad)
               .arg(grown, 0, 'f', 1)
               .arg(threads());
    return totals.unaccounted == 0 && totals.received > 0 && grown < 5 && quiet ? 0 : 1;
}
