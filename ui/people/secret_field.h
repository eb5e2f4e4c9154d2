// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/secret.h"

class QLineEdit;
class QWidget;

namespace gripscope {

/// A line for a PIN or password: nothing of it is shown, copied or suggested.
[[nodiscard]] QLineEdit* makeSecretField(const QString& name, QWidget* parent);
/// Takes what was typed; the line is empty then, and its text wiped as far as a text field can be.
[[nodiscard]] Secret takeSecret(QLineEdit& field);

} // namespace gripscope
