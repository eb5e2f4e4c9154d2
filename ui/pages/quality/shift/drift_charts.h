// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/shift/drift_look.h"
#include "core/session/shift/transfer_look.h"
#include "ui/charts/course_plot.h"
#include "ui/charts/interval_plot.h"

#include <QCoreApplication>
#include <QMap>

namespace gripscope {

/// Pictures of what has moved, and of what an adjustment does.
class DriftCharts {
    Q_DECLARE_TR_FUNCTIONS(DriftCharts)
public:
    /// Of each type, and of all by one factor: the shifts of k, b and m in percent, 95 %. `places`: the
    /// colours of types.
    [[nodiscard]] static IntervalChart shifts(const DriftLook& look, const QMap<QString, int>& places);
    /// Squeeze by squeeze how far one of m, b, k (0, 1, 2) lies from the enrolment, with the change.
    [[nodiscard]] static CourseChart course(const DriftLook& look, std::size_t quantity,
                                            const QMap<QString, int>& places);
    /// Of each type as measured and adjusted by what the others give, and the adjustment itself.
    [[nodiscard]] static IntervalChart adjustment(const TransferLook& look, const QMap<QString, int>& places);
};

} // namespace gripscope
