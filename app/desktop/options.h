// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QByteArray>
#include <QSize>
#include <QString>
#include <QStringList>

namespace gripscope {

/// What the desktop program was asked for on its command line.
struct DesktopOptions {
    QString tourFolder;    ///< --tour DIR: pictures of every page instead of a window
    QString theme;         ///< --theme light|dark|contrast; empty: as set
    QSize size;            ///< --size 1440x900
    QString language;      ///< --language en|de; empty: as set
    QString device;        ///< --device ADDRESS; empty: the gripper used last
    QString library;       ///< --library FILE; empty: the user's own
    bool examples = false; ///< --examples: adds the example types to the library
    QString answer;        ///< --help or --version: print this and end
};

/// Usage errors name the option and what it may be.
[[nodiscard]] Expected<DesktopOptions> parseDesktopOptions(const QStringList& arguments);

/// --scale, or what is set, as a factor; of the command line it may be anything that parseDesktopOptions()
/// refuses.
[[nodiscard]] QByteArray scaleFactor(int argc, char** argv, const QString& settingsFile);

/// The value of an option that is needed before the application exists: `--name value` or `--name=value`.
[[nodiscard]] QByteArray earlyOption(int argc, char** argv, const char* name);

} // namespace gripscope
