// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect_session.h"

#include <QBrush>
#include <QColor>
#include <QRectF>
#include <QString>
#include <QStringList>

class QPainter;

namespace gripscope {

/// The words of an outcome, as short as a technician says them: "as expected", "other type", "unknown",
/// "inconclusive", "not valid".
[[nodiscard]] QString outcomeWord(InspectionOutcome outcome);

/// What the screen says of a result: the line read from 3 m, and the one below it.
struct VerdictWords {
    QString headline; ///< "Cola 330 ml", "Unknown", "A or B?", "Squeeze again"
    QString outcome;  ///< "as expected", "other type, expected A", ...
    QString reason;   ///< one sentence why; what to do where the measurement is not valid
};
[[nodiscard]] VerdictWords verdictWords(const InspectSession::Result& result);

/// The sign of an outcome in one colour: check, crossed arrows, question mark, ellipsis, warning triangle.
/// Five shapes that are told apart without colour.
void paintOutcomeSign(QPainter& painter, const QRectF& box, InspectionOutcome outcome, const QColor& color);

/// The fill behind an outcome: a tint, or a pattern of its own where the theme has no tints.
[[nodiscard]] QBrush outcomeFill(InspectionOutcome outcome);

} // namespace gripscope
