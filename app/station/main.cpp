// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/console.h"
#include "app/station/options.h"
#include "app/station/station.h"
#include "app/terminal/ask_secret.h"
#include "core/library/library.h"
#include "core/library/people/people_register.h"
#include "devices/emergency/end_signals.h"
#include "devices/transport/crash_stop.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonDocument>
#include <QLocale>
#include <QTextStream>

using namespace Qt::StringLiterals;
using namespace gripscope;

namespace {

enum StationExit { ExitDone = 0, ExitUsage = 2, ExitDevice = 4, ExitStorage = 5 };

int failStation(const Error& error)
{
    QTextStream(stderr) << "gripscope-station: " << error.describe() << Qt::endl;
    switch (error.code) {
    case ErrorCode::StorageOpen:
    case ErrorCode::StorageFailed:
    case ErrorCode::StorageUnknown:
    case ErrorCode::StorageNewer:
    case ErrorCode::StorageCorrupt:
    case ErrorCode::FileUnwritable:
        return ExitStorage;
    case ErrorCode::Usage:
    case ErrorCode::BadInput:
    case ErrorCode::NotFound:
        return ExitUsage;
    default:
        return ExitDevice;
    }
}

/// Asked for where people are in the library; who may is decided by the station.
Expected<QString> secretFor(const StationOptions& options)
{
    ASSIGN_OR_RETURN(const bool isThere, Library::isThere(options.library));
    if (!isThere)
        return QString();
    ASSIGN_OR_RETURN(const std::unique_ptr<Library> library, Library::open(options.library));
    ASSIGN_OR_RETURN(const bool inForce, library->people().inForce());
    if (!inForce)
        return QString();
    ASSIGN_OR_RETURN(const Secret secret,
                     askSecret(u"Arming the gripper. PIN or password of %1: "_s.arg(options.person)));
    return QString::fromUtf8(secret.bytes());
}

Expected<QJsonObject> ask(const StationOptions& options)
{
    QJsonObject request{{u"command"_s, options.command}, {u"person"_s, options.person}};
    if (options.command == u"arm"_s) {
        ASSIGN_OR_RETURN(const QString secret, secretFor(options));
        request.insert(u"secret"_s, secret);
    }
    return askStation(options.console, request);
}

int runCommand(const StationOptions& options)
{
    const Expected<QJsonObject> answer = ask(options);
    if (!answer)
        return failStation(answer.error());
    if (!(*answer)[u"done"_s].toBool()) {
        QTextStream(stderr) << "gripscope-station: " << (*answer)[u"message"_s].toString() << Qt::endl;
        return ExitDevice;
    }
    QTextStream(stdout) << QJsonDocument(*answer).toJson(QJsonDocument::Compact) << Qt::endl;
    return ExitDone;
}

int runStation(const StationOptions& options)
{
    Station station(options);
    // Whatever the loop is busy with, the gripper stops first.
    const EndSignals ending([] {
        QMetaObject::invokeMethod(
            QCoreApplication::instance(), [] { QCoreApplication::exit(0); }, Qt::QueuedConnection);
    });
    if (const Expected<void> started = station.start(); !started)
        return failStation(started.error());
    const int exit = QCoreApplication::exec();
    const Expected<void> ended = station.end();
    return ended ? exit : failStation(ended.error());
}

} // namespace

int main(int argc, char** argv)
{
    QCoreApplication::setOrganizationName(u"Gripscope"_s);
    QCoreApplication::setApplicationName(u"Gripscope"_s);
    QCoreApplication::setApplicationVersion(QStringLiteral(GRIPSCOPE_VERSION));
    CrashStop::installHandler();
    const QCoreApplication application(argc, argv);
    QLocale::setDefault(QLocale::c());
    const Expected<StationOptions> options = parseStationOptions(QCoreApplication::arguments());
    if (!options)
        return failStation(options.error());
    if (!options->answer.isEmpty()) {
        QTextStream(stdout) << options->answer << Qt::endl;
        return ExitDone;
    }
    return options->command.isEmpty() ? runStation(*options) : runCommand(*options);
}
