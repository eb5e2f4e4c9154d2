// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/exchange/delivery.h"

#include <QDateTime>

#include <optional>

namespace gripscope {

/// What a station remembers of its plant's server, so that a program that starts without the network can
/// tell what waits. Only told to people: what is brought follows from what the server has.
struct LinkNote {
    QString server;        ///< its address, without a password
    QDateTime lastReached; ///< UTC
    DeliveredLinks delivered;
    friend bool operator==(const LinkNote&, const LinkNote&) = default;
};

/// Beside the library.
[[nodiscard]] QString linkNoteFile(const QString& library);
/// Nothing where there is none of this server, or none that can be read.
[[nodiscard]] std::optional<LinkNote> readLinkNote(const QString& file, const QString& server);
/// All of it or nothing, whatever ends the program. StorageFailed.
[[nodiscard]] Expected<void> writeLinkNote(const QString& file, const LinkNote& note);

} // namespace gripscope
