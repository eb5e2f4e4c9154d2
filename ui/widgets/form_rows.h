// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFormLayout>
#include <QLabel>

namespace gripscope {

/// Captions at the left, fields at the right, in steps of the theme.
[[nodiscard]] QFormLayout* makeForm();
/// The caption as high as its field, its text in the middle: QFormLayout alone sets it some pixels above.
void addFormRow(QFormLayout* form, QLabel* caption, QWidget* field);

} // namespace gripscope
