// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/trend_plot.h"

#include <QColor>
#include <QPointF>
#include <QRectF>

#include <array>
#include <optional>

namespace gripscope {

// The signs of types in charts of squeezes, and such charts as one figure. On any thread.

[[nodiscard]] QColor typeSignColor(int sign, const ThemeTokens& tokens);
/// A type's own sign, about `size` pixels across; -1: of no type.
void paintTypeSign(QPainter& painter, int sign, QPointF at, double size, const ThemeTokens& tokens);
/// Behind the sign of a squeeze whose measurement is in doubt a filled diamond, as a verdict on it has one; a
/// cross where it was not valid. Nothing for a clean one.
void paintDoubt(QPainter& painter, const std::optional<ValidityVerdict>& validity, QPointF at, double size,
                const ThemeTokens& tokens);

/// The signs with the names of their types, in as many lines as `box` has room for.
void paintTypeLegend(QPainter& painter, const TrendContent& content, const QRectF& box,
                     const ThemeTokens& tokens);
/// Of all names at this width, logical pixels.
[[nodiscard]] int typeLegendHeight(const TrendContent& content, double width);

/// Where m, b and k stand in a room: below each other, alike but for the axis of the lowest.
[[nodiscard]] std::array<QRectF, 3> trendBoxes(const QRectF& room);
/// What the lines at the ends of gates are, where there are any.
[[nodiscard]] QString trendGateNote();
/// A row a squeeze: when, m, b, k with their standard errors, the type, what the measurement is worth.
[[nodiscard]] PlotTable trendNumbers(const TrendContent& content);
/// Legend, m, b and k; nothing outside of `size`.
void paintTrendFigure(QPainter& painter, const TrendContent& content, QSizeF size, const ThemeTokens& tokens);

} // namespace gripscope
