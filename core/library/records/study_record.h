// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/enrollment_draft.h"

#include <array>

namespace gripscope {

/// A study of how well the gripper measures. What its plan and options say is the business of whoever leads
/// it (core/quality/plan).
struct NewStudy {
    QString kind; ///< "gauge", "type1", ...
    QString name; ///< as a person calls it
    QJsonObject plan, options;
    Recipe recipe;
    QString gripperSerial, operatorName;
};

enum class StudyState { Open, Finished, Abandoned };

struct StudyRecord {
    QString id;
    NewStudy study;
    QDateTime begun;
    StudyState state = StudyState::Open;
    std::optional<QDateTime> ended;
    QString endReason, endedBy;
    qint64 measurements = 0; ///< that count: measured, and not taken back
};

/// A measured quantity with its standard uncertainty.
struct StudyValue {
    double value = 0, standardUncertainty = 0;
    friend bool operator==(const StudyValue&, const StudyValue&) = default;
};

/// One try at a row of the plan.
struct NewStudyMeasurement {
    QString studyId;
    qint64 row = 0;
    QString outcome;                                 ///< "measured", "invalid" or "skipped"
    std::array<std::optional<StudyValue>, 3> values; ///< m, b, k
    std::array<QString, 3> units;                    ///< of m, b, k
    QString rating = {};                             ///< what a rater said
    QString validity = {};                           ///< "valid", "suspect", "invalid"; empty: not squeezed
    Findings reasons = {};                           ///< why it is not valid, or was left out
    QString gripperSerial = {}, operatorName = {};
    std::optional<DraftSqueeze> squeeze = {}; ///< its raw recording, to be kept with it
};

struct StudyMeasurementRecord {
    QString id;
    NewStudyMeasurement measured; ///< without the recording
    QString squeezeId;            ///< of Library::draftSqueeze(); empty: none was kept
    QDateTime stored;
    bool undone = false;
    QString undoReason = {};
};

} // namespace gripscope
