// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/library_location.h"

#include "core/base/words.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUrl>
#include <QUrlQuery>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// What libpq may be told by an address. Not here: secrets, and what this program sets itself.
const QStringList& knownOptions()
{
    static const QStringList options{u"channel_binding"_s, u"connect_timeout"_s, u"gssencmode"_s,
                                     u"krbsrvname"_s,      u"passfile"_s,        u"sslcert"_s,
                                     u"sslcrl"_s,          u"sslkey"_s,          u"sslmode"_s,
                                     u"sslrootcert"_s,     u"sslsni"_s};
    return options;
}

tl::unexpected<Error> badAddress(const QString& text, const QString& reason)
{
    return failure(ErrorCode::StorageOpen, {withoutPassword(text), reason});
}

QString form()
{
    return Words::tr("write postgresql://USER@HOST:PORT/DATABASE");
}

QString passwordAdvice()
{
    return Words::tr("a password does not belong in an address, which is shown, kept and logged: take it out "
                     "and write the line HOST:PORT:DATABASE:USER:PASSWORD into the file .pgpass of your home "
                     "folder, which only you may read");
}

Expected<void> takeOptions(const QString& text, const QUrl& url, ServerAddress& address)
{
    const auto items = QUrlQuery(url).queryItems(QUrl::FullyDecoded);
    for (const auto& item : items) {
        const QString& name = item.first;
        const QString& value = item.second;
        if (name.contains("password"_L1))
            return badAddress(text, passwordAdvice());
        if (value.contains(u';') || value.contains(QChar::Null))
            return badAddress(text, Words::tr("the value of %1 holds a sign that cannot be in it").arg(name));
        if (name == "host"_L1)
            address.host = value; // the folder of a socket, as libpq takes it
        else if (name == "port"_L1)
            address.port = value.toInt();
        else if (name == "user"_L1)
            address.user = value;
        else if (knownOptions().contains(name))
            address.options[name] = value;
        else
            return badAddress(
                text, Words::tr("it has no option %1; there are %2").arg(name, knownOptions().join(u", "_s)));
    }
    return {};
}

} // namespace

bool LibraryLocation::isOnServer(const QString& text)
{
    return text.startsWith("postgresql://"_L1, Qt::CaseInsensitive) ||
           text.startsWith("postgres://"_L1, Qt::CaseInsensitive);
}

Expected<LibraryLocation> LibraryLocation::parse(const QString& text)
{
    LibraryLocation location;
    if (!isOnServer(text)) {
        location.m_file = text;
        return location;
    }
    const QUrl url(text, QUrl::StrictMode);
    if (!url.isValid())
        return badAddress(text, withoutPassword(text) != text
                                    ? passwordAdvice()
                                    : Words::tr("the address cannot be read; %1").arg(form()));
    if (!url.password().isEmpty())
        return badAddress(text, passwordAdvice());
    ServerAddress address;
    address.host = url.host(QUrl::FullyDecoded);
    address.port = url.port(address.port);
    address.user = url.userName(QUrl::FullyDecoded);
    address.database = url.path(QUrl::FullyDecoded).mid(1);
    RETURN_IF_ERROR(takeOptions(text, url, address));
    if (address.port < 1 || address.port > 65535)
        return badAddress(text, Words::tr("a port is a number from 1 to 65535"));
    if (address.database.isEmpty() || address.database.contains(u'/'))
        return badAddress(text, Words::tr("it names no database; %1").arg(form()));
    if (url.hasFragment())
        return badAddress(text, Words::tr("the address cannot be read; %1").arg(form()));
    location.m_server = std::move(address);
    return location;
}

QString LibraryLocation::text() const
{
    if (!m_server)
        return m_file;
    QUrl url;
    url.setScheme(u"postgresql"_s);
    url.setUserName(m_server->user, QUrl::DecodedMode);
    const bool isFolder = m_server->host.startsWith(u'/');
    url.setHost(isFolder ? QString() : m_server->host, QUrl::DecodedMode);
    if (!isFolder && !m_server->host.isEmpty())
        url.setPort(m_server->port);
    url.setPath(u'/' + m_server->database, QUrl::DecodedMode);
    QUrlQuery query;
    if (isFolder)
        query.addQueryItem(u"host"_s, m_server->host);
    if (isFolder || m_server->host.isEmpty())
        query.addQueryItem(u"port"_s, QString::number(m_server->port));
    for (const auto& [name, value] : m_server->options)
        query.addQueryItem(name, value);
    if (!query.isEmpty())
        url.setQuery(query);
    QString text = url.toString(QUrl::FullyEncoded);
    if (url.authority().isEmpty() && !text.startsWith("postgresql://"_L1))
        text.replace("postgresql:"_L1, "postgresql://"_L1);
    return text;
}

QString LibraryLocation::key() const
{
    if (!m_server)
        return m_file;
    return u"postgresql://%1:%2/%3"_s.arg(m_server->host.toLower())
        .arg(m_server->port)
        .arg(m_server->database);
}

QString withoutPassword(const QString& text)
{
    if (!LibraryLocation::isOnServer(text))
        return text;
    // By hand: an address that is shown because it cannot be read may hold one too.
    QString shown = text;
    const qsizetype begin = shown.indexOf("://"_L1) + 3;
    const qsizetype at = shown.lastIndexOf(u'@');
    const qsizetype colon = shown.indexOf(u':', begin);
    if (at > 0 && colon > 0 && colon < at)
        shown.replace(colon + 1, at - colon - 1, u"***"_s);
    const qsizetype query = shown.indexOf(u'?');
    if (query > 0 && shown.indexOf("password"_L1, query) > 0)
        shown.truncate(query);
    return shown;
}

QString shortLibraryName(const QString& text)
{
    const Expected<LibraryLocation> location = LibraryLocation::parse(text);
    if (!location)
        return withoutPassword(text);
    if (!location->server())
        return QFileInfo(text).fileName();
    const ServerAddress& server = *location->server();
    const QString host = server.host.isEmpty() || server.host.startsWith(u'/') ? u"localhost"_s : server.host;
    return Words::tr("%1 on %2").arg(server.database, host);
}

QString fileWithLibrary(const QString& library, const QString& suffix)
{
    const Expected<LibraryLocation> location = LibraryLocation::parse(library);
    if (location && !location->server())
        return library + suffix;
    const QByteArray key = (location ? location->key() : withoutPassword(library)).toUtf8();
    const QByteArray name = QCryptographicHash::hash(key, QCryptographicHash::Sha256).toHex().left(32);
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + u"/gripscope/servers"_s;
    QDir().mkpath(folder);
    return u"%1/%2%3"_s.arg(folder, QString::fromLatin1(name), suffix);
}

} // namespace gripscope
