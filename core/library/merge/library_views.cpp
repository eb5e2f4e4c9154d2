// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/ledger/ledgered_tables.h"
#include "core/library/ledger/merged_rows.h"
#include "core/library/merge/row_taker.h"
#include "core/library/records/library_change.h"
#include "core/library/sql/statement.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString readingView()
{
    return Words::tr("read how another station numbers");
}

Expected<void> readRecipes(Statement& query, LibraryView& view)
{
    return query.forEach([&](Statement& row) {
        const QString type = row.takeText();
        const qint64 number = row.takeInteger();
        view.recipes[{type, number}] = row.takeText();
    });
}

Expected<LibraryView> ownView(Database& database)
{
    LibraryView view;
    const QString meeting = toString(ChangeKind::Meeting);
    Statement changes(database, readingView(), u"SELECT version, id, kind FROM library_changes"_s);
    RETURN_IF_ERROR(changes.forEach([&](Statement& row) {
        const qint64 version = row.takeInteger();
        const QString key = row.takeText();
        if (row.takeText() == meeting)
            view.meetings.insert(version);
        else
            view.changes[version] = key;
    }));
    Statement recipes(database, readingView(), u"SELECT type_id, version, id FROM type_versions"_s);
    RETURN_IF_ERROR(readRecipes(recipes, view));
    return view;
}

Expected<LibraryView> mergedView(Database& database, const QString& library)
{
    LibraryView view;
    const quint8 changes = ledgeredTable(u"library_changes"_s)->code;
    ASSIGN_OR_RETURN(const auto versions, merged_rows::numbers(database, library, changes, false));
    for (const auto& [key, version] : versions)
        view.changes[version] = key;
    ASSIGN_OR_RETURN(const auto meetings, merged_rows::numbers(database, library, changes, true));
    for (const auto& [key, version] : meetings)
        view.meetings.insert(version);
    Statement recipes(
        database, readingView(),
        u"SELECT v.type_id, m.number, m.row_key FROM merged_rows m JOIN type_versions v ON v.id = "
        "m.row_key WHERE m.library = ? AND m.table_code = ? AND m.whole = 0"_s);
    recipes.bind(library).bind(int(ledgeredTable(u"type_versions"_s)->code));
    RETURN_IF_ERROR(readRecipes(recipes, view));
    return view;
}

} // namespace

QString LibraryView::changeAt(qint64 version) const
{
    const auto after = changes.upper_bound(version);
    return after == changes.begin() ? QString() : std::prev(after)->second;
}

Expected<const LibraryView*> LibraryViews::of(const QString& library)
{
    auto found = m_views.find(library);
    if (found == m_views.end()) {
        ASSIGN_OR_RETURN(auto view, library == m_own ? ownView(m_source) : mergedView(m_source, library));
        found = m_views.emplace(library, std::move(view)).first;
    }
    return &found->second;
}

} // namespace gripscope
