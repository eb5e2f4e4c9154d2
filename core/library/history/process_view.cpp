// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/history/process_view.h"

#include "core/base/vector_registers.h"
#include "core/base/words.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/type_state_table.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>

namespace gripscope::process_view {

using namespace Qt::StringLiterals;

namespace {

QString readingProcess()
{
    return Words::tr("read the inspections");
}

/// Rows of an index by their first column, a squeeze's key, for one key after another.
class KeyedRows {
public:
    explicit KeyedRows(RowCursor cursor) : m_cursor(std::move(cursor)), m_stepsAtMost(m_cursor.stepsALookUp())
    {
    }

    /// On the row of this key; false where there is none. Keys ascend.
    bool find(std::string_view key)
    {
        int order = m_onRow ? m_cursor.text(0).compare(key) : 0;
        for (int step = 0; m_onRow && order < 0; ++step) {
            if (step == m_stepsAtMost) {
                m_onRow = false;
                break;
            }
            m_onRow = m_cursor.next();
            if (!m_onRow)
                return false; // behind the last
            order = m_cursor.text(0).compare(key);
        }
        if (!m_onRow) {
            m_cursor.restart({key});
            m_onRow = m_cursor.next();
            order = m_onRow ? m_cursor.text(0).compare(key) : 0;
        }
        return m_onRow && order == 0;
    }
    [[nodiscard]] const RowCursor& row() const { return m_cursor; }

private:
    RowCursor m_cursor;
    int m_stepsAtMost;
    bool m_onRow = false;
};

/// Inspections in which a type was recognised under one of its names, by the squeezes' keys.
class NamedRows {
public:
    NamedRows(RowCursor cursor, std::vector<TypeNameSpan> spans)
        : m_cursor(std::move(cursor)), m_name(spans.front().name.toStdString())
    {
        for (const TypeNameSpan& span : spans)
            m_spans.emplace_back(span.from.toStdString(), span.until.toStdString());
        m_always = std::ranges::any_of(
            m_spans, [](const auto& span) { return span.first.empty() && span.second.empty(); });
    }
    void startAfter(std::string_view key)
    {
        m_cursor.restart({m_name, key});
        next();
    }
    void next() { m_onRow = m_cursor.next(); }
    [[nodiscard]] bool onRow() const { return m_onRow; }
    [[nodiscard]] std::string_view key() const { return m_cursor.text(0); }
    /// The name was this type's when the row was inspected.
    [[nodiscard]] bool counts() const
    {
        const auto holds = [at = m_cursor.text(2)](const auto& span) {
            return span.first <= at && (span.second.empty() || at < span.second);
        };
        return m_always || std::ranges::any_of(m_spans, holds);
    }
    [[nodiscard]] const RowCursor& row() const { return m_cursor; }

private:
    RowCursor m_cursor;
    std::string m_name;
    std::vector<std::pair<std::string, std::string>> m_spans;
    bool m_always = false, m_onRow = false;
};

/// The one with the smallest key; nothing behind the last rows.
NamedRows* firstByKey(std::vector<NamedRows>& names)
{
    NamedRows* first = nullptr;
    for (NamedRows& one : names)
        if (one.onRow() && (first == nullptr || one.key() < first->key()))
            first = &one;
    return first;
}

/// Texts as places in a list, the one before first: neighbours are often alike.
class NameColumn {
public:
    NameColumn(std::vector<std::uint32_t>& places, QStringList& names) : m_places(&places), m_names(&names)
    {
        for (qsizetype i = 0; i < names.size(); ++i)
            m_known.emplace(names[i].toStdString(), std::uint32_t(i));
    }
    void add(std::string_view name)
    {
        if (!m_any || name != m_last) {
            m_any = true;
            m_last = name;
            const auto known = m_known.try_emplace(m_last, std::uint32_t(m_names->size()));
            if (known.second)
                m_names->append(QString::fromUtf8(name.data(), qsizetype(name.size())));
            m_place = known.first->second;
        }
        m_places->push_back(m_place);
    }

private:
    std::vector<std::uint32_t>* m_places;
    QStringList* m_names;
    std::unordered_map<std::string, std::uint32_t> m_known;
    std::string m_last;
    std::uint32_t m_place = 0;
    bool m_any = false;
};

qint64 twoDigits(const char* text)
{
    return 10 * (text[0] - '0') + (text[1] - '0');
}

/// Of utcText(): "2024-05-31T12:00:00.000Z". Days since 1970 by Howard Hinnant's days_from_civil (Chrono-
/// compatible low-level date algorithms).
qint64 millisecondsOf(std::string_view text)
{
    constexpr std::string_view form = "0000-00-00T00:00:00.000Z";
    const bool known = text.size() == form.size() &&
                       std::equal(text.begin(), text.end(), form.begin(),
                                  [](char a, char b) { return b == '0' ? a >= '0' && a <= '9' : a == b; });
    if (!known)
        return QDateTime::fromString(QString::fromUtf8(text.data(), qsizetype(text.size())),
                                     Qt::ISODateWithMs)
            .toMSecsSinceEpoch();
    const char* const at = text.data();
    const qint64 month = twoDigits(at + 5), day = twoDigits(at + 8);
    const qint64 year = 100 * twoDigits(at) + twoDigits(at + 2) - (month <= 2 ? 1 : 0);
    const qint64 era = year / 400, ofEra = year - 400 * era;
    const qint64 ofYear = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
    const qint64 days = 146'097 * era + 365 * ofEra + ofEra / 4 - ofEra / 100 + ofYear - 719'468;
    const qint64 seconds =
        86'400 * days + 3600 * twoDigits(at + 11) + 60 * twoDigits(at + 14) + twoDigits(at + 17);
    return 1000 * seconds + 10 * twoDigits(at + 20) + (at[22] - '0');
}

Expected<qint64> numberOf(Database& database, const QString& sql)
{
    Statement query(database, readingProcess(), sql);
    return gripscope::numberOf(query);
}

Expected<std::shared_ptr<const std::vector<qint64>>> voidedNumbers(Database& database)
{
    auto numbers = std::make_shared<std::vector<qint64>>();
    Statement query(database, readingProcess(),
                    u"SELECT i.number FROM inspection_voids x CROSS JOIN inspections i "
                    "WHERE i.id = x.inspection_id"_s);
    RETURN_IF_ERROR(query.forEach([&](Statement& row) { numbers->push_back(row.takeInteger()); }));
    std::sort(numbers->begin(), numbers->end());
    return numbers;
}

/// The smallest text that this asks for; nothing where there is none.
Expected<std::optional<QString>> smallestText(Database& database, const QString& sql,
                                              const QStringList& texts)
{
    std::optional<QString> smallest;
    Statement query(database, readingProcess(), sql);
    for (const QString& text : texts)
        query.bind(text);
    RETURN_IF_ERROR(query.forEach([&](Statement& row) { smallest = row.takeText(); }));
    return smallest;
}

/// The units of all squeezes, "force position" each; told by an index, a look or two a pair. (One comparison
/// of both columns would go through every row of the first one's unit.)
Expected<QStringList> unitsOfSqueezes(Database& database)
{
    const QString nextForce =
        u"SELECT force_unit FROM grasps WHERE force_unit > ? ORDER BY force_unit LIMIT 1"_s;
    const QString nextPosition = u"SELECT position_unit FROM grasps WHERE force_unit = ? AND "
                                 "position_unit > ? ORDER BY position_unit LIMIT 1"_s;
    QStringList units;
    ASSIGN_OR_RETURN(
        auto force,
        smallestText(database, u"SELECT force_unit FROM grasps ORDER BY force_unit LIMIT 1"_s, {}));
    while (force) {
        ASSIGN_OR_RETURN(auto position, smallestText(database,
                                                     u"SELECT position_unit FROM grasps WHERE force_unit = ? "
                                                     "ORDER BY position_unit LIMIT 1"_s,
                                                     {*force}));
        while (position) {
            units << *force + u' ' + *position;
            ASSIGN_OR_RETURN(position, smallestText(database, nextPosition, {*force, *position}));
        }
        ASSIGN_OR_RETURN(force, smallestText(database, nextForce, {*force}));
    }
    return units;
}

struct Scale {
    QString units;
    double factor = 1;
    bool si = true;
};

Scale scaleOf(const QString& units)
{
    const qsizetype space = units.indexOf(u' ');
    const std::optional<double> factor = siFactor(units.left(space), units.mid(space + 1));
    return {units, factor.value_or(1), factor.has_value()};
}

/// The number of those that the units of a squeeze are compared by.
void noteScale(ProcessValues& values, ProcessPlace& place, const Scale& scale)
{
    const QString seen = scale.si ? u"SI"_s : scale.units;
    if (place.units.isEmpty())
        place.units = seen;
    values.unitsDiffer = values.unitsDiffer || place.units != seen;
    values.si = values.si && scale.si;
}

Expected<QStringList> batchName(Database& database, const QStringList& ids)
{
    QStringList names;
    for (const QString& id : ids) {
        QString name = id;
        Statement query(database, readingProcess(), u"SELECT name FROM batches WHERE id = ?"_s);
        query.bind(id);
        RETURN_IF_ERROR(query.forEach([&](Statement& row) { name = row.takeText(); }));
        names << name;
    }
    return names;
}

/// One stretch under way.
class StretchReading {
public:
    StretchReading(const ProcessQuery& query, ProcessPlace place, ProcessValues& values)
        : m_query(query), m_place(std::move(place)), m_values(values), m_gripper(query.gripper.toStdString()),
          m_stations(m_stationPlaces, values.stationNames),
          m_operators(m_operatorPlaces, values.operatorNames), m_batches(m_batchPlaces, m_batchIds)
    {
    }

    Expected<ProcessPlace> read(Database& database)
    {
        RETURN_IF_ERROR(prepare(database));
        if (m_place.through)
            return m_place;
        ASSIGN_OR_RETURN(std::vector<NamedRows> names, openNames(database));
        ASSIGN_OR_RETURN(RowCursor estimateRows,
                         RowCursor::open(database, readingProcess(),
                                         u"SELECT grasp_id, m, b, k FROM estimates WHERE rank = 0 AND "
                                         "grasp_id >= ? ORDER BY grasp_id"_s));
        ASSIGN_OR_RETURN(
            RowCursor graspRows,
            RowCursor::open(database, readingProcess(),
                            u"SELECT id, force_unit || ' ' || position_unit, TRIM(device_name || ' ' || "
                            "device_serial) FROM grasps WHERE id >= ? ORDER BY id"_s));
        KeyedRows estimates(std::move(estimateRows)), grasps(std::move(graspRows));
        std::string key = m_place.key.toStdString();
        for (NamedRows& name : names)
            name.startAfter(key);
        int rows = 0;
        releaseVectorRegisters();
        for (NamedRows* next = firstByKey(names); next != nullptr && rows < stretch;
             next = firstByKey(names)) {
            ++rows;
            key = next->key();
            const qint64 number = next->row().integer(1);
            m_place.last = std::max(m_place.last, number);
            if (next->counts())
                take(next->row(), number, key, estimates, grasps);
            next->next();
        }
        std::vector<const RowCursor*> cursors{&estimates.row(), &grasps.row()};
        for (const NamedRows& name : names)
            cursors.push_back(&name.row());
        for (const RowCursor* cursor : cursors)
            if (cursor->error())
                return tl::unexpected(*cursor->error());
        m_place.key = QString::fromStdString(key);
        m_place.through = rows < stretch;
        RETURN_IF_ERROR(nameBatches(database));
        handOver();
        return m_place;
    }

private:
    Expected<std::vector<NamedRows>> openNames(Database& database)
    {
        std::vector<NamedRows> names;
        std::vector<TypeNameSpan> left = *m_place.names;
        while (!left.empty()) {
            const auto others = std::stable_partition(
                left.begin(), left.end(),
                [name = left.front().name](const TypeNameSpan& span) { return span.name == name; });
            ASSIGN_OR_RETURN(RowCursor rows,
                             RowCursor::open(database, readingProcess(),
                                             u"SELECT grasp_id, number, inspected_utc, station, "
                                             "operator_name, batch_id FROM inspections WHERE type_name = ? "
                                             "AND verdict = 'type' AND grasp_id > ? ORDER BY grasp_id"_s));
            names.emplace_back(std::move(rows), std::vector<TypeNameSpan>(left.begin(), others));
            left.erase(left.begin(), others);
        }
        return names;
    }
    Expected<void> prepare(Database& database)
    {
        if (m_place.newest == 0) {
            ASSIGN_OR_RETURN(m_place.newest,
                             numberOf(database, u"SELECT COALESCE(MAX(number), 0) FROM inspections"_s));
            ASSIGN_OR_RETURN(m_place.voided, voidedNumbers(database));
            m_values.voided = m_place.voided;
            ASSIGN_OR_RETURN(auto names, type_state_table::nameSpans(database, m_query.type));
            m_place.names = std::make_shared<const std::vector<TypeNameSpan>>(std::move(names));
        }
        m_after = m_query.after;
        if (m_query.newest > 0)
            m_after = std::max(m_after, m_place.newest - m_query.newest);
        if (m_after > 0 && m_place.key.isEmpty())
            RETURN_IF_ERROR(startAfter(database));
        ASSIGN_OR_RETURN(const QStringList units, unitsOfSqueezes(database));
        m_readsGrasps = units.size() != 1 || !m_gripper.empty();
        m_scale = scaleOf(units.value(0));
        if (!m_readsGrasps)
            noteScale(m_values, m_place, m_scale);
        return {};
    }
    /// Keys and numbers ascend together but for squeezes of several stations, or stored late: a little
    /// before.
    Expected<void> startAfter(Database& database)
    {
        constexpr qint64 lateAtMost = 1000;
        Statement query(database, readingProcess(),
                        u"SELECT MIN(grasp_id) FROM (SELECT grasp_id FROM inspections WHERE number > ? "
                        "ORDER BY number LIMIT %1) AS late"_s.arg(lateAtMost));
        query.bind(m_after);
        QString first;
        RETURN_IF_ERROR(query.forEach([&](Statement& row) { first = row.takeText(); }));
        m_place.through = first.isEmpty();
        m_place.key = first.chopped(1); // its last sign less: before it
        return {};
    }
    void take(const RowCursor& inspection, qint64 number, std::string_view key, KeyedRows& estimates,
              KeyedRows& grasps)
    {
        if (number <= m_after || std::binary_search(m_place.voided->begin(), m_place.voided->end(), number))
            return;
        if (m_readsGrasps) {
            if (!grasps.find(key) || (!m_gripper.empty() && grasps.row().text(2) != m_gripper))
                return;
            if (grasps.row().text(1) != m_units) {
                m_units = grasps.row().text(1);
                m_scale = scaleOf(QString::fromStdString(m_units));
                noteScale(m_values, m_place, m_scale);
            }
        }
        const bool measured = estimates.find(key);
        for (int i = 0; i < 3; ++i)
            m_quantities[std::size_t(i)].push_back(measured ? m_scale.factor * estimates.row().real(i + 1)
                                                            : std::numeric_limits<double>::quiet_NaN());
        m_numbers.push_back(number);
        m_times_ms.push_back(millisecondsOf(inspection.text(2)));
        m_stations.add(inspection.text(3));
        m_operators.add(inspection.text(4));
        m_batches.add(inspection.text(5));
    }
    /// Batches are told apart by their keys, and named alike where their names are.
    Expected<void> nameBatches(Database& database)
    {
        if (m_values.batchNames.isEmpty())
            m_values.batchNames << QString();
        ASSIGN_OR_RETURN(const QStringList names, batchName(database, m_batchIds));
        std::vector<std::uint32_t> places;
        for (qsizetype i = 0; i < names.size(); ++i) {
            const QString name = m_batchIds[i].isEmpty() ? QString() : names[i];
            if (!m_values.batchNames.contains(name))
                m_values.batchNames << name;
            places.push_back(std::uint32_t(m_values.batchNames.indexOf(name)));
        }
        for (std::uint32_t& place : m_batchPlaces)
            place = places[place];
        return {};
    }
    void handOver()
    {
        for (const qint64 number : m_numbers)
            m_values.newest = std::max(m_values.newest, number);
        m_values.numbers.append(m_numbers);
        m_values.times_ms.append(m_times_ms);
        for (std::size_t i = 0; i < m_quantities.size(); ++i)
            m_values.quantities[i].append(m_quantities[i]);
        m_values.stations.append(m_stationPlaces);
        m_values.operators.append(m_operatorPlaces);
        m_values.batches.append(m_batchPlaces);
    }

    const ProcessQuery& m_query;
    ProcessPlace m_place;
    ProcessValues& m_values;
    std::string m_gripper, m_units;
    std::vector<qint64> m_numbers, m_times_ms;
    std::array<std::vector<double>, 3> m_quantities;
    std::vector<std::uint32_t> m_stationPlaces, m_operatorPlaces, m_batchPlaces;
    QStringList m_batchIds;
    NameColumn m_stations, m_operators, m_batches;
    bool m_readsGrasps = false;
    qint64 m_after = 0;
    Scale m_scale;
};

} // namespace

Expected<ProcessPlace> read(Database& database, const ProcessQuery& query, ProcessPlace place,
                            ProcessValues& values)
{
    ASSIGN_OR_RETURN(const auto oneState, ReadTransaction::begin(database, readingProcess()));
    return StretchReading(query, std::move(place), values).read(database);
}

Expected<QString> squeezeKey(Database& database, qint64 number)
{
    QString key;
    Statement query(database, readingProcess(),
                    QStringLiteral("SELECT grasp_id FROM inspections WHERE number = ?"));
    query.bind(number);
    RETURN_IF_ERROR(query.forEach([&](Statement& row) { key = row.takeText(); }));
    if (key.isEmpty())
        return failure(ErrorCode::NotFound, {Words::tr("inspection %1").arg(number)});
    return key;
}

} // namespace gripscope::process_view
