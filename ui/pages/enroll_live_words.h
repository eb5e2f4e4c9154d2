// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/recursive_estimator.h"

#include <QCoreApplication>
#include <QString>

namespace gripscope {

/// What is known of a squeeze while it runs: k, b and m so far, a line each, and how well the stiffness is
/// known by now.
class LiveSqueezeWords {
    Q_DECLARE_TR_FUNCTIONS(LiveSqueezeWords)
public:
    QString numbers, quality;
};
[[nodiscard]] LiveSqueezeWords liveSqueezeWords(const std::optional<RecursiveState>& state,
                                                const QString& forceUnit, const QString& positionUnit);

/// The lines as every squeeze shows them.
[[nodiscard]] QString threeLines(const QString& k, const QString& b, const QString& m);

} // namespace gripscope
