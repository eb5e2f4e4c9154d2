// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect/inspect_session.h"

#include <QColor>
#include <QFont>
#include <QIcon>
#include <QObject>
#include <QString>

#include <memory>
#include <optional>

class QPainter;

namespace gripscope {

class StyleSheet;

enum class ThemeKind { Light, Dark, HighContrast };
[[nodiscard]] std::optional<ThemeKind> themeKindFromString(const QString& text); ///< light, dark, contrast

/// The design tokens of one theme; every colour on the screen is one of these.
struct ThemeTokens {
    ThemeKind kind = ThemeKind::Light;
    QColor page, surface, line, text, secondText, accent, stop;
    QColor disabled; ///< words, signs and frames of what cannot be used now
    QColor asExpected, otherType, unknown, inconclusive, notValid, doesNotConform;
    QColor suspect; ///< of any outcome whose measurement is in doubt
    QColor force, position, model;
    QColor selected;     ///< ground of what is chosen in a list, a table or a menu
    QColor selectedEdge; ///< the line below it
    int selectedEdgeWidth = 1;
    int lineWidth = 1;
    int curveWidth = 2;
};
[[nodiscard]] ThemeTokens themeTokens(ThemeKind kind);

/// Sizes in logical pixels.
namespace metrics {
inline constexpr int step = 8;
inline constexpr int insideControl = 4;
inline constexpr int radius = 6;
inline constexpr int touchTarget = 40;
inline constexpr int fontSmall = 12, fontBase = 14, fontLarge = 16, fontTitle = 20, fontNumber = 28,
                     fontVerdict = 72;
} // namespace metrics

/// The theme in force. Widgets that paint themselves read tokens() when they paint and repaint on changed().
class Theme : public QObject {
    Q_OBJECT
public:
    static Theme& instance();
    /// Sets palette, style sheet, font and icon theme of the application.
    void apply(ThemeKind kind);
    [[nodiscard]] const ThemeTokens& tokens() const { return m_tokens; }
    [[nodiscard]] QColor outcomeColor(InspectionOutcome outcome) const;
    /// Of a verdict on a suspect measurement `suspect`, whatever the outcome.
    [[nodiscard]] QColor outcomeColor(InspectionOutcome outcome, bool suspect) const;
    /// Colour of the n-th type that came into the library (TypeRecord::place), one of eight that hold 3 to 1
    /// on light.
    [[nodiscard]] static QColor typeColor(int index);
    /// Its shape: 0 to 3 for sphere, cube, cone, octahedron, so that colour is never alone. The fifth colour
    /// is close to the first: from there on the shapes are shifted by one.
    [[nodiscard]] static constexpr int typeShape(int index) { return (index + index / 4) % 4; }
    /// Ground and lower edge of a row of a list, for delegates that paint all of it.
    static void paintRow(QPainter& painter, const QRect& row, bool selected);
    /// A monochrome icon of the desktop's theme in the text colour (or the one given), sharp at any scale.
    [[nodiscard]] QIcon icon(const QString& name, std::optional<QColor> color = std::nullopt) const;
    [[nodiscard]] static QFont font(int pixels, bool strong = false);
    /// Contrast of two colours after WCAG 2: 1 to 21.
    [[nodiscard]] static double contrastRatio(const QColor& one, const QColor& other);
    /// White or ink, whichever reads better on `fill`.
    [[nodiscard]] static QColor onColor(const QColor& fill);
    /// `share` of the way from one colour to the other: tints.
    [[nodiscard]] static QColor mix(const QColor& one, const QColor& other, double share);

    /// For as long as one stands, and where nothing is to be seen yet, widgets are made without the style
    /// sheet: with it each that gets a place in another is styled anew, and all that is within it.
    class PlainStyle {
    public:
        PlainStyle();
        ~PlainStyle();
        Q_DISABLE_COPY_MOVE(PlainStyle)

    private:
        QString m_sheet;
    };

signals:
    void changed();

private:
    Theme();
    ~Theme() override;
    std::unique_ptr<StyleSheet> m_sheet;
    ThemeKind m_kind = ThemeKind::Light; ///< once there is a sheet
    ThemeTokens m_tokens = themeTokens(ThemeKind::Light);
};

} // namespace gripscope
