// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"

#include <QPointF>

class QPainter;

namespace gripscope {

/// The estimator's own sign, about `size` pixels across: shape and colour both tell it.
void paintEstimatorSign(QPainter& painter, Estimator estimator, QPointF at, double size);

} // namespace gripscope
