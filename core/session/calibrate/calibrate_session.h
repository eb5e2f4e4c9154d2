// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_plan.h"
#include "core/library/library_service.h"
#include "core/session/connection/connect_session.h"

#include <memory>

namespace gripscope {

/// A point of a calibration as it was taken.
struct TakenPoint {
    PlannedPoint planned;
    SteadyReading reading;
    QString doubt; ///< what a person should look at; empty when nothing
};

/// Calibrates one channel of the connected gripper: a person puts on load after load, the session averages
/// what the channel says, and in the end keeps the calibration in the library. The gripper is not moved, and
/// must not be armed: hands are near.
///
///     Idle -> Waiting <-> Reading;  Waiting -> Storing -> Stored
///
/// Waiting: for the load of next() to be put on and take() to be called. Nothing is lost by an error: the
/// state stays, and error() says why the last step was not done. Readings are those of the device itself,
/// without the calibration that is in force.
class CalibrateSession {
public:
    enum class State { Idle, Waiting, Reading, Storing, Stored };

    CalibrateSession(ConnectSession& connection, LibraryService& library);
    ~CalibrateSession();
    CalibrateSession(const CalibrateSession&) = delete;
    CalibrateSession& operator=(const CalibrateSession&) = delete;

    void setOperator(const QString& name);
    /// Usage: a plan that makes no sense. DeviceRefused: no gripper, or an armed one.
    [[nodiscard]] Expected<void> start(const CalibrationPlan& plan);
    /// Averages the channel for the plan's time. `load`: what was really put on, where a load cell says so;
    /// the planned one otherwise. DeviceRefused while armed. Usage: a load that is not finite.
    [[nodiscard]] Expected<void> take(std::optional<double> load = {});
    void stopReading();         ///< back to Waiting, without a point
    void undo();                ///< the last point is to be taken again
    void abandon();             ///< Idle; what was taken is forgotten
    void setDegree(int degree); ///< the points stay
    /// Keeps the calibration and puts it in force. Usage: points are missing, or no evaluation.
    [[nodiscard]] Expected<void> accept(const QDate& due, const QString& note);
    bool poll(); ///< never waits; true when something changed

    [[nodiscard]] State state() const;
    [[nodiscard]] const CalibrationPlan& plan() const;
    [[nodiscard]] const std::vector<PlannedPoint>& planned() const;
    [[nodiscard]] const std::vector<TakenPoint>& points() const;
    [[nodiscard]] std::optional<PlannedPoint> next() const; ///< nothing when all are taken
    [[nodiscard]] double readingProgress() const;           ///< 0 to 1, of the point being read
    [[nodiscard]] double driftAllowed() const; ///< by which a reading may move, in the channel's unit
    /// Of the points so far, once they are enough for the degree.
    [[nodiscard]] const std::optional<Expected<CalibrationEvaluation>>& evaluation() const;
    /// The calibration as it stands, to be shown or stored.
    [[nodiscard]] SensorCalibration calibration() const;
    [[nodiscard]] std::optional<Error> error() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
