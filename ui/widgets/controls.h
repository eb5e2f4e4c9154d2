// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QString>

class QBoxLayout;
class QScrollArea;

namespace gripscope {

/// Sets the look of a widget by its role in the style sheet (see ui/theme/style_sheet.h).
void setRole(QWidget* widget, const char* role);

/// A white surface with a border: the container of everything on a page.
[[nodiscard]] QFrame* makeCard(QWidget* parent = nullptr);
/// `inside` as wide as there is room, scrolled down where it is too high.
[[nodiscard]] QScrollArea* makeScroll(QWidget* inside, QWidget* parent = nullptr);
/// A thin line across a card.
[[nodiscard]] QFrame* makeRule(QWidget* parent = nullptr);
[[nodiscard]] QLabel* makeLabel(const QString& text, const char* role = "", QWidget* parent = nullptr);
/// A button with an icon of the theme; `role` "" (plain), "primary" or "quiet".
[[nodiscard]] QPushButton* makeButton(const QString& text, const QString& icon = {}, const char* role = "",
                                      QWidget* parent = nullptr);
/// A caption and under it a value in strong type ("–" at first), at the end of `row`; gives the value's
/// label.
[[nodiscard]] QLabel* addCaptionedValue(QBoxLayout* row, const QString& caption, int minimumWidth,
                                        QWidget* parent);
/// Margins and spacing in steps of the theme.
void setSpacing(QBoxLayout* layout, int margin, int spacing);

} // namespace gripscope
