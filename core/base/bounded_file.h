// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QByteArray>
#include <QString>

class QFile;

namespace gripscope {

/// Files that others made, opened so that none can hang or exhaust the program: a pipe, a device or a folder
/// is refused before it is opened, and so is a file of more than `most` bytes (a sparse one costs nobody
/// anything to make). Names that begin with ':' are the program's own resources.

/// Opens `file`, named already, for reading. FileUnreadable.
[[nodiscard]] Expected<void> openRegular(QFile& file);
/// All of `file`; nothing of it is read where it is larger than `most`. FileUnreadable.
[[nodiscard]] Expected<QByteArray> readBounded(const QString& file, qint64 most);

/// Writes a file through a temporary one, so that a crash leaves the old file or the new one. FileUnwritable.
[[nodiscard]] Expected<void> writeWhole(const QString& file, const QByteArray& bytes);

inline constexpr qint64 megabyte = 1'000'000;

} // namespace gripscope
