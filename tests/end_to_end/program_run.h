// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>
#include <QTest>

namespace gripscope::test {

/// What a program left behind.
struct ProgramRun {
    int exit = -1; ///< -1: it crashed or did not end
    QByteArray out, err;

    /// Standard output as the one document it is to be; empty when there is anything else on it.
    [[nodiscard]] QJsonObject json() const
    {
        QJsonParseError error;
        const QJsonDocument document = QJsonDocument::fromJson(out, &error);
        return error.error == QJsonParseError::NoError ? document.object() : QJsonObject();
    }
    /// One document a line.
    [[nodiscard]] QList<QJsonObject> jsonLines() const
    {
        QList<QJsonObject> documents;
        for (const QByteArray& line : out.split('\n'))
            if (!line.isEmpty())
                documents << QJsonDocument::fromJson(line).object();
        return documents;
    }
};

inline QString cliProgram()
{
    return QStringLiteral(GRIPSCOPE_BIN_DIR "/gripscope-cli");
}

/// A temporary folder that the command line runs in, with a home of its own.
class Workplace {
public:
    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }

    void write(const QString& name, const QByteArray& text) const
    {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), qint64(text.size()));
    }

    void prepare(QProcess& process, const QStringList& arguments) const
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("HOME"), m_folder.path());
        environment.insert(QStringLiteral("XDG_DATA_HOME"), m_folder.path());
        environment.insert(QStringLiteral("USER"), QStringLiteral("tester"));
        process.setProcessEnvironment(environment);
        process.setWorkingDirectory(m_folder.path());
        process.setProgram(cliProgram());
        process.setArguments(arguments);
    }

    [[nodiscard]] ProgramRun cli(const QStringList& arguments) const
    {
        QProcess process;
        prepare(process, arguments);
        process.start();
        const bool ended = process.waitForFinished(300'000) && process.exitStatus() == QProcess::NormalExit;
        return {ended ? process.exitCode() : -1, process.readAllStandardOutput(),
                process.readAllStandardError()};
    }

private:
    QTemporaryDir m_folder;
};

} // namespace gripscope::test
