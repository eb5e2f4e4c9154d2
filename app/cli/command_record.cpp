// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/chain_library.h"
#include "app/cli/commands.h"
#include "app/cli/drive.h"
#include "app/cli/exit_code.h"
#include "app/cli/lost_samples.h"
#include "app/cli/output.h"
#include "app/cli/shared_options.h"
#include "core/session/squeeze_job.h"
#include "core/signal/stream_account.h"
#include "core/signal/units.h"
#include "devices/gripper_factory.h"

#include <algorithm>
#include <cmath>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// Longer than a device takes to open (a feature request may block for 5 s) and to arm.
constexpr double openingPatience_s = 15;
constexpr double armingPatience_s = 5;

struct Request {
    QString device, file;
    double seconds = 0;
    ExcitationOptions excitation; ///< peak and bias in the device's unit of force
    bool arm = false;
};

Request readRequest(CommandLine& line)
{
    using Range = CommandLine::Range;
    Request request;
    request.device = line.text(u"device"_qs);
    request.file = line.text(u"output"_qs);
    request.seconds = line.number(u"seconds"_qs, Range::Positive);
    request.excitation.kind = excitationKind(line);
    request.excitation.periods = excitationPeriods(line);
    request.excitation.peak = line.number(u"peak"_qs, Range::NotNegative);
    request.excitation.bias = line.number(u"bias"_qs, Range::NotNegative);
    request.excitation.bit_s = line.number(u"bit"_qs, Range::Positive);
    request.arm = line.isSet(u"arm"_qs);
    if (request.device.isEmpty())
        line.reject(u"--device ADDRESS is missing; gripscope-cli devices lists them."_qs);
    if (request.file.isEmpty())
        line.reject(u"-o FILE is missing."_qs);
    return request;
}

/// Who asked for the gripper to be armed: whoever gave the command.
QString person()
{
    const QString user = qEnvironmentVariable("USER", qEnvironmentVariable("USERNAME"));
    return user.isEmpty() ? u"command line"_qs : user;
}

/// One recording from one gripper. Whatever ends it, the gripper is stopped and disarmed before the
/// connection closes.
class Recorder {
public:
    explicit Recorder(const QString& library)
        : m_chains(library), m_connection(m_devices), m_job(m_connection)
    {
        m_job.setOperator(person());
    }
    ~Recorder()
    {
        m_job.cancel();
        m_connection.disarm();
        m_connection.disconnect();
    }

    Expected<Recording> record(const Request& request)
    {
        if (const Expected<void> started = m_connection.connectTo(request.device); !started)
            return tl::unexpected<Error>(started.error());
        if (const std::optional<Error> error = open())
            return tl::unexpected<Error>(*error);
        takeKnownChain();
        const Expected<void> started = request.arm ? squeeze(request) : m_job.listen(request.seconds);
        if (!started)
            return tl::unexpected<Error>(started.error());
        message(u"%1 for %2 s; Ctrl-C stops."_qs.arg(request.arm ? u"Squeezing"_qs : u"Listening"_qs,
                                                     QString::number(request.seconds, 'g', 6)));
        if (!drive([this] { poll(); }, [this] { return ended(); }, request.seconds + 60)) {
            m_connection.stop();
            return failure(ErrorCode::Cancelled, {u"The recording"_qs});
        }
        if (m_job.state() == SqueezeJob::State::Failed)
            return tl::unexpected<Error>(*m_job.error());
        return m_job.recording();
    }
    [[nodiscard]] GripperIdentity identity() const { return m_connection.identity(); }

private:
    void poll()
    {
        m_connection.poll();
        m_job.poll();
    }
    [[nodiscard]] bool ended() const
    {
        return m_job.state() == SqueezeJob::State::Done || m_job.state() == SqueezeJob::State::Failed;
    }

    std::optional<Error> open()
    {
        const bool answered = drive(
            [this] { m_connection.poll(); },
            [this] { return m_connection.state() != ConnectSession::State::Connecting; }, openingPatience_s);
        if (interrupted())
            return Error{ErrorCode::Cancelled, {u"The recording"_qs}};
        if (!answered)
            return Error{ErrorCode::DeviceTimeout, {u"open"_qs, QString::number(openingPatience_s)}};
        if (m_connection.state() == ConnectSession::State::Connected)
            return std::nullopt;
        return m_connection.lastError().value_or(
            Error{ErrorCode::DeviceLost, {m_connection.address(), u"it did not open"_qs}});
    }

    /// The recording gets what was measured of this gripper's channels.
    void takeKnownChain()
    {
        const QString serial = m_connection.identity().serial;
        const std::optional<MeasuringChainRecord> known = m_chains.find(serial);
        if (!known)
            return;
        putInForce(m_connection, *known);
        message(
            u"The recording has the measuring chain of gripper %1; lag %2."_qs.arg(serial, lagText(*known)));
    }

    Expected<void> squeeze(const Request& request)
    {
        const GripperIdentity device = m_connection.identity();
        const std::optional<double> newtons = newtonsPer(device.forceUnit);
        if (!newtons)
            return failure(ErrorCode::UnitsDiffer, {device.forceUnit, u"N"_qs});
        ExcitationOptions excitation = request.excitation;
        excitation.peak *= *newtons;
        excitation.bias *= *newtons;
        excitation.samples =
            static_cast<std::size_t>(std::max(1.0, std::round(request.seconds / device.sampleTime_s)));
        if (const Expected<void> asked = m_connection.arm(person()); !asked)
            return asked;
        const bool armed =
            drive([this] { m_connection.poll(); },
                  [this] {
                      return m_connection.armed() || m_connection.state() != ConnectSession::State::Connected;
                  },
                  armingPatience_s);
        if (interrupted())
            return failure(ErrorCode::Cancelled, {u"The recording"_qs});
        if (!armed)
            return failure(ErrorCode::DeviceTimeout, {u"arm"_qs, QString::number(armingPatience_s)});
        // What was asked for is the job's own limit: nothing above it may move the gripper.
        const double largest_N = (excitation.bias + excitation.peak) * (1 + 1e-9); // rounding is no excess
        return m_job.start(excitation, {largest_N, device.limits.maxTravel_m});
    }

    ChainLibrary m_chains;
    DeviceFactory m_devices;
    ConnectSession m_connection;
    SqueezeJob m_job;
};

QJsonObject streamJson(const Recording& recording)
{
    const StreamAccount stream = streamAccount(recording).value_or(StreamAccount());
    const auto number = [](std::uint64_t count) { return static_cast<qint64>(count); };
    return {{u"gaps"_qs, number(stream.gaps)},
            {u"duplicate_reports"_qs, number(stream.duplicateReports)},
            {u"bad_reports"_qs, number(stream.badReports)},
            {u"clock_steps"_qs, number(stream.clockSteps)},
            {u"stalls"_qs, number(stream.stalls)},
            {u"longest_stall_s"_qs, stream.longestStall_s}};
}

void tell(const Request& request, const Recording& recording, const GripperIdentity& device, bool json)
{
    const double seconds = recording.time_s.empty()
                               ? 0
                               : recording.time_s.back() - recording.time_s.front() + recording.sampleTime_s;
    if (!request.arm && seconds < request.seconds - 1.5 * recording.sampleTime_s)
        message(u"The stream ended after %1 s."_qs.arg(QString::number(seconds, 'g', 4)));
    if (json)
        printJson({{u"file"_qs, request.file},
                   {u"samples"_qs, static_cast<qint64>(recording.size())},
                   {u"lost_samples"_qs, lostSamples(recording)},
                   {u"stream"_qs, streamJson(recording)},
                   {u"sample_time_s"_qs, recording.sampleTime_s},
                   {u"device"_qs, device.name},
                   {u"serial"_qs, device.serial},
                   {u"squeezed"_qs, request.arm}});
    else
        message(u"%1: %2 samples from %3, %4 lost."_qs.arg(request.file, QString::number(recording.size()),
                                                           device.name,
                                                           QString::number(lostSamples(recording))));
}

void addOptions(CommandLine& line)
{
    line.option(u"device"_qs, u"ADDRESS"_qs, u"virtual:, hid:, hid:VENDOR:PRODUCT:SERIAL or replay:FILE."_qs);
    line.option(u"seconds"_qs, u"SECONDS"_qs, u"Length of the squeeze."_qs, u"2"_qs);
    addExcitationKind(line);
    line.option(u"peak"_qs, u"FORCE"_qs, u"Largest force above and below the bias, in the device's unit."_qs,
                u"10"_qs);
    line.option(u"bias"_qs, u"FORCE"_qs, u"Preload, in the device's unit."_qs, u"20"_qs);
    line.option(u"bit"_qs, u"SECONDS"_qs,
                u"Length of a bit of prbs and inverse-repeat; shortest half period of the others."_qs,
                u"0.005"_qs);
    line.flag(u"arm"_qs,
              u"Arms the gripper and squeezes; without it nothing moves, and the program only listens."_qs);
    addLibraryOption(line);
    line.shortOption(u'o', u"output"_qs, u"FILE"_qs, u"The recording to write."_qs);
}

} // namespace

int runRecord(const QStringList& arguments)
{
    CommandLine line(
        u"record"_qs,
        u"Records force and position from a gripper, with what the library knows of its channels. Ctrl-C stops the gripper and writes nothing."_qs);
    addOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const Request request = readRequest(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);

    const Expected<QString> library = namedLibraryFile(line);
    if (!library)
        return fail(library.error(), json);

    catchInterrupts();
    Recorder recorder(*library);
    const Expected<Recording> recording = recorder.record(request);
    if (!recording)
        return fail(recording.error(), json);
    if (const Expected<void> written = writeRecordingCsv(*recording, request.file); !written)
        return fail(written.error(), json);
    tell(request, *recording, recorder.identity(), json);
    return 0;
}

} // namespace gripscope::cli
