// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/verdict/verdict.h"

#include <QJsonObject>
#include <QString>

namespace gripscope::cli {

/// One entry of the results of classify.
[[nodiscard]] QJsonObject verdictJson(const QString& file, const Verdict& verdict);
/// The same for a person.
[[nodiscard]] QString verdictText(const QString& file, const Verdict& verdict);

} // namespace gripscope::cli
