// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>
#include <QStringList>

#include <map>
#include <optional>

namespace gripscope {

/// A database on a PostgreSQL server.
struct ServerAddress {
    QString host; ///< a name, an address, or the folder of a local socket; empty: libpq's own choice
    int port = 5432;
    QString database;
    QString user;                       ///< empty: who runs the program
    std::map<QString, QString> options; ///< of libpq, as sslmode
    friend bool operator==(const ServerAddress&, const ServerAddress&) = default;
};

/// Where a library is: a file of this computer, or a database on a server,
/// "postgresql://user@host:port/name?sslmode=verify-full" (libpq's own form, with "postgres:" too). It holds
/// no password: libpq finds it (PGPASSFILE, ~/.pgpass, PGPASSWORD).
class LibraryLocation {
public:
    /// StorageOpen: an address that leads nowhere, or holds a password; says what to write instead. Any other
    /// text is the name of a file.
    [[nodiscard]] static Expected<LibraryLocation> parse(const QString& text);
    /// By its beginning alone.
    [[nodiscard]] static bool isOnServer(const QString& text);

    [[nodiscard]] const QString& file() const { return m_file; } ///< empty: on a server
    [[nodiscard]] const std::optional<ServerAddress>& server() const { return m_server; }
    /// As parse() takes it; never with a password.
    [[nodiscard]] QString text() const;
    /// The same for all who mean the same database, whoever they are and however they connect. Of a file: its
    /// name.
    [[nodiscard]] QString key() const;

private:
    QString m_file;
    std::optional<ServerAddress> m_server;
};

/// Of text that may be an address with a password in it: what may be shown.
[[nodiscard]] QString withoutPassword(const QString& text);

/// "plant on db.example:5432" for a person; a file's name as it is.
[[nodiscard]] QString shortLibraryName(const QString& text);

/// A file of this computer's own that goes with a library: beside it, its name with this at its end; of one
/// on a server, in the user's data folder.
[[nodiscard]] QString fileWithLibrary(const QString& library, const QString& suffix);

} // namespace gripscope
