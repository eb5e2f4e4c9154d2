// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTemporaryDir>

namespace gripscope::test {

/// A test's own settings, library, key of the station and profiles, made before the application: neither the
/// user's own nor those of a test that runs at the same time (Qt's test mode has one folder for all, where
/// one test removed what another was about to read). Programs that the test starts inherit it.
class OwnHome {
public:
    OwnHome()
    {
        if (!m_folder.isValid())
            qFatal("there is no folder for the test's settings: %s", qPrintable(m_folder.errorString()));
        qputenv("XDG_DATA_HOME", m_folder.filePath(QStringLiteral("data")).toLocal8Bit());
        qputenv("XDG_CONFIG_HOME", m_folder.filePath(QStringLiteral("config")).toLocal8Bit());
        qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toLocal8Bit());
    }

private:
    QTemporaryDir m_folder;
};

} // namespace gripscope::test
