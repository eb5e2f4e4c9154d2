// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of a gripper, and what comes of one, as a library takes them.
#pragma once

#include "core/base/words.h"
#include "core/library/records/gripper_adjustment.h"
#include "core/library/records/study_record.h"
#include "tests/core/library/library_fixture.h"

#include <QJsonArray>

namespace gripscope::test {

inline NewStudy aStudy(const QString& name = u"Cans, gripper 1"_s)
{
    NewStudy study;
    study.kind = u"gauge"_s;
    study.name = name;
    study.plan = {{u"seed"_s, u"18446744073709551615"_s}, {u"rows"_s, QJsonArray{QJsonArray{0, 1, 0, 2}}}};
    study.options = {{u"tolerances"_s, QJsonArray{1.0 / 3}}};
    study.recipe.name = u"squeeze-7N"_s;
    study.recipe.peak_N = 7;
    study.recipe.kind = ExcitationKind::FourLevel;
    study.gripperSerial = u"F-1"_s;
    study.operatorName = u"Zoë"_s;
    return study;
}

inline NewStudyMeasurement aMeasurement(const QString& studyId, qint64 row = 0)
{
    NewStudyMeasurement measured;
    measured.studyId = studyId;
    measured.row = row;
    measured.outcome = u"measured"_s;
    measured.values = {StudyValue{0.04, 1e-17}, std::nullopt, StudyValue{9990 + 1.0 / 3, 2.5}};
    measured.units = {u"kg"_s, u"N s/m"_s, u"N/m"_s};
    measured.rating = u"good"_s;
    measured.validity = u"suspect"_s;
    measured.reasons = {Words::say("The type needs a name."), Finding(u"its own words"_s)};
    measured.gripperSerial = u"F-1"_s;
    measured.operatorName = u"Ada"_s;
    return measured;
}

inline NewAdjustment anAdjustment(const QString& serial = u"F-2"_s)
{
    NewAdjustment adjustment;
    adjustment.gripperSerial = serial;
    adjustment.gripperName = u"Right cell"_s;
    adjustment.enrolledOn = QStringList{u"F-1"_s};
    adjustment.types = QStringList{u"A"_s, u"Zoë, \"large\""_s};
    adjustment.squeezes = 10;
    adjustment.error.value = Eigen::Vector3d(0.05, 1.0 / 30, -1e-17);
    adjustment.error.covariance = Eigen::Vector3d(1e-4, 1.0 / 3e4, 2e-5).asDiagonal();
    adjustment.error.covariance(0, 1) = adjustment.error.covariance(1, 0) = 1e-6;
    adjustment.error.degreesOfFreedom = 18;
    adjustment.error.pValue = 1e-9;
    adjustment.error.agreement = 0.4;
    adjustment.error.misfit = 2.5;
    adjustment.operatorName = u"Ada"_s;
    adjustment.reason = u"second line"_s;
    return adjustment;
}

} // namespace gripscope::test
