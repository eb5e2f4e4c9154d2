// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene/scene_content.h"

#include <QString>

namespace gripscope::test {

/// Four types of ten squeezes in SI, a fixed lattice around each centre, with an ellipsoid that holds the
/// lattice.
inline SceneContent sceneExample()
{
    const std::vector<Eigen::Vector3d> centres{
        {0.0396, 43.0, 9990}, {0.062, 78.0, 21000}, {0.025, 61.0, 15500}, {0.078, 30.0, 26000}};
    const Eigen::Vector3d spread(0.0016, 1.8, 500);
    SceneContent content;
    for (int type = 0; type < 4; ++type) {
        const Eigen::Vector3d& centre = centres[std::size_t(type)];
        for (int n = 0; n < 10; ++n) {
            const Eigen::Vector3d offset((n % 3) - 1, (n / 3) % 3 - 1, (n * 7 % 5) / 2.0 - 1);
            const QString id = QStringLiteral("%1%2").arg(QChar(u'A' + type)).arg(n);
            content.points.push_back({id, centre + offset.cwiseProduct(spread), type, type});
        }
        content.ellipsoids.push_back({{centre, Eigen::Matrix3d::Identity(), 2.2 * spread}, type});
    }
    const auto bounds = contentBounds(content);
    content.axes = {
        axisScale(QStringLiteral("Mass m"), QStringLiteral("kg"), bounds(0, 0), bounds(0, 1)),
        axisScale(QStringLiteral("Damping b"), QStringLiteral("N s/m"), bounds(1, 0), bounds(1, 1)),
        axisScale(QStringLiteral("Stiffness k"), QStringLiteral("N/m"), bounds(2, 0), bounds(2, 1))};
    return content;
}

} // namespace gripscope::test
