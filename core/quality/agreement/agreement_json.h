// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/agreement/attribute_agreement.h"

#include <QJsonObject>

namespace gripscope {

/// As `gripscope-cli study attributes` prints it: raters by name, pairs as a list; what does not exist is
/// null.
[[nodiscard]] QJsonObject toJson(const AttributeAgreement& study);

} // namespace gripscope
