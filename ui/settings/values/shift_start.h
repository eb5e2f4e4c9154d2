// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// Where the shift of a station began, as it is kept from one start to the next: after which inspection of
/// which library. In another library nothing was inspected yet, and all of it counts.
struct ShiftStart {
    QString library; ///< its file
    qint64 after = 0;

    [[nodiscard]] QString text() const;
    /// The text tells of a shift of this library; where that began with it, afterIn() is 0 too.
    [[nodiscard]] static bool isOf(const QString& library, const QString& text);
    /// 0 where the text is of another library, or says nothing.
    [[nodiscard]] static qint64 afterIn(const QString& library, const QString& text);
};

} // namespace gripscope
