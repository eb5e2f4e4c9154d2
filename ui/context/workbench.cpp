// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/workbench.h"

#include "core/calibration/calibration_record.h"
#include "core/session/squeeze/stored_chain.h"
#include "devices/replay/capture_folder.h"
#include "ui/context/connection_words.h"
#include "ui/context/doorbell.h"
#include "ui/context/sign_in.h"
#include "ui/format/reference_words.h"
#include "ui/settings/values/settings.h"
#include "ui/widgets/plain_text.h"

#include <QTimer>

#include <utility>

namespace gripscope {

namespace {

/// As ConnectSession says it; the library may be locked by another program for a while.
constexpr std::chrono::seconds askAgainAfter{2};

/// What connectionChanged() is told from.
struct ConnectionView {
    ConnectSession::State state = ConnectSession::State::Disconnected;
    bool armed = false;
    QString address, serial;
    int reconnections = 0;
    friend bool operator==(const ConnectionView&, const ConnectionView&) = default;
};

} // namespace

struct Workbench::Private {
    Private(Workbench* bench, const QString& libraryFile, const QString& settingsFile)
        : settings(settingsFile), library(libraryFile), connection(factory), enrollment(connection, library),
          inspection(connection, library), study(connection, library),
          bell(bench, [bench] { bench->tick(); }), background(library, bell.button())
    {
    }

    // In the order in which they need one another: the sessions go first, then connection and library.
    Settings settings;
    DeviceFactory factory;
    LibraryService library;
    ConnectSession connection;
    EnrollSession enrollment;
    InspectSession inspection;
    StudySession study;
    LiveFeed live;
    Messages messages;
    Navigator navigator;
    QTimer timer;
    QTimer untilTheEnd; ///< while a part is squeezed
    QString operatorName;
    SignIn* signIn = nullptr;
    JudgingPolicy policy;
    bool onlySignedIn = false;
    bool trial = false;
    int stops = 0; ///< asked for by a person
    ConnectionView seen;
    std::optional<Error> connectionError, inspectionError, enrollmentError, studyError;
    std::optional<Error> unreadTold; ///< why it is not known what the library knows of the gripper
    KeepSessions keeping{CaptureFolder::defaultPath(), {}, false};
    bool keeps = false;
    bool captureSuffers = false;                        ///< and that was told
    CheckStatus referenceCheck = CheckStatus::NotAsked; ///< as it was told
    int enrolledSqueezes = 0;
    EnrollSession::Step enrollmentStep = EnrollSession::Step::Name;
    qint64 lastInspection = 0;
    Doorbell bell;
    Background background; // last, so that it is done with before what its work uses goes
};

Workbench::Workbench(const QString& libraryFile, const QString& settingsFile, QObject* parent)
    : QObject(parent), d(std::make_unique<Private>(this, libraryFile, settingsFile))
{
    keepTextPlain();
    d->enrollment.keepDrafts(true);
    d->connection.awaitCalibrations(true);
    d->inspection.setWake(d->bell.button());
    d->connection.addListener(
        [this](const std::vector<Sample>& samples) { d->live.take(samples, d->connection); });
    d->signIn = new SignIn(*this);
    connect(d->signIn, &SignIn::changed, this, &Workbench::applyPolicy);
    // A display refreshes at 60 Hz; the sessions ask to be polled every 16 to 33 ms.
    d->timer.setInterval(16);
    d->timer.setTimerType(Qt::PreciseTimer);
    connect(&d->timer, &QTimer::timeout, this, &Workbench::tick);
    d->timer.start();
    // Somebody waits for the verdict: from the last sample on no time is lost to the display's pace.
    d->untilTheEnd.setInterval(4);
    d->untilTheEnd.setTimerType(Qt::PreciseTimer);
    connect(&d->untilTheEnd, &QTimer::timeout, this, &Workbench::lookForTheEnd);
}

Workbench::~Workbench()
{
    d->timer.stop();
    d->untilTheEnd.stop();
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

StudySession& Workbench::study()
{
    return d->study;
}

LibraryService& Workbench::library()
{
    return d->library;
}

Settings& Workbench::settings()
{
    return d->settings;
}

const LiveFeed& Workbench::live() const
{
    return d->live;
}

Background& Workbench::background()
{
    return d->background;
}

Messages& Workbench::messages()
{
    return d->messages;
}

Navigator& Workbench::navigator()
{
    return d->navigator;
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
    d->study.setOperator(name);
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

void Workbench::setJudgingPolicy(const JudgingPolicy& policy, bool onlySignedIn)
{
    d->policy = policy;
    d->onlySignedIn = onlySignedIn;
    applyPolicy();
}

void Workbench::applyPolicy()
{
    d->policy.nobodySignedIn = d->onlySignedIn && d->signIn->inForce() && !d->signIn->current();
    d->inspection.setPolicy(d->policy);
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

void Workbench::setLinkLimits(const LinkLimits& limits)
{
    d->factory.setLinkLimits(limits);
}

void Workbench::connectTo(const QString& address)
{
    const Expected<void> done = d->connection.connectTo(address);
    if (!done)
        d->messages.report(done.error().describe(), untilConnected());
    if (!done && d->connection.state() != ConnectSession::State::Disconnected)
        return; // the one before goes on
    d->connectionError.reset();
    d->seen = {}; // the next one may be open before anybody looks, and must not pass for the one before
}

/// Until a gripper is connected that was not when this was asked for; a connection that goes on says nothing.
Messages::Condition Workbench::untilConnected() const
{
    if (d->connection.state() == ConnectSession::State::Connected)
        return nullptr;
    return [this] { return d->connection.state() != ConnectSession::State::Connected; };
}

/// Who may is what the library's policy says. Stopped while that is asked, it is not armed.
void Workbench::arm()
{
    const auto now = [this] {
        const QString person = d->operatorName.isEmpty() ? tr("operator not named") : d->operatorName;
        if (const Expected<void> done = d->connection.arm(person); !done)
            d->messages.report(done.error().describe());
    };
    if (d->connection.state() != ConnectSession::State::Connected)
        return now(); // which says why it cannot be
    // The gripper that was meant, and nobody pressed Stop while somebody signed or the disk was slow.
    const auto meant = [this, stops = d->stops, serial = d->connection.identity().serial] {
        return stops == d->stops && serial == d->connection.identity().serial;
    };
    const auto authorized = [this, now, meant] {
        authorizeArming(*this, [now, meant] {
            if (meant())
                now();
        });
    };
    if (d->connection.calibrationsTold())
        return authorized();
    // Behind what was asked of the library when the gripper answered, so that what is armed can squeeze.
    d->background.ask<void>(
        this, [](Library&) { return Expected<void>(); },
        [authorized, meant](const Expected<void>&) {
            if (meant())
                authorized();
        });
}

void Workbench::stop()
{
    ++d->stops;
    d->connection.stop();
    d->connection.disarm();
    emit stopped();
}

bool Workbench::squeezing() const
{
    return d->trial || d->inspection.state() == InspectSession::State::Squeezing ||
           d->study.state() == StudySession::State::Squeezing ||
           d->enrollment.activity() == EnrollSession::Activity::Squeezing;
}

bool Workbench::busyWithSqueeze()
{
    if (squeezing())
        d->messages.report(tr("Another squeeze is under way. Wait for its end, then try again."),
                           [this] { return squeezing(); });
    return squeezing();
}

void Workbench::setTrialRunning(bool running)
{
    d->trial = running;
}

void Workbench::tellLibraryChanged()
{
    d->inspection.reload();
    emit libraryChanged();
}

void Workbench::tellPlantChanged()
{
    tellLibraryChanged();
    if (d->seen.state == ConnectSession::State::Connected)
        applyKnown(d->seen.serial);
}

void Workbench::tick()
{
    d->connection.poll();
    d->live.setForceLag(d->connection.forceLag_s());
    noticeConnection();
    noticeCapture();
    noticeReferenceCheck();
    noticeEnrollment();
    noticeInspection();
    noticeStudy();
    if (d->inspection.state() == InspectSession::State::Squeezing && !d->untilTheEnd.isActive())
        d->untilTheEnd.start();
    d->background.poll();
    d->messages.poll();
    emit ticked();
}

void Workbench::lookForTheEnd()
{
    if (d->inspection.state() == InspectSession::State::Squeezing) {
        d->connection.poll();
        static_cast<void>(d->inspection.poll());
        if (d->inspection.state() == InspectSession::State::Squeezing)
            return;
        tellInspection();
        tick();
    }
    d->untilTheEnd.stop();
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
            d->live.open(d->connection, back);
            d->unreadTold.reset();
            applyKnown(now.serial);
        }
        emit connectionChanged();
    }
    noticeError(d->connectionError, d->connection.lastError());
}

void Workbench::noticeCapture()
{
    for (const CapturePruning& pruning : d->factory.takePrunings())
        d->background.ask<void>(
            this,
            [pruning](Library& library) {
                return library.tellPruning(pruning.folder, pruning.parts, pruning.bytes, pruning.squeezes);
            },
            [this](const Expected<void>& told) {
                if (!told)
                    d->messages.report(told.error().describe());
            });
    const CaptureStatus status = d->factory.captureStatus();
    const bool suffers = status.problem || status.droppedRecords > 0;
    if (suffers == d->captureSuffers)
        return;
    d->captureSuffers = suffers;
    if (status.problem)
        d->messages.report(tr("The raw reports of this session are not being kept: %1 Measuring goes on.")
                               .arg(status.problem->describe()));
    else if (suffers)
        d->messages.report(
            tr("The disk is too slow: of the raw reports of this session %n are not kept. Measuring goes on.",
               nullptr, static_cast<int>(std::min<std::uint64_t>(status.droppedRecords, 1'000'000'000))));
}

void Workbench::applyKnown(const QString& serial)
{
    d->background.ask<KnownGripper>(
        this, [serial](Library& library) { return knownGripper(library, serial); },
        [this, serial](const Expected<KnownGripper>& found) {
            if (d->seen.serial != serial)
                return;
            if (!found)
                return askAgain(serial, found.error());
            d->unreadTold.reset();
            putInForce(d->connection, *found);
            if (const QString& words = d->connection.calibration().unusable(); !words.isEmpty())
                d->messages.report(words);
            emit connectionChanged();
        });
}

void Workbench::askAgain(const QString& serial, const Error& reason)
{
    d->connection.tellCalibrationsUnread(reason);
    const auto wanted = [this, serial] {
        return d->seen.serial == serial && !d->connection.calibrationsTold();
    };
    const Expected<void> told = d->connection.calibrationsTold();
    if (told) // the gripper was away for a moment: what was in force still is
        return d->messages.report(reason.describe());
    if (d->unreadTold != reason)
        d->messages.report(told.error().describe(), wanted);
    d->unreadTold = reason;
    QTimer::singleShot(askAgainAfter, this,
                       [this, serial, wanted] { wanted() ? applyKnown(serial) : d->unreadTold.reset(); });
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
        d->messages.report(tr("Check on the reference spring: %1 Make it on the Calibrate page.")
                               .arg(ReferenceWords::status(standing, now)),
                           [this, status] { return d->referenceCheck == status; });
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
    if (d->inspection.poll())
        tellInspection();
}

void Workbench::noticeStudy()
{
    if (!d->study.poll())
        return;
    noticeError(d->studyError, d->study.lastError());
    emit studyChanged();
}

void Workbench::tellInspection()
{
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
    if (!now)
        return;
    if (&known != &d->connectionError)
        return d->messages.report(squeezeErrorWords(d->connection, *now));
    const auto away = [this] { return d->connection.state() == ConnectSession::State::Lost; };
    d->messages.report(connectionErrorWords(d->connection, *now),
                       d->connection.awaiting() ? Messages::Condition(away) : untilConnected());
}

} // namespace gripscope
