// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/enrollment_draft.h"

#include <QImage>

namespace gripscope {

/// Enough to tell parts apart on any screen, and small beside a recording.
inline constexpr int largestPictureSide = 1024;

/// A PNG or JPEG file, turned as its camera says and made smaller where it is larger than
/// largestPictureSide. FileUnreadable, with the reason: no such file, neither of the two, damaged, too large.
/// Takes up to a second with a large photograph: for the pool.
[[nodiscard]] Expected<PartPicture> readPartPicture(const QString& file);
/// The same of a picture from the clipboard. Usage when there is none.
[[nodiscard]] Expected<PartPicture> toPartPicture(const QImage& image);

/// At most `side` wide and high; a null image where it cannot be read. For the pool, too.
[[nodiscard]] QImage shownPicture(const PartPicture& picture, int side);

} // namespace gripscope
