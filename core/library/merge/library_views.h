// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

#include <map>
#include <set>

namespace gripscope {

class Database;

/// What versions and recipes are numbered in one library.
struct LibraryView {
    std::map<qint64, QString> changes;                     ///< keys of library_changes by version
    std::set<qint64> meetings;                             ///< versions of which rows only follow from others
    std::map<std::pair<QString, qint64>, QString> recipes; ///< keys of type_versions by type and number
    /// The change that a version names; the one before it where that was a meeting. Empty: none.
    [[nodiscard]] QString changeAt(qint64 version) const;
};

/// The views of the libraries that another one knows, itself among them, each read once.
class LibraryViews {
public:
    LibraryViews(Database& source, QString own) : m_source(source), m_own(std::move(own)) {}
    [[nodiscard]] Expected<const LibraryView*> of(const QString& library);

private:
    Database& m_source;
    QString m_own;
    std::map<QString, LibraryView> m_views;
};

} // namespace gripscope
