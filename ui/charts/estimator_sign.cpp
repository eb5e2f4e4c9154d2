// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/estimator_sign.h"

#include "ui/theme/theme.h"

#include <QPainter>

#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

/// A regular polygon, its first corner at `turn` (radians, 0 is to the right).
QPolygonF polygon(QPointF center, double radius, int corners, double turn)
{
    QPolygonF result;
    for (int i = 0; i < corners; ++i) {
        const double angle = turn + 2 * std::numbers::pi * i / corners;
        result << center + radius * QPointF(std::cos(angle), std::sin(angle));
    }
    return result;
}

} // namespace

void paintEstimatorSign(QPainter& painter, Estimator estimator, QPointF at, double size)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const double radius = size / 2;
    constexpr double up = -std::numbers::pi / 2;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const bool outlined = tokens.kind != ThemeKind::Light;
    painter.setPen(outlined ? QPen(tokens.text, 1) : QPen(tokens.surface, 0.75));
    painter.setBrush(Theme::typeColor(int(estimator)));
    switch (estimator) {
    case Estimator::Arx:
        painter.drawPolygon(polygon(at, 1.15 * radius, 3, up));
        break;
    case Estimator::ArxMeanForce:
        painter.drawPolygon(polygon(at, 1.15 * radius, 4, std::numbers::pi / 4));
        break;
    case Estimator::Arx221:
        painter.drawPolygon(polygon(at, 1.15 * radius, 4, 0));
        break;
    case Estimator::InstrumentalVariables:
        painter.drawPolygon(polygon(at, 1.15 * radius, 3, -up));
        break;
    case Estimator::OutputError:
        painter.drawEllipse(at, radius, radius);
        break;
    case Estimator::Duffing:
        painter.drawPolygon(polygon(at, 1.1 * radius, 5, up));
        break;
    case Estimator::Periodic:
        painter.drawPolygon(polygon(at, 1.1 * radius, 6, 0));
        break;
    }
    painter.restore();
}

} // namespace gripscope
