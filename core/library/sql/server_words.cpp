// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/server_words.h"

#include "core/base/words.h"

#include <QSqlError>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Without libpq's line ends, the prefix of its severity and the place of the source.
QString serverSays(const QSqlError& error)
{
    const QString text = error.databaseText().isEmpty() ? error.driverText() : error.databaseText();
    return text.simplified();
}

bool saysOneOf(const QString& text, std::initializer_list<QLatin1StringView> parts)
{
    return std::any_of(parts.begin(), parts.end(),
                       [&](QLatin1StringView part) { return text.contains(part, Qt::CaseInsensitive); });
}

QString userOf(const ServerAddress& server)
{
    return server.user.isEmpty() ? qEnvironmentVariable("USER") : server.user; // as libpq does
}

QString placeOf(const ServerAddress& server)
{
    if (server.host.startsWith(u'/'))
        return u"%1/.s.PGSQL.%2"_s.arg(server.host).arg(server.port);
    const QString host = server.host.isEmpty() ? u"localhost"_s : server.host;
    return u"%1:%2"_s.arg(host).arg(server.port);
}

} // namespace

SqlFailure serverFailure(const QSqlError& error)
{
    using Kind = SqlFailure::Kind;
    const QString state = error.nativeErrorCode();
    const QString said = serverSays(error);
    const auto ended = [] {
        return Words::tr("the server ended the connection; what is asked for next connects again");
    };
    // Without a state it was not the server that answered: libpq found no connection.
    if (state.isEmpty() && !error.databaseText().isEmpty())
        return {Kind::Lost, ended()};
    if (state.startsWith("08"_L1) || state == "57P01"_L1 || state == "57P02"_L1 || state == "57P03"_L1 ||
        state == "57P05"_L1 || state == "25P03"_L1)
        return {Kind::Lost, ended()};
    if (state == "55P03"_L1)
        return {Kind::Busy,
                Words::tr("another program kept it locked for %1 s").arg(sqlBusyTimeout_ms / 1000)};
    if (state == "57014"_L1)
        return {Kind::Failed, Words::tr("the server took too long and was stopped; try again when it has "
                                        "less to do")};
    if (state == "53100"_L1)
        return {Kind::Failed, Words::tr("the server's disk is full; who looks after it has to make room")};
    if (state == "53300"_L1)
        return {Kind::Failed, Words::tr("the server has no connection left; end other programs, or let "
                                        "max_connections be raised")};
    if (state == "42501"_L1)
        return {Kind::Failed,
                Words::tr("the server does not permit it (%1); let who looks after it grant the rights, or "
                          "make this user the owner of the database")
                    .arg(said)};
    if (state == "25006"_L1)
        return {Kind::Failed, Words::tr("the server may only be read from, as a copy that follows another; "
                                        "name the one that is written to")};
    if (state == "XX001"_L1 || state == "XX002"_L1)
        return {Kind::Corrupt, said};
    return {Kind::Failed, said};
}

QString whyNotConnected(const ServerAddress& server, const QSqlError& error)
{
    const QString said = serverSays(error);
    if (saysOneOf(said, {"no password supplied"_L1, "kein Passwort angegeben"_L1}))
        return Words::tr("the server asks for the password of user %1, and none was found: write the line "
                         "HOST:PORT:DATABASE:USER:PASSWORD into the file .pgpass of your home folder, which "
                         "only you may read (chmod 600)")
            .arg(userOf(server));
    if (saysOneOf(said, {"password authentication failed"_L1, "Passwort-Authentifizierung"_L1,
                         "authentication failed"_L1, "Authentifizierung"_L1}))
        return Words::tr("the server refuses the password of user %1: look at the file .pgpass of your home "
                         "folder")
            .arg(userOf(server));
    if (saysOneOf(said, {"no pg_hba.conf entry"_L1, "kein pg_hba.conf-Eintrag"_L1}))
        return Words::tr(
                   "the server does not let user %1 in from this computer, or not without encryption: its "
                   "pg_hba.conf has no line for it")
            .arg(userOf(server));
    const bool isMissing = saysOneOf(said, {"does not exist"_L1, "existiert nicht"_L1});
    if (isMissing && saysOneOf(said, {"role "_L1, "Rolle "_L1}))
        return Words::tr("the server at %1 knows no user %2: let who looks after it make one (createuser)")
            .arg(placeOf(server), userOf(server));
    if (isMissing && saysOneOf(said, {"database "_L1, "Datenbank "_L1}))
        return Words::tr("there is no database %1 on %2: let who looks after it make one (createdb)")
            .arg(server.database, placeOf(server));
    if (saysOneOf(said, {"certificate"_L1, "Zertifikat"_L1, "SSL"_L1}))
        return Words::tr("no safe connection with %1 came about (%2): look at sslmode and sslrootcert")
            .arg(placeOf(server), said);
    if (saysOneOf(said, {"refused"_L1, "verweigert"_L1, "No such file"_L1, "nicht gefunden"_L1, "timeout"_L1,
                         "timed out"_L1, "Zeit"_L1, "no route"_L1, "unreachable"_L1, "translate host"_L1,
                         "Hostname"_L1}))
        return Words::tr("no server answers at %1: see that it runs, and that name, port and network are "
                         "right (%2)")
            .arg(placeOf(server), said);
    return Words::tr("the server at %1 says: %2").arg(placeOf(server), said);
}

} // namespace gripscope
