// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/squeeze_record.h"
#include "core/library/records/type_record.h"

namespace gripscope {

/// An enrolment that was begun: kept at every step, so that it can be gone on with after a break or a crash.
/// A name has one; its newest row is in force.
struct EnrollmentDraft {
    enum class Step { Recipe, Squeeze, Review };
    QString name; ///< of the type
    Recipe recipe;
    Step step = Step::Recipe;
    QString part;      ///< which part is being squeezed
    QString pictureId; ///< empty: none
    QString pendingId; ///< of the squeeze that waits for a decision; empty: none
    QString operatorName;
    QString remark;      ///< what was done, for whoever reads the rows
    QDateTime changed{}; ///< not read when stored
    int squeezes = 0;    ///< accepted ones of the type; not read when stored
};

/// What became of a draft.
enum class DraftEnd { Approved, Discarded };

/// A squeeze as it came from the gripper, before anybody decided on it.
struct DraftSqueeze {
    QString id;   ///< newTimeOrderedId()
    QString name; ///< of the type
    Recording recording;
    QString source, part;
};

/// A picture of a part, as it was read: at most a thousand pixels wide or high.
struct PartPicture {
    QString id;     ///< newTimeOrderedId()
    QString format; ///< "png" or "jpeg"
    int width = 0, height = 0;
    QByteArray bytes;
    friend bool operator==(const PartPicture&, const PartPicture&) = default;
};

} // namespace gripscope
