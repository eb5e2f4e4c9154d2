// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/library/records/history.h"
#include "core/library/records/history_list.h"
#include "core/library/records/type_record.h"

#include <QByteArray>
#include <QStringList>

#include <optional>
#include <vector>

namespace gripscope {

enum class HistoryFormat { Csv, Json, Aqdef };
[[nodiscard]] QString toString(HistoryFormat format); ///< "csv", "json", "aqdef"

/// Squeezes as lines of CSV: UTF-8, LF, C locale, times in UTC, numbers in their shortest form that reads
/// back the same, m, b and k in the squeeze's own units, which stand beside them.
[[nodiscard]] QByteArray toCsv(const std::vector<HistoryEntry>& entries);
/// The header of those lines.
[[nodiscard]] QByteArray historyCsvHeader();
/// One squeeze; the manual's page on the history tells every member. What is not known is null.
[[nodiscard]] QJsonObject toJson(const HistoryEntry& entry);
/// What a query lets through: only the members that narrow it.
[[nodiscard]] QJsonObject toJson(const HistoryQuery& query);

/// What the head of an AQDEF file (Q-DAS ASCII transfer format, .dfq) says before the values: gathered from
/// all squeezes first.
class AqdefCatalogue {
public:
    void add(const std::vector<HistoryEntry>& entries);
    [[nodiscard]] const std::optional<QString>& type() const { return m_type; } ///< of all; empty: various
    /// K-fields, a line each. `type`: the record of the one type, for its limits; null: none.
    [[nodiscard]] QByteArray head(const TypeRecord* type) const;
    /// A line a squeeze: m, b and k with char 15 between, each its fields with char 20 between: value,
    /// attribute (0; 255: it does not count), time, events, batch, nest, operator, machine, process
    /// parameter, gauge. SI; times in UTC; Latin-1, lines end with CR LF.
    [[nodiscard]] QByteArray lines(const std::vector<HistoryEntry>& entries) const;

private:
    [[nodiscard]] QString line(const HistoryEntry& entry) const;
    QStringList m_operators, m_stations, m_gauges; ///< numbered from 1
    std::optional<QString> m_type;
    bool m_begun = false;
};

/// All that a query finds as one text, piece by piece, so that neither memory nor the library is taken by it
/// for long. JSON: {"format": "gripscope-history", "version": 1, ..., "squeezes": [...]}, a squeeze a line.
/// AQDEF: goes through them twice, since its head names all that the values point to.
/// In the order asked for; where that is not by time and a list of it would be cut, all of them newest first.
class HistoryDocument {
public:
    HistoryDocument(HistoryQuery query, HistoryFormat format);

    /// The next piece, of some hundred squeezes; empty while they are counted, and after the last. On the
    /// library's thread.
    [[nodiscard]] Expected<QByteArray> next(Library& library);
    [[nodiscard]] bool ended() const { return m_ended; }
    [[nodiscard]] std::size_t written() const { return std::size_t(m_written); }
    [[nodiscard]] std::size_t total() const { return m_list ? std::size_t(m_list->rows) : 0; }

private:
    [[nodiscard]] QByteArray head() const;
    [[nodiscard]] QByteArray rows(const std::vector<HistoryEntry>& entries);
    HistoryQuery m_query;
    HistoryFormat m_format;
    [[nodiscard]] Expected<void> prepare(Library& library);
    [[nodiscard]] Expected<void> gather(Library& library);
    std::optional<HistoryList> m_list;
    qint64 m_written = 0;
    AqdefCatalogue m_catalogue;
    std::optional<TypeRecord> m_type; ///< that all are of
    qint64 m_gathered = 0;
    bool m_begun = false;
    bool m_first = true, m_ended = false;
};

} // namespace gripscope
