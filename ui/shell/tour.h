// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme/theme.h"

#include <QSize>
#include <QString>

#include <chrono>

namespace gripscope {

struct TourOptions {
    QString folder;
    ThemeKind theme = ThemeKind::Light;
    QSize size{1440, 900};
    QString language = QStringLiteral("en");
    std::chrono::milliseconds patience{30000}; ///< for a page to be ready, all tries together
};

/// Opens the program on the virtual gripper and a temporary library with the example types, brings every page
/// to a telling state and saves one picture a page, named after its id. 0, or 1 with words on standard error:
/// a page that was not ready in time, of which there is no picture then, or one that could not be written.
[[nodiscard]] int runTour(const TourOptions& options);

} // namespace gripscope
