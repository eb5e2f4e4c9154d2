// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/gripper/lost_samples.h"
#include "app/cli/library/authorization.h"
#include "app/cli/library/chain_library.h"
#include "app/cli/line/bounded_number.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/drive.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "app/cli/options/force_file.h"
#include "app/cli/options/recording_output.h"
#include "app/cli/options/shared_options.h"
#include "core/library/audit/audit_trail.h"
#include "core/people/audit_entry.h"
#include "core/session/connection/gripper_port.h"
#include "core/session/connection/limit_watch.h"
#include "core/session/squeeze/squeeze_job.h"
#include "core/signal/recording/recording_limits.h"
#include "core/signal/recording/stream_account.h"
#include "core/signal/recording/units.h"
#include "devices/factory/gripper_factory.h"

#include <QFileInfo>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// Who arms a gripper from the command line, by the libraries that are there: the one that is meant, and the
/// user's own besides, since naming another file is to be no way round the people in it. Where people are in
/// one, it asks for one of them who may (see Permission::Arm); where none are, anybody may. A library that is
/// there and cannot be read lets nobody arm.
class ArmingConsent {
public:
    /// Asks on the terminal where it has to: before a gripper is connected. Errors as authorization() has
    /// them, and the library's.
    [[nodiscard]] static Expected<ArmingConsent> ask(const QString& libraryFile, const QString& operatorName);

    /// Tells the audit trails that the gripper is about to be armed. Usage where it is no longer allowed,
    /// StorageFailed where it cannot be told: then nothing is to be armed.
    [[nodiscard]] Expected<void> tell(const GripperIdentity& gripper, const QJsonObject& details);
    /// Who showed who they are; else the name that was given.
    [[nodiscard]] const QString& person() const { return m_person; }

private:
    explicit ArmingConsent(QString person) : m_person(std::move(person)) {}
    [[nodiscard]] Expected<void> add(const QString& file, const QString& operatorName);

    std::vector<std::unique_ptr<Library>> m_libraries; ///< each acts as who consented
    QString m_person;
};

Expected<void> ArmingConsent::add(const QString& file, const QString& operatorName)
{
    ASSIGN_OR_RETURN(const bool isThere, Library::isThere(file));
    if (!isThere)
        return {};
    ASSIGN_OR_RETURN(std::unique_ptr<Library> library, Library::open(file));
    ASSIGN_OR_RETURN(const Acting acting, authorization(*library, operatorName, Permission::Arm));
    library->actAs(acting);
    if (acting.granted)
        m_person = acting.granted->by.name();
    m_libraries.push_back(std::move(library));
    return {};
}

Expected<ArmingConsent> ArmingConsent::ask(const QString& libraryFile, const QString& operatorName)
{
    ArmingConsent consent(operatorName);
    QStringList files{libraryFile};
    const QString own = Library::defaultFile();
    if (Library::isOnServer(libraryFile) ||
        QFileInfo(own).canonicalFilePath() != QFileInfo(libraryFile).canonicalFilePath())
        files.append(own);
    for (const QString& file : files)
        RETURN_IF_ERROR(consent.add(file, operatorName));
    return consent;
}

Expected<void> ArmingConsent::tell(const GripperIdentity& gripper, const QJsonObject& details)
{
    QJsonObject all = details;
    all.insert(u"from"_s, u"command line"_s);
    all.insert(u"address"_s, gripper.address);
    for (const std::unique_ptr<Library>& library : m_libraries)
        RETURN_IF_ERROR(library->auditTrail().record(
            Permission::Arm, QString::fromUtf16(audit_action::gripperArmed), gripper.serial, all));
    return {};
}

} // namespace

namespace {

/// Longer than a device takes to open (a feature request may block for 5 s) and to arm.
constexpr double openingPatience_s = 15;
constexpr double armingPatience_s = 5;
/// Of a recording; its samples are limited as well (recording_limits.h).
constexpr double longest_s = 86'400;

struct RecordRequest {
    QString device, file;
    double seconds = 0;
    ExcitationOptions
        excitation; ///< peak and bias in the device's unit of force, unless the next say another
    std::optional<double> newtonsPerPeak, newtonsPerBias;
    std::optional<double> maxForce; ///< in the device's unit; not given: see limitAbove()
    bool arm = false;
};

/// The force of --force-file, which lasts as long as that unless --seconds says otherwise.
Expected<void> takeForceFile(const CommandLine& line, RecordRequest& request)
{
    ASSIGN_OR_RETURN(const std::optional<ForceLevels> force, takeForceFile(line, request.excitation));
    if (!force)
        return {};
    if (!line.isSet(u"seconds"_qs))
        request.seconds = force->seconds() * request.excitation.bit_s / force->bit_s;
    if (force->unit.isEmpty())
        return {};
    const QString file = line.text(u"force-file"_qs);
    ASSIGN_OR_RETURN(const ForceLevels inOnes, inNewtons({1, 1, 1, {}, force->unit}, file));
    if (!line.isSet(u"peak"_qs))
        request.newtonsPerPeak = inOnes.peak;
    if (!line.isSet(u"bias"_qs))
        request.newtonsPerBias = inOnes.bias;
    return {};
}

RecordRequest readRecordRequest(CommandLine& line)
{
    using Range = CommandLine::Range;
    RecordRequest request;
    request.device = line.text(u"device"_qs);
    request.file = line.text(u"output"_qs);
    request.seconds = boundedNumber(line, u"seconds"_qs, 1e-6, longest_s);
    request.excitation.kind = excitationKind(line);
    request.excitation.periods = excitationPeriods(line);
    request.excitation.peak = line.number(u"peak"_qs, Range::NotNegative);
    request.excitation.bias = line.number(u"bias"_qs, Range::NotNegative);
    request.excitation.bit_s = line.number(u"bit"_qs, Range::Positive);
    request.arm = line.isSet(u"arm"_qs);
    if (line.isSet(u"max-force"_qs)) {
        request.maxForce = line.number(u"max-force"_qs, Range::Positive);
        if (!line.isSet(u"force-file"_qs) &&
            *request.maxForce < request.excitation.bias + request.excitation.peak)
            line.reject(
                u"--max-force is below the bias and the peak together, so that nothing could be squeezed."_qs);
    }
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
    /// `consent`: of who arms the gripper; none where it is only listened to.
    Recorder(const QString& library, std::optional<ArmingConsent> consent)
        : m_consent(std::move(consent)), m_chains(library), m_connection(m_devices), m_job(m_connection)
    {
        m_job.setOperator(operatorName());
    }
    ~Recorder() { static_cast<void>(release()); }
    /// Waits for the stop to be obeyed; StopNotObeyed.
    [[nodiscard]] Expected<void> release()
    {
        m_job.cancel();
        m_connection.disarm();
        m_connection.disconnect();
        return m_connection.stopState() == StopState::NotObeyed ? failure(ErrorCode::StopNotObeyed, {})
                                                                : Expected<void>();
    }

    Expected<Recording> record(const RecordRequest& request)
    {
        RETURN_IF_ERROR(m_connection.connectTo(request.device));
        RETURN_IF_ERROR(open());
        takeWhatIsKnown();
        RETURN_IF_ERROR(request.arm ? squeeze(request) : m_job.listen(request.seconds));
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
    [[nodiscard]] QString operatorName() const { return m_consent ? m_consent->person() : person(); }

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

    /// The recording gets what is known of this gripper's channels, and their correction.
    void takeWhatIsKnown()
    {
        const QString serial = m_connection.identity().serial;
        const KnownGripper known = m_chains.known(serial);
        putInForce(m_connection, known);
        if (known.chain)
            message(u"The recording has the measuring chain of gripper %1; lag %2."_qs.arg(
                serial, lagText(*known.chain)));
        const ChannelCalibration& calibration = m_connection.calibration();
        for (const SensorChannel channel : {SensorChannel::Force, SensorChannel::Position})
            if (const CalibrationRecord* record = calibration.record(channel))
                message(u"Its %1 is corrected by the calibration of gripper %2 of %3, due %4."_qs.arg(
                    channel == SensorChannel::Force ? u"force"_qs : u"position"_qs, serial,
                    record->takenUtc.date().toString(Qt::ISODate), record->due.toString(Qt::ISODate)));
        if (!calibration.unusable().isEmpty())
            message(calibration.unusable());
        for (const StudyStanding& study : m_chains.studies(serial))
            if (study.due)
                message(u"Its last study of the kind %1 ended %2, due again %3."_qs.arg(
                    toString(study.kind), study.last->ended->toLocalTime().date().toString(Qt::ISODate),
                    study.due->toString(Qt::ISODate)));
    }

    /// The gripper's own, or what became of the connection.
    std::optional<Error> reasonAgainstArming()
    {
        if (const GripperPort* port = m_connection.port())
            return port->lastError();
        return m_connection.lastError().value_or(
            Error{ErrorCode::DeviceLost, {m_connection.address(), u"it went away before it was armed"_qs}});
    }

    Expected<void> squeeze(const RecordRequest& request)
    {
        const GripperIdentity device = m_connection.identity();
        const std::optional<double> newtons = newtonsPer(device.forceUnit);
        if (!newtons)
            return failure(ErrorCode::UnitsDiffer, {device.forceUnit, u"N"_qs});
        ExcitationOptions excitation = request.excitation;
        excitation.peak *= request.newtonsPerPeak.value_or(*newtons);
        excitation.bias *= request.newtonsPerBias.value_or(*newtons);
        excitation.samples = std::max<std::size_t>(1, samplesIn(request.seconds, device.sampleTime_s));
        const double largest_N = excitation.bias + excitation.peak;
        const double noise_N = m_connection.measuringChain().forceNoiseDeviation * *newtons;
        const double limit_N = std::min(request.maxForce ? *request.maxForce * *newtons * (1 + 1e-9)
                                                         : limitAbove(largest_N, noise_N),
                                        device.limits.maxForce_N);
        RETURN_IF_ERROR(
            m_consent->tell(device, {{u"largest_force_N"_qs, largest_N}, {u"force_limit_N"_qs, limit_N}}));
        RETURN_IF_ERROR(m_connection.arm(operatorName()));
        static_cast<void>(drive([this] { m_connection.poll(); },
                                [this] { return m_connection.armed() || reasonAgainstArming(); },
                                armingPatience_s));
        if (interrupted())
            return failure(ErrorCode::Cancelled, {u"The recording"_qs});
        if (!m_connection.armed())
            return tl::unexpected<Error>(reasonAgainstArming().value_or(
                Error{ErrorCode::DeviceTimeout, {u"arm"_qs, QString::number(armingPatience_s)}}));
        return m_job.start(excitation, {limit_N, device.limits.maxTravel_m});
    }

    std::optional<ArmingConsent> m_consent;
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

void tell(const RecordRequest& request, const Recording& recording, const GripperIdentity& device, bool json)
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

void addRecordOptions(CommandLine& line)
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
    line.option(
        u"max-force"_qs, u"FORCE"_qs,
        u"The force, measured or commanded, above which the gripper is stopped, in the device's unit. "
        u"Without it: "
        "bias and peak, and a tenth or five standard deviations of the force noise above them, whichever is "
        "more; never above the device's own limit."_qs);
    addLibraryOption(line);
    line.shortOption(u'o', u"output"_qs, u"FILE"_qs, u"The recording to write."_qs);
    addForceOption(line);
}

} // namespace

int runRecord(const QStringList& arguments)
{
    CommandLine line(
        u"record"_qs,
        u"Records force and position from a gripper, with what the library knows of its channels. Ctrl-C stops the gripper and writes nothing. Where people are in the library, --arm needs one of them: GRIPSCOPE_PERSON names who, and the PIN or password is asked for."_qs);
    addRecordOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    RecordRequest request = readRecordRequest(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    if (const Expected<void> may = mayReplace(request.file, line.isSet(u"force"_qs)); !may)
        return fail(may.error(), json); // before anything moves
    if (const Expected<void> taken = takeForceFile(line, request); !taken)
        return fail(taken.error(), json);

    const Expected<QString> library = namedLibraryFile(line);
    if (!library)
        return fail(library.error(), json);

    std::optional<ArmingConsent> consent;
    if (request.arm) {
        Expected<ArmingConsent> asked = ArmingConsent::ask(*library, person());
        if (!asked)
            return fail(asked.error(), json);
        consent = std::move(*asked);
    }
    catchInterrupts();
    Recorder recorder(*library, std::move(consent));
    const Expected<Recording> recording = recorder.record(request);
    const GripperIdentity device = recorder.identity();
    const Expected<void> released = recorder.release();
    // Nothing is as urgent as a gripper that goes on.
    if (!recording)
        return fail(released ? recording.error() : released.error(), json);
    if (const Expected<void> written = writeRecordingCsv(*recording, request.file); !written)
        return fail(written.error(), json);
    if (!released)
        return fail(released.error(), json);
    tell(request, *recording, device, json);
    return 0;
}

} // namespace gripscope::cli
