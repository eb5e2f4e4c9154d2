// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

namespace gripscope::test {

/// A PostgreSQL server of a test's own (postgresql.sh), with an empty database.
class PlantServer {
public:
    PlantServer() { run(QStringLiteral("start")); }
    ~PlantServer() { run(QStringLiteral("stop")); }
    PlantServer(const PlantServer&) = delete;
    PlantServer& operator=(const PlantServer&) = delete;

    [[nodiscard]] QString address() const
    {
        QFile address(file());
        return address.open(QIODevice::ReadOnly) ? QString::fromUtf8(address.readAll()).trimmed() : QString();
    }
    void crash() const { run(QStringLiteral("kill")); } ///< and starts again
    void halt() const { run(QStringLiteral("halt")); }
    void go() const { run(QStringLiteral("go")); } ///< after halt()
    void pause() const { run(QStringLiteral("pause")); }
    void resume() const { run(QStringLiteral("resume")); }

private:
    [[nodiscard]] QString file() const { return m_folder.filePath(QStringLiteral("address")); }
    void run(const QString& command) const
    {
        QProcess script;
        script.setStandardOutputFile(QProcess::nullDevice()); // the server inherits it
        script.setStandardErrorFile(QProcess::nullDevice());
        script.start(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/tests/support/postgresql.sh"), {command, file()});
        if (!script.waitForFinished(120'000) || script.exitCode() != 0)
            qFatal("the server did not %s", qPrintable(command));
    }
    QTemporaryDir m_folder;
};

} // namespace gripscope::test
