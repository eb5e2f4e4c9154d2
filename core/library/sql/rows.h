// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/statement.h"

#include <optional>
#include <utility>
#include <vector>

namespace gripscope {

/// All rows of a query, each taken by `take`; an error when one of them cannot be taken.
template <typename Record>
[[nodiscard]] Expected<std::vector<Record>> allRows(Statement& query, Expected<Record> (*take)(Statement&))
{
    std::vector<Record> records;
    std::optional<Error> error;
    auto done = query.forEach([&](Statement& row) {
        Expected<Record> record = take(row);
        if (record)
            records.push_back(std::move(*record));
        else
            error = record.error();
    });
    if (!done)
        return tl::unexpected<Error>(done.error());
    if (error)
        return tl::unexpected<Error>(*error);
    return records;
}

/// The same where any row can be taken.
template <typename Record>
[[nodiscard]] Expected<std::vector<Record>> allRows(Statement& query, Record (*take)(Statement&))
{
    std::vector<Record> records;
    auto done = query.forEach([&](Statement& row) { records.push_back(take(row)); });
    if (!done)
        return tl::unexpected<Error>(done.error());
    return records;
}

/// The first row of a query, of those that allRows() gives; nothing when there is none.
template <typename Taken>
[[nodiscard]] auto firstRow(Statement& query, Taken (*take)(Statement&))
{
    return allRows(query, take).map([](auto found) {
        return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
    });
}

/// The whole number that the last row begins with; 0 where there is no row.
[[nodiscard]] inline Expected<qint64> numberOf(Statement& query)
{
    qint64 number = 0;
    return query.forEach([&](Statement& row) { number = row.takeInteger(); }).map([&] { return number; });
}

} // namespace gripscope
