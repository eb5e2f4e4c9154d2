// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/calibrate_example.h"

#include "core/calibration/calibration_plan.h"
#include "core/signal/gaussian.h"

namespace gripscope {

using namespace Qt::StringLiterals;

SensorCalibration exampleCalibration()
{
    SensorCalibration calibration;
    calibration.gripperSerial = u"VG-1"_s;
    calibration.gripperName = u"Virtual gripper"_s;
    calibration.unit = u"N"_s;
    calibration.reference = {u"Weights M1, set 4711"_s, u"D-K-17 2026-03"_s, 0.002, 0};
    calibration.operatorName = u"Mai"_s;
    calibration.takenUtc = QDateTime::currentDateTimeUtc();
    calibration.due = calibration.takenUtc.date().addYears(1);
    CalibrationPlan plan;
    plan.runs = 3;
    GaussianNoise noise(4);
    constexpr double noise_N = 0.01;
    constexpr double hysteresis_N = 0.02;
    const double full = plan.loads.back();
    for (const PlannedPoint& point : plannedPoints(plan)) {
        const double sag =
            point.ascending ? 0 : 4 * hysteresis_N * point.load / full * (1 - point.load / full);
        calibration.points.push_back({point.load, 0.05 + 1.012 * point.load + sag + noise_N * noise()});
    }
    return calibration;
}

ReferenceObject exampleReference()
{
    ReferenceObject reference;
    reference.gripperSerial = u"VG-1"_s;
    reference.name = u"Spring S-12"_s;
    reference.certificate = u"F-0815 2026-02"_s;
    reference.stated[2] = ReferenceQuantity{9990, 25, 300};
    reference.operatorName = u"Mai"_s;
    return reference;
}

Expected<void> storeExamples(Library& library)
{
    if (Expected<void> done = library.addCalibration(exampleCalibration()); !done)
        return done;
    const ReferenceObject reference = exampleReference();
    if (Expected<void> done = library.addReferenceObject(reference); !done)
        return done;
    const Expected<CalibrationsInForce> standing = library.calibrationsInForce(reference.gripperSerial);
    if (!standing)
        return tl::unexpected<Error>(standing.error());
    for (const double stiffness : {9952.0, 10010.0, 9973.0, 10021.0}) {
        ReferenceCheck check;
        check.gripperSerial = reference.gripperSerial;
        check.referenceId = standing->reference->reference.id;
        check.measured[2] = MeasuredQuantity{stiffness, 30};
        check.verdict = judgeCheck(reference, check.measured);
        check.squeezes = reference.squeezes;
        check.operatorName = reference.operatorName;
        if (Expected<void> done = library.addReferenceCheck(check); !done)
            return done;
    }
    return {};
}

} // namespace gripscope
