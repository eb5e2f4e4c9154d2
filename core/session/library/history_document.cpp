// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/library/history_document.h"

#include "core/base/csv.h"
#include "core/library/history/history_fields.h"

#include <QJsonDocument>
#include <QStringList>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 rowsAtOnce = 500;

QString utc(const QDateTime& time)
{
    return time.toUTC().toString(Qt::ISODateWithMs);
}

QByteArray compact(const QJsonObject& object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

} // namespace

QString toString(HistoryFormat format)
{
    switch (format) {
    case HistoryFormat::Csv:
        return u"csv"_s;
    case HistoryFormat::Json:
        return u"json"_s;
    case HistoryFormat::Aqdef:
        return u"aqdef"_s;
    }
    return {};
}

QByteArray historyCsvHeader()
{
    QByteArrayList heads;
    for (const HistoryField& field : historyFields())
        if (*field.csv != 0)
            heads << field.csv;
    return heads.join(',') + '\n';
}

QByteArray toCsv(const std::vector<HistoryEntry>& entries)
{
    QString text;
    for (const HistoryEntry& entry : entries) {
        QStringList line;
        for (const HistoryField& field : historyFields())
            if (*field.csv != 0)
                for (const QString& cell : field.cells(entry))
                    line << csvCell(cell);
        text += line.join(u',') + u'\n';
    }
    return text.toUtf8();
}

QJsonObject toJson(const HistoryEntry& entry)
{
    QJsonObject object;
    for (const HistoryField& field : historyFields())
        object.insert(QLatin1String(field.json), field.value(entry));
    return object;
}

QJsonObject toJson(const HistoryQuery& query)
{
    QJsonObject object;
    const auto add = [&object](const QString& name, const QString& text) {
        if (!text.isEmpty())
            object.insert(name, text);
    };
    add(u"text"_s, query.text);
    add(u"kind"_s, query.kind ? toString(*query.kind) : QString());
    add(u"outcome"_s, query.outcome ? toString(*query.outcome) : QString());
    add(u"type"_s, query.type);
    add(u"expected"_s, query.expected);
    add(u"operator"_s, query.operatorName);
    add(u"device"_s, query.device);
    add(u"batch"_s, query.batch);
    add(u"validity"_s, query.validity ? toString(*query.validity) : QString());
    add(u"from_utc"_s, query.from.isValid() ? utc(query.from) : QString());
    add(u"to_utc"_s, query.to.isValid() ? utc(query.to) : QString());
    return object;
}

HistoryDocument::HistoryDocument(HistoryQuery query, HistoryFormat format)
    : m_query(std::move(query)), m_format(format)
{
    if (format != HistoryFormat::Aqdef)
        return;
    m_query.order = HistoryColumn::Time; // a value chart goes as the file goes
    m_query.descending = false;
}

QByteArray HistoryDocument::head() const
{
    if (m_format == HistoryFormat::Csv)
        return historyCsvHeader();
    if (m_format == HistoryFormat::Aqdef)
        return m_catalogue.head(m_type ? &*m_type : nullptr);
    QByteArray text = compact({{u"format"_s, u"gripscope-history"_s},
                               {u"version"_s, 1},
                               {u"software"_s, QStringLiteral(GRIPSCOPE_VERSION)},
                               {u"exported_utc"_s, utc(QDateTime::currentDateTimeUtc())},
                               {u"filter"_s, toJson(m_query)},
                               {u"count"_s, qint64(total())}});
    text.chop(1); // the closing brace comes at the end
    return text + ",\"squeezes\":[\n";
}

QByteArray HistoryDocument::rows(const std::vector<HistoryEntry>& entries)
{
    if (m_format == HistoryFormat::Csv)
        return toCsv(entries);
    if (m_format == HistoryFormat::Aqdef)
        return m_catalogue.lines(entries);
    QByteArray text;
    for (const HistoryEntry& entry : entries) {
        text += m_first ? QByteArray() : QByteArray(",\n");
        text += compact(toJson(entry));
        m_first = false;
    }
    return text;
}

/// A step towards a list that is counted, since the head tells how many there are.
Expected<void> HistoryDocument::prepare(Library& library)
{
    if (!m_list) {
        ASSIGN_OR_RETURN(m_list, library.historyList(m_query));
        if (m_list->cut) {
            m_query.order = HistoryColumn::Time;
            m_query.descending = true;
            ASSIGN_OR_RETURN(m_list, library.historyList(m_query));
        }
    } else {
        ASSIGN_OR_RETURN(m_list, library.historyStretch(std::move(*m_list)));
    }
    return {};
}

/// A step through all of them for what the head says; m_gathered is below zero once that is through.
Expected<void> HistoryDocument::gather(Library& library)
{
    ASSIGN_OR_RETURN(const std::vector<HistoryEntry> entries,
                     library.historyPage(*m_list, m_gathered, rowsAtOnce));
    m_catalogue.add(entries);
    m_gathered += qint64(entries.size());
    if (m_gathered < m_list->rows && !entries.empty())
        return {};
    m_gathered = -1;
    ASSIGN_OR_RETURN(const std::vector<TypeRecord> types, library.types());
    const auto named = std::ranges::find_if(
        types, [this](const TypeRecord& type) { return m_catalogue.type() == type.name; });
    if (named != types.end())
        m_type = *named;
    return {};
}

Expected<QByteArray> HistoryDocument::next(Library& library)
{
    if (m_ended)
        return QByteArray();
    if (!m_list || !m_list->through) {
        RETURN_IF_ERROR(prepare(library));
        if (!m_list->through)
            return QByteArray();
    }
    if (m_format == HistoryFormat::Aqdef && m_gathered >= 0) {
        RETURN_IF_ERROR(gather(library));
        return QByteArray();
    }
    QByteArray text = m_begun ? QByteArray() : head();
    m_begun = true;
    ASSIGN_OR_RETURN(const std::vector<HistoryEntry> entries,
                     library.historyPage(*m_list, m_written, rowsAtOnce));
    text += rows(entries);
    m_written += qint64(entries.size());
    m_ended = m_written >= m_list->rows || entries.empty();
    if (m_ended && m_format == HistoryFormat::Json)
        text += "\n]}\n";
    return text;
}

} // namespace gripscope
