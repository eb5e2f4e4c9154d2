// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/calibrate/calibrate_session.h"

#include "core/base/words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double driftShareAllowed = 5e-4; ///< of the range of loads: beside any sensor worth calibrating
constexpr double leastStepShare = 0.2;     ///< of the load's step: a smaller one in the reading is doubtful

std::optional<Error> notReady(ConnectSession& connection)
{
    if (connection.state() != ConnectSession::State::Connected)
        return Error{ErrorCode::DeviceRefused,
                     {Words::tr("calibrate"), Words::tr("no gripper is connected")}};
    if (connection.armed())
        return Error{ErrorCode::DeviceRefused,
                     {Words::tr("calibrate"), Words::tr("it is armed, and hands are near: disarm it first")}};
    return std::nullopt;
}

/// Empty where the channel's own scale is taken.
QString correctionText(const CalibrationRecord* inForce)
{
    if (inForce == nullptr)
        return u""_s;
    const Expected<CalibrationEvaluation> evaluation = evaluateCalibration(*inForce);
    return evaluation ? SensorCorrection(evaluation->curve).text() : u""_s;
}

} // namespace

struct CalibrateSession::Private {
    Private(ConnectSession& session, LibraryService& service) : connection(session), library(service) {}

    ConnectSession& connection;
    LibraryService& library;
    QString operatorName;
    State state = State::Idle;
    CalibrationPlan plan;
    GripperIdentity gripper;
    QString foundCorrection; ///< in force when it was begun
    std::vector<PlannedPoint> planned;
    std::vector<TakenPoint> points;
    std::optional<Expected<CalibrationEvaluation>> evaluation;
    std::optional<Error> error;
    QDateTime begun;
    PendingCall storing;

    std::optional<int> listener;
    std::vector<double> values;
    std::size_t wanted = 0;
    std::optional<double> load; ///< of the point being read, where it is not the planned one
    bool saturated = false;
    bool changed = false;

    void listen();
    void stopListening();
    void finishReading();
    void evaluate();
    [[nodiscard]] QString unit() const;
    [[nodiscard]] SensorCalibration calibration() const;
    [[nodiscard]] double driftAllowed() const
    {
        return driftShareAllowed * (plan.loads.back() - plan.loads.front());
    }
    [[nodiscard]] QString doubtOf(const PlannedPoint& point, const SteadyReading& reading) const;
};

QString CalibrateSession::Private::unit() const
{
    return plan.channel == SensorChannel::Force ? gripper.forceUnit : gripper.positionUnit;
}

SensorCalibration CalibrateSession::Private::calibration() const
{
    SensorCalibration calibration;
    calibration.gripperSerial = gripper.serial;
    calibration.gripperName = gripper.name;
    calibration.channel = plan.channel;
    calibration.unit = unit();
    calibration.reference = plan.reference;
    calibration.degree = plan.degree;
    calibration.operatorName = operatorName;
    calibration.takenUtc = begun;
    calibration.conditions = plan.conditions;
    calibration.foundCorrection = foundCorrection;
    calibration.points.reserve(points.size());
    for (const TakenPoint& point : points)
        (point.planned.check ? calibration.checkPoints : calibration.points)
            .push_back({point.planned.load, point.reading.mean});
    return calibration;
}

void CalibrateSession::Private::listen()
{
    values.clear();
    saturated = false;
    wanted = static_cast<std::size_t>(std::ceil(plan.averaging_s / gripper.sampleTime_s));
    const bool force = plan.channel == SensorChannel::Force;
    const std::uint16_t end = force ? StatusForceSaturated : StatusPositionSaturated;
    listener = connection.addListener([this, force, end](const std::vector<Sample>& batch) {
        for (const Sample& sample : batch) {
            if (values.size() == wanted)
                return;
            saturated = saturated || sample.status & end;
            values.push_back(connection.uncorrected(plan.channel, force ? sample.force : sample.position));
        }
    });
    state = State::Reading;
}

void CalibrateSession::Private::stopListening()
{
    if (listener)
        connection.removeListener(*listener);
    listener.reset();
}

QString CalibrateSession::Private::doubtOf(const PlannedPoint& point, const SteadyReading& reading) const
{
    if (points.empty())
        return {};
    const TakenPoint& before = points.back();
    const double step = point.load - before.planned.load;
    const double seen = reading.mean - before.reading.mean;
    if (std::abs(seen) < leastStepShare * std::abs(step))
        return Words::tr("The reading hardly changed. Was the load put on?");
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double rise = (points[i].reading.mean - points[i - 1].reading.mean) /
                            (points[i].planned.load - points[i - 1].planned.load);
        if (std::isfinite(rise) && rise * seen * step < 0)
            return Words::tr("The reading went the other way than before. Is it the right load?");
    }
    return {};
}

void CalibrateSession::Private::finishReading()
{
    stopListening();
    state = State::Waiting;
    SteadyOptions options;
    options.driftAllowed = driftAllowed();
    const SteadyReading reading = steadyReading(values, options);
    if (saturated) {
        error = Error{ErrorCode::DeviceRefused,
                      {Words::tr("take this point"),
                       Words::tr("the channel is at its end, so the load cannot be told")}};
    } else if (reading.status == SteadyStatus::Moving) {
        error = Error{ErrorCode::DeviceRefused,
                      {Words::tr("take this point"),
                       Words::tr("the reading still moves (by %1 %2 within %3 s). Wait until it rests")
                           .arg(reading.drift, 0, 'g', 3)
                           .arg(unit())
                           .arg(plan.averaging_s)}};
    } else if (reading.status == SteadyStatus::TooFewSamples) {
        error = Error{ErrorCode::DeviceRefused,
                      {Words::tr("take this point"), Words::tr("only %1 samples came").arg(reading.samples)}};
    } else {
        PlannedPoint point = planned[points.size()];
        point.load = load.value_or(point.load);
        points.push_back({point, reading, doubtOf(point, reading)});
        evaluate();
    }
}

void CalibrateSession::Private::evaluate()
{
    evaluation.reset();
    const SensorCalibration taken = calibration();
    if (static_cast<int>(taken.points.size()) < plan.degree + 2)
        return;
    evaluation = evaluateCalibration(taken);
}

CalibrateSession::CalibrateSession(ConnectSession& connection, LibraryService& library)
    : d(std::make_unique<Private>(connection, library))
{
}

CalibrateSession::~CalibrateSession()
{
    d->stopListening();
}

void CalibrateSession::setOperator(const QString& name)
{
    d->operatorName = name;
}

Expected<void> CalibrateSession::start(const CalibrationPlan& plan)
{
    if (d->state == State::Storing)
        return failure(ErrorCode::Usage, {Words::tr("A calibration is being stored. Wait for its end.")});
    RETURN_IF_ERROR(problemOf(plan));
    RETURN_IF_ERROR(notReady(d->connection));
    abandon();
    d->plan = plan;
    d->planned = plannedPoints(plan);
    d->gripper = d->connection.identity();
    d->foundCorrection = correctionText(d->connection.calibration().record(plan.channel));
    d->begun = QDateTime::currentDateTimeUtc();
    d->state = State::Waiting;
    return {};
}

Expected<void> CalibrateSession::take(std::optional<double> load)
{
    if (d->state != State::Waiting || !next())
        return failure(ErrorCode::Usage, {Words::tr("There is no point to be taken now.")});
    if (load && !std::isfinite(*load))
        return failure(ErrorCode::Usage, {Words::tr("The load that was put on must be a number.")});
    RETURN_IF_ERROR(notReady(d->connection));
    if (d->connection.identity().serial != d->gripper.serial)
        return failure(ErrorCode::DeviceRefused,
                       {Words::tr("take this point"),
                        Words::tr("it is another gripper than the one that was begun with (%1)")
                            .arg(d->gripper.serial)});
    d->error.reset();
    d->load = load;
    d->listen();
    return {};
}

void CalibrateSession::stopReading()
{
    if (d->state != State::Reading)
        return;
    d->stopListening();
    d->state = State::Waiting;
}

void CalibrateSession::undo()
{
    if (d->state != State::Waiting || d->points.empty())
        return;
    d->points.pop_back();
    d->error.reset();
    d->evaluate();
    d->changed = true;
}

void CalibrateSession::abandon()
{
    d->stopListening();
    d->storing = {};
    d->points.clear();
    d->planned.clear();
    d->evaluation.reset();
    d->error.reset();
    d->state = State::Idle;
    d->changed = true;
}

void CalibrateSession::setDegree(int degree)
{
    d->plan.degree = std::clamp(degree, 1, highestCalibrationDegree);
    d->evaluate();
    d->changed = true;
}

Expected<void> CalibrateSession::accept(const QDate& due, const QString& note)
{
    if (d->state != State::Waiting || next())
        return failure(ErrorCode::Usage,
                       {Words::tr("The calibration is not complete: %1 of %2 points are taken.")
                            .arg(d->points.size())
                            .arg(d->planned.size())});
    if (!d->evaluation || !*d->evaluation)
        return failure(ErrorCode::Usage,
                       {Words::tr("These points make no calibration: %1")
                            .arg(d->evaluation ? d->evaluation->error().describe() : QString())});
    SensorCalibration calibration = this->calibration();
    calibration.due = due;
    calibration.note = note;
    d->error.reset();
    d->state = State::Storing;
    d->storing = PendingCall(d->library.run<CalibrationsInForce>([calibration](Library& library) {
        return library.addCalibration(calibration).and_then([&] {
            return library.calibrationsInForce(calibration.gripperSerial);
        });
    }),
                             [this](const Expected<CalibrationsInForce>& done) {
                                 if (!done) {
                                     d->error = done.error();
                                     d->state = State::Waiting; // the points are still there
                                     return;
                                 }
                                 if (d->connection.identity().serial == d->gripper.serial)
                                     d->connection.setCalibrations(*done);
                                 d->state = State::Stored;
                             });
    return {};
}

bool CalibrateSession::poll()
{
    const State before = d->state;
    bool changed = std::exchange(d->changed, false);
    if (d->state == State::Reading) {
        changed = true;
        if (d->values.size() == d->wanted) {
            d->finishReading();
        } else if (const std::optional<Error> problem = notReady(d->connection)) {
            d->error = problem;
            stopReading();
        }
    }
    changed = d->storing.poll() || changed;
    return changed || d->state != before;
}

CalibrateSession::State CalibrateSession::state() const
{
    return d->state;
}

const CalibrationPlan& CalibrateSession::plan() const
{
    return d->plan;
}

const std::vector<PlannedPoint>& CalibrateSession::planned() const
{
    return d->planned;
}

const std::vector<TakenPoint>& CalibrateSession::points() const
{
    return d->points;
}

std::optional<PlannedPoint> CalibrateSession::next() const
{
    return d->points.size() < d->planned.size() ? std::optional(d->planned[d->points.size()]) : std::nullopt;
}

double CalibrateSession::readingProgress() const
{
    return d->state == State::Reading && d->wanted > 0
               ? static_cast<double>(d->values.size()) / static_cast<double>(d->wanted)
               : 0;
}

double CalibrateSession::driftAllowed() const
{
    return d->plan.loads.empty() ? 0 : d->driftAllowed();
}

const std::optional<Expected<CalibrationEvaluation>>& CalibrateSession::evaluation() const
{
    return d->evaluation;
}

SensorCalibration CalibrateSession::calibration() const
{
    return d->calibration();
}

std::optional<Error> CalibrateSession::error() const
{
    return d->error;
}

} // namespace gripscope
