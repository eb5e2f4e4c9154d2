// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench.h"

#include "core/calibration/calibration_record.h"
#include "core/session/stored_chain.h"
#include "core/signal/units.h"
#include "devices/replay/capture_folder.h"
#include "ui/commanded_force.h"
#include "ui/connection_words.h"
#include "ui/models/reference_words.h"
#include "ui/people/sign_in.h"
#include "ui/settings/settings.h"

#include <QPointer>
#include <QThreadPool>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace gripscope {

namespace {

struct Waiting {
    QPointer<QObject> context;
    bool bound = false; ///< to the life of `context`
    std::function<bool()> ready;
    std::function<void()> then;
};

/// What connectionChanged() is told from.
struct ConnectionView {
    ConnectSession::State state = ConnectSession::State::Disconnected;
    bool armed = false;
    QString address, serial;
    int reconnections = 0;
    friend bool operator==(const ConnectionView&, const ConnectionView&) = default;
};

/// The time of the plots: the device's own, and on from there when a gripper that went away counts anew, so
/// that the time without it shows as a gap.
class PlotTime {
public:
    void reset() { *this = {}; }
    void noticeReturn() { m_returned = true; }
    /// Shifts `samples`, which just came, to behind `newest_s`.
    [[nodiscard]] std::vector<Sample> place(std::vector<Sample> samples, double newest_s)
    {
        const Clock::time_point now = Clock::now();
        if (m_returned && !samples.empty())
            m_shift_s =
                newest_s + std::chrono::duration<double>(now - m_newest).count() - samples.back().time_s;
        m_returned = m_returned && samples.empty();
        m_newest = now;
        for (Sample& sample : samples)
            sample.time_s += m_shift_s;
        return samples;
    }

private:
    using Clock = std::chrono::steady_clock;
    double m_shift_s = 0;
    bool m_returned = false;
    Clock::time_point m_newest;
};

} // namespace

struct Workbench::Private {
    Private(const QString& libraryFile, const QString& settingsFile)
        : settings(settingsFile), library(libraryFile), connection(factory), enrollment(connection, library),
          inspection(connection, library)
    {
    }

    // In the order in which they need one another: the sessions go first, then connection and library.
    Settings settings;
    DeviceFactory factory;
    LibraryService library;
    ConnectSession connection;
    EnrollSession enrollment;
    InspectSession inspection;
    LiveHistory history;
    PlotTime plotTime;
    CommandedForce commanded;
    LiveEstimate estimate;
    QThreadPool pool;
    QTimer timer;
    QString operatorName;
    SignIn* signIn = nullptr;
    bool trial = false;
    std::optional<FitSubject> fitSubject;
    std::vector<Waiting> waiting;
    ConnectionView seen;
    std::optional<Error> connectionError, inspectionError, enrollmentError;
    KeepSessions keeping{CaptureFolder::defaultPath(), {}, false};
    bool keeps = false;
    bool captureSuffers = false;                        ///< and that was told
    CheckStatus referenceCheck = CheckStatus::NotAsked; ///< as it was told
    int enrolledSqueezes = 0;
    EnrollSession::Step enrollmentStep = EnrollSession::Step::Name;
    qint64 lastInspection = 0;

    /// In the unit of the force channel; none where that is no unit of force.
    [[nodiscard]] std::vector<std::optional<double>> commandedForces(const std::vector<Sample>& samples);
};

std::vector<std::optional<double>> Workbench::Private::commandedForces(const std::vector<Sample>& samples)
{
    const SafetyGate* gate = connection.gate();
    const std::optional<double> unit_N = newtonsPer(connection.identity().forceUnit);
    if (!gate || !unit_N)
        return {};
    std::vector<std::optional<double>> forces = commanded.follow(samples, gate->lastStarted());
    for (std::optional<double>& force : forces)
        if (force)
            *force /= *unit_N;
    return forces;
}

Workbench::Workbench(const QString& libraryFile, const QString& settingsFile, QObject* parent)
    : QObject(parent), d(std::make_unique<Private>(libraryFile, settingsFile))
{
    d->enrollment.keepDrafts(true);
    d->connection.addListener([this](const std::vector<Sample>& samples) {
        d->history.append(d->plotTime.place(samples, d->history.newestTime_s()), d->commandedForces(samples));
        d->estimate.append(samples);
    });
    d->signIn = new SignIn(*this);
    // A display refreshes at 60 Hz; the sessions ask to be polled every 16 to 33 ms.
    d->timer.setInterval(16);
    d->timer.setTimerType(Qt::PreciseTimer);
    connect(&d->timer, &QTimer::timeout, this, &Workbench::tick);
    d->timer.start();
}

Workbench::~Workbench()
{
    d->timer.stop();
    d->pool.clear();
    d->pool.waitForDone();
    d->connection.stop();
    d->connection.disarm();
}

ConnectSession& Workbench::connection()
{
    return d->connection;
}

EnrollSession& Workbench::enrollment()
{
    return d->enrollment;
}

InspectSession& Workbench::inspection()
{
    return d->inspection;
}

LibraryService& Workbench::library()
{
    return d->library;
}

Settings& Workbench::settings()
{
    return d->settings;
}

const LiveHistory& Workbench::liveHistory() const
{
    return d->history;
}

const LiveEstimate& Workbench::liveEstimate() const
{
    return d->estimate;
}

SignIn& Workbench::signIn()
{
    return *d->signIn;
}

QString Workbench::operatorName() const
{
    return d->operatorName;
}

void Workbench::setOperatorName(const QString& name)
{
    if (d->operatorName == name)
        return;
    d->operatorName = name;
    d->enrollment.setOperator(name);
    d->inspection.setOperator(name);
    emit operatorChanged();
}

StoredRates Workbench::rates() const
{
    return {d->inspection.rates(), d->inspection.earlyEnd()};
}

void Workbench::setRates(const StoredRates& rates)
{
    d->inspection.setRates(rates.rates);
    d->inspection.setEarlyEnd(rates.earlyEnd);
    emit ratesChanged();
}

bool Workbench::keepsSessions() const
{
    return d->keeps;
}

const KeepSessions& Workbench::keeping() const
{
    return d->keeping;
}

void Workbench::setKeeping(const KeepSessions& how, bool on)
{
    d->keeping = how;
    d->keeps = on;
    d->factory.keepSessions(on ? std::optional(how) : std::nullopt);
    emit keepingChanged();
}

void Workbench::connectTo(const QString& address)
{
    d->connectionError.reset();
    d->seen = {}; // the next one may be open before anybody looks, and must not pass for the one before
    if (const Expected<void> done = d->connection.connectTo(address); !done)
        report(done.error().describe());
}

void Workbench::arm()
{
    const QString person = d->operatorName.isEmpty() ? tr("operator not named") : d->operatorName;
    if (const Expected<void> done = d->connection.arm(person); !done)
        report(done.error().describe());
}

void Workbench::stop()
{
    d->connection.stop();
    d->connection.disarm();
    emit stopped();
}

bool Workbench::squeezing() const
{
    return d->trial || d->inspection.state() == InspectSession::State::Squeezing ||
           d->enrollment.activity() == EnrollSession::Activity::Squeezing;
}

void Workbench::setTrialRunning(bool running)
{
    d->trial = running;
}

void Workbench::showInFit(FitSubject subject)
{
    setFitSubject(std::move(subject));
    emit fitRequested();
}

void Workbench::setFitSubject(FitSubject subject)
{
    d->fitSubject = std::move(subject);
    emit fitSubjectChanged();
}

const std::optional<FitSubject>& Workbench::fitSubject() const
{
    return d->fitSubject;
}

void Workbench::tellLibraryChanged()
{
    d->inspection.reload();
    emit libraryChanged();
}

void Workbench::whenReady(QObject* context, std::function<bool()> ready, std::function<void()> then)
{
    d->waiting.push_back({context, context != nullptr, std::move(ready), std::move(then)});
}

void Workbench::runInPool(std::function<void()> work)
{
    d->pool.start(std::move(work));
}

void Workbench::tick()
{
    d->connection.poll();
    d->estimate.setForceLag(d->connection.forceLag_s());
    noticeConnection();
    noticeCapture();
    noticeReferenceCheck();
    noticeEnrollment();
    noticeInspection();
    answerWaiting();
    emit ticked();
}

void Workbench::noticeConnection()
{
    const ConnectionView now{d->connection.state(), d->connection.armed(), d->connection.address(),
                             d->connection.port() ? d->connection.identity().serial : QString(),
                             d->connection.reconnections()};
    if (now != d->seen) {
        const bool opened = now.state == ConnectSession::State::Connected && d->seen.state != now.state;
        const bool back = opened && now.reconnections > d->seen.reconnections;
        d->seen = now;
        if (opened) {
            d->commanded.reset();
            const GripperIdentity identity = d->connection.identity();
            if (back) {
                d->plotTime.noticeReturn();
            } else {
                d->plotTime.reset();
                d->history.reset(identity.sampleTime_s);
                d->estimate.reset(identity.sampleTime_s, identity.hold, d->connection.forceLag_s());
            }
            applyMeasuringChain(now.serial);
            applyCalibrations(now.serial);
        }
        emit connectionChanged();
    }
    noticeError(d->connectionError, d->connection.lastError());
}

void Workbench::noticeCapture()
{
    const CaptureStatus status = d->factory.captureStatus();
    const bool suffers = status.problem || status.droppedRecords > 0;
    if (suffers == d->captureSuffers)
        return;
    d->captureSuffers = suffers;
    if (status.problem)
        report(tr("The raw reports of this session are not being kept: %1 Measuring goes on.")
                   .arg(status.problem->describe()));
    else if (suffers)
        report(
            tr("The disk is too slow: of the raw reports of this session %n are not kept. Measuring goes on.",
               nullptr, static_cast<int>(std::min<std::uint64_t>(status.droppedRecords, 1'000'000'000))));
}

void Workbench::applyMeasuringChain(const QString& serial)
{
    using Found = std::optional<MeasuringChainRecord>;
    ask<Found>(
        this, [serial](Library& library) { return library.measuringChain(serial); },
        [this, serial](const Expected<Found>& found) {
            if (!found)
                return report(found.error().describe());
            if (*found && d->seen.serial == serial)
                putInForce(d->connection, **found);
        });
}

void Workbench::applyCalibrations(const QString& serial)
{
    ask<CalibrationsInForce>(
        this, [serial](Library& library) { return library.calibrationsInForce(serial); },
        [this, serial](const Expected<CalibrationsInForce>& found) {
            if (!found)
                return report(found.error().describe());
            if (d->seen.serial != serial)
                return;
            d->connection.setCalibrations(*found);
            if (const QString& words = d->connection.calibration().unusable(); !words.isEmpty())
                report(words);
            emit connectionChanged();
        });
}

void Workbench::noticeReferenceCheck()
{
    const bool connected = d->connection.state() == ConnectSession::State::Connected;
    const std::optional<ReferenceStanding> none;
    const std::optional<ReferenceStanding>& standing =
        connected ? d->connection.calibration().reference() : none;
    const QDateTime now = QDateTime::currentDateTimeUtc();
    const CheckStatus status = checkStatus(standing, now);
    if (std::exchange(d->referenceCheck, status) == status)
        return;
    if (status == CheckStatus::Due || status == CheckStatus::Failed)
        report(tr("Check on the reference spring: %1 Make it on the Calibrate page.")
                   .arg(ReferenceWords::status(standing, now)));
}

void Workbench::noticeEnrollment()
{
    if (!d->enrollment.poll())
        return;
    const int accepted = d->enrollment.acceptedCount();
    const EnrollSession::Step step = d->enrollment.step();
    const bool stored = accepted != d->enrolledSqueezes ||
                        (step == EnrollSession::Step::Approved && d->enrollmentStep != step);
    d->enrolledSqueezes = accepted;
    d->enrollmentStep = step;
    noticeError(d->enrollmentError, d->enrollment.lastError());
    if (stored)
        tellLibraryChanged();
    emit enrollmentChanged();
}

void Workbench::noticeInspection()
{
    if (!d->inspection.poll())
        return;
    noticeError(d->inspectionError, d->inspection.lastError());
    const auto& result = d->inspection.result();
    const qint64 number = result ? result->number : 0;
    const bool stored = number != 0 && number != d->lastInspection;
    d->lastInspection = number;
    if (stored)
        emit libraryChanged();
    emit inspectionChanged();
}

void Workbench::noticeError(std::optional<Error>& known, const std::optional<Error>& now)
{
    if (known == now)
        return;
    known = now;
    if (now)
        report(&known == &d->connectionError ? connectionErrorWords(d->connection, *now)
                                             : squeezeErrorWords(d->connection, *now));
}

void Workbench::answerWaiting()
{
    // Taken out first: an answer may ask again.
    std::vector<Waiting> answered;
    const auto rest = std::stable_partition(d->waiting.begin(), d->waiting.end(), [](const Waiting& w) {
        return !(w.bound && w.context.isNull()) && !w.ready();
    });
    std::move(rest, d->waiting.end(), std::back_inserter(answered));
    d->waiting.erase(rest, d->waiting.end());
    for (const Waiting& w : answered)
        if (!w.bound || !w.context.isNull())
            w.then();
}

} // namespace gripscope
