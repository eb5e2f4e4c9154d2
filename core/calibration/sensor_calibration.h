// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_figures.h"
#include "core/calibration/conditions.h"

#include <QDate>
#include <QDateTime>
#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

enum class SensorChannel { Force, Position };
[[nodiscard]] QString toString(SensorChannel channel); ///< "force", "position"
[[nodiscard]] std::optional<SensorChannel> sensorChannelFromString(const QString& text);

/// What the loads were realised with.
struct CalibrationReference {
    QString name;                   ///< "Weights M1, set 4711"
    QString certificate;            ///< its number; may be empty
    double standardUncertainty = 0; ///< of each load, in the channel's unit
    double relativeUncertainty = 0; ///< standard, of each load; added in quadrature to the other
    QDate due = {};                 ///< until when its certificate holds; invalid where nobody said
};

/// One sensor of one gripper against a reference: all that was seen, and what was decided. The curve follows
/// from points and degree, so it is not kept.
struct SensorCalibration {
    QString gripperSerial, gripperName;
    SensorChannel channel = SensorChannel::Force;
    QString unit; ///< of loads and readings: the channel's own
    CalibrationReference reference;
    std::vector<CalibrationPoint> points; ///< in the order they were taken
    int degree = 1;
    QString operatorName, note;
    QDateTime takenUtc;
    QDate due; ///< the last day it holds
    CalibrationConditions conditions;
    /// What corrected the channel before, as SensorCorrection::text(): empty where it was its own scale.
    /// Nothing where that was not recorded.
    std::optional<QString> foundCorrection;
    /// Taken once more after the points and not fitted: a check of the curve by what it has not seen.
    std::vector<CalibrationPoint> checkPoints;
};

/// What the points of a calibration say.
struct CalibrationEvaluation {
    CalibrationCurve curve;
    CalibrationFigures figures;
    std::vector<double> residuals; ///< reading less the curve, in the order of the points
    /// Of one load found from one reading, 95 %, the largest in the range; in the channel's unit. It holds
    /// the scatter about the curve (which has repeatability and reversibility in it, where points were taken
    /// so), the curve's own uncertainty, the reference, and the zero's return as a rectangle. Student's t
    /// with the degrees of freedom of Welch and Satterthwaite (JCGM 100:2008, G.4).
    double expandedUncertainty = 0;
    double coverageFactor =
        0; ///< its k: it over the standard uncertainty there; 0 where nothing is uncertain
    /// Standard, relative, of differences of the load: what the channel's scale is uncertain by. From the
    /// curve's mean slope, and the reference's relative part.
    double scaleUncertainty = 0;
};

/// BadInput as CalibrationCurve::fit(), or where the reference's uncertainties are negative or not finite.
[[nodiscard]] Expected<CalibrationEvaluation> evaluateCalibration(const SensorCalibration& calibration);

/// Expanded uncertainty (95 %) of one load found from one reading there, as above.
[[nodiscard]] double expandedUncertaintyAt(const CalibrationEvaluation& evaluation,
                                           const CalibrationReference& reference, double load);

/// Loads that the gripper said less those that were put on, in the order of the points, in the channel's
/// unit.
struct LoadErrors {
    std::vector<double> each;
    double largest = 0; ///< magnitude
};

/// As the channel was found: by what corrected it until then. Nothing where that was not recorded.
[[nodiscard]] std::optional<LoadErrors> errorsAsFound(const SensorCalibration& calibration);
/// As it is left: by the new curve; of the check points where there are any, else of the points that it was
/// fitted to.
[[nodiscard]] LoadErrors errorsAsLeft(const SensorCalibration& calibration,
                                      const CalibrationEvaluation& evaluation);

enum class CalibrationConformity { Conforms, DoesNotConform, Undecided };

/// Guarded: conforms where error + U <= tolerance, does not where error - U > tolerance, undecided between
/// (guard band U, ILAC-G8:09/2019, 4.2.3). Simple: conforms where error <= tolerance, else does not.
[[nodiscard]] CalibrationConformity judgeConformity(double largestError, double expandedUncertainty,
                                                    double tolerance, DecisionRule rule);

enum class CalibrationStatus { Missing, Valid, DueSoon, Overdue };
inline constexpr int dueSoonDays = 14;
/// On `today`; missing where there is none.
[[nodiscard]] CalibrationStatus calibrationStatus(const std::optional<QDate>& due, const QDate& today);

} // namespace gripscope
