// SPDX-License-Identifier: GPL-3.0-or-later
// systemd-logind knows of the session (Lock, LockedHint, Active) and of sleep; desktops without it have a
// screen saver. Where neither runs there is nothing to hear.
#include "ui/station/station_watch.h"

#include <QCoreApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusObjectPath>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QPointer>
#include <QThreadPool>
#include <QVariantMap>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

const QString logind = u"org.freedesktop.login1"_s;
const QString sessionInterface = u"org.freedesktop.login1.Session"_s;
const QString managerInterface = u"org.freedesktop.login1.Manager"_s;

class DesktopWatch : public StationWatch {
    Q_OBJECT
public:
    DesktopWatch()
    {
        // Reaching a bus may take a while, and may hang.
        QThreadPool::globalInstance()->start([self = QPointer<DesktopWatch>(this)] {
            const bool system = QDBusConnection::systemBus().isConnected();
            const bool session = QDBusConnection::sessionBus().isConnected();
            if (QCoreApplication* application = QCoreApplication::instance())
                QMetaObject::invokeMethod(application, [self, system, session] {
                    if (self && system)
                        self->listenToSessions();
                    if (self && session)
                        self->listenToScreenSavers();
                });
        });
    }

public slots:
    void lock() { emit left(Departure::Locked); }
    void sleepComes(bool begins)
    {
        if (begins)
            emit left(Departure::Suspended);
    }
    void screenSaverChanged(bool active)
    {
        if (active)
            emit left(Departure::Locked);
    }
    void sessionChanged(const QString& interface, const QVariantMap& changed, const QStringList&)
    {
        if (interface != sessionInterface)
            return;
        if (changed.value(u"LockedHint"_s).toBool())
            emit left(Departure::Locked);
        if (changed.contains(u"Active"_s) && !changed.value(u"Active"_s).toBool())
            emit left(Departure::Switched);
    }

private:
    void listenToSessions()
    {
        QDBusConnection bus = QDBusConnection::systemBus();
        bus.connect(logind, u"/org/freedesktop/login1"_s, managerInterface, u"PrepareForSleep"_s, this,
                    SLOT(sleepComes(bool)));
        QDBusMessage ask = QDBusMessage::createMethodCall(logind, u"/org/freedesktop/login1"_s,
                                                          managerInterface, u"GetSession"_s);
        ask << qEnvironmentVariable("XDG_SESSION_ID", u"auto"_s);
        auto* answer = new QDBusPendingCallWatcher(bus.asyncCall(ask), this);
        connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
            const QDBusPendingReply<QDBusObjectPath> reply = *answer;
            answer->deleteLater();
            if (reply.isValid())
                listenTo(reply.value().path());
        });
    }
    void listenTo(const QString& session)
    {
        QDBusConnection bus = QDBusConnection::systemBus();
        bus.connect(logind, session, sessionInterface, u"Lock"_s, this, SLOT(lock()));
        bus.connect(logind, session, u"org.freedesktop.DBus.Properties"_s, u"PropertiesChanged"_s, this,
                    SLOT(sessionChanged(QString, QVariantMap, QStringList)));
    }
    void listenToScreenSavers()
    {
        QDBusConnection bus = QDBusConnection::sessionBus();
        for (const QString& name : {u"org.freedesktop.ScreenSaver"_s, u"org.gnome.ScreenSaver"_s})
            bus.connect(QString(), QString(), name, u"ActiveChanged"_s, this, SLOT(screenSaverChanged(bool)));
    }
};

} // namespace

std::unique_ptr<StationWatch> makeStationWatch()
{
    return std::make_unique<DesktopWatch>();
}

} // namespace gripscope

#include "station_watch_linux.moc"
