// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/plant/plant_history.h"
#include "core/library/plant/plant_state.h"
#include "tests/support/test_registry.h"

#include <QJsonDocument>
#include <QTest>

#include <algorithm>
#include <random>
#include <set>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// A library that changes as the program changes one: each change holds the whole state as it then is.
class SimulatedStation {
public:
    SimulatedStation(QString name, QString person) : m_name(std::move(name)), m_person(std::move(person)) {}

    [[nodiscard]] const PlantHistory& history() const { return m_history; }
    [[nodiscard]] PlantState state() const { return plantState(m_history); }

    QString enrol(const QString& name)
    {
        PlantType type;
        type.typeId = u"type %1 %2"_s.arg(m_name).arg(m_version + 1);
        type.name = name;
        type.recipe = type.typeId + u" recipe"_s;
        change(ChangeKind::NewType, type);
        return type.typeId;
    }
    void change(ChangeKind kind, const PlantType& now)
    {
        const ChangeStamp stamp = nextStamp();
        m_history.types.push_back(
            {stamp, kind, now.typeId, now.name, now.status, now.recipe, now.code, now.limits});
    }
    QString squeeze(const PlantType& type)
    {
        const QString id = u"squeeze %1 %2"_s.arg(m_name).arg(m_version + 1);
        place(ChangeKind::Squeeze, type, id, type.typeId, true);
        return id;
    }
    /// What approved it had not seen this.
    void place(ChangeKind kind, PlantType type, const QString& squeeze, const QString& typeId, bool accepted)
    {
        const ChangeStamp stamp = nextStamp();
        m_history.squeezes.push_back({stamp, kind, squeeze, typeId, accepted});
        if (type.status != TypeStatus::Approved)
            return;
        ChangeStamp voided = stamp;
        voided.row += u" void"_s;
        type.status = TypeStatus::Enrolled;
        m_history.types.push_back(
            {voided, kind, type.typeId, type.name, type.status, type.recipe, type.code, type.limits});
    }
    void mergeTypes(PlantType from, const QString& into)
    {
        const PlantState before = state();
        ChangeStamp stamp = nextStamp();
        from.status = TypeStatus::Gone;
        m_history.types.push_back({stamp, ChangeKind::Merge, from.typeId, from.name, from.status, from.recipe,
                                   from.code, from.limits});
        PlantType target = before.types.at(into);
        if (target.status == TypeStatus::Approved)
            target.status = TypeStatus::Enrolled;
        stamp.row += u" into"_s;
        m_history.types.push_back({stamp, ChangeKind::Merge, into, target.name, target.status, target.recipe,
                                   target.code, target.limits});
        for (const auto& [squeeze, place] : before.squeezes)
            if (place.typeId == from.typeId && place.accepted) {
                stamp.row += u'.';
                m_history.squeezes.push_back({stamp, ChangeKind::Merge, squeeze, into, true});
            }
    }
    void remember() { m_remembered = state(); }
    /// As restoring a version does.
    void restore()
    {
        ChangeStamp stamp = nextStamp();
        const PlantState now = state();
        for (const auto& [id, type] : now.types) {
            const auto old = m_remembered.types.find(id);
            PlantType wanted = old == m_remembered.types.end() ? type : old->second;
            if (old == m_remembered.types.end())
                wanted.status = TypeStatus::Gone;
            if (wanted == type)
                continue;
            stamp.row += u'.';
            m_history.types.push_back({stamp, ChangeKind::Restore, id, wanted.name, wanted.status,
                                       wanted.recipe, wanted.code, wanted.limits});
        }
        for (const auto& [id, place] : now.squeezes) {
            const auto old = m_remembered.squeezes.find(id);
            const SqueezePlace wanted =
                old == m_remembered.squeezes.end() ? SqueezePlace{place.typeId, false} : old->second;
            if (wanted == place)
                continue;
            stamp.row += u'.';
            m_history.squeezes.push_back({stamp, ChangeKind::Restore, id, wanted.typeId, wanted.accepted});
        }
    }

    /// True where there was something that this station did not have.
    bool meet(const SimulatedStation& other)
    {
        const std::size_t before = m_history.types.size() + m_history.squeezes.size();
        take(m_history.types, other.m_history.types, [](const TypeChange& one) { return one.stamp.row; });
        take(m_history.squeezes, other.m_history.squeezes,
             [](const SqueezeChange& one) { return one.stamp.row; });
        take(m_history.meetings, other.m_history.meetings,
             [](const PlantMeeting& one) { return u"%1 %2"_s.arg(one.library).arg(one.version); });
        if (m_history.types.size() + m_history.squeezes.size() == before)
            return false;
        std::map<QString, qint64> seen;
        const auto note = [&](const ChangeStamp& stamp) {
            m_version = std::max(m_version, stamp.version);
            seen[stamp.library] = std::max(seen[stamp.library], stamp.version);
        };
        for (const TypeChange& one : m_history.types)
            note(one.stamp);
        for (const SqueezeChange& one : m_history.squeezes)
            note(one.stamp);
        m_history.meetings.push_back({m_name, ++m_version, seen});
        return true;
    }

private:
    ChangeStamp nextStamp()
    {
        ++m_version;
        // Clocks are not told from each other: the order must not rest on them.
        return {
            m_name,  m_version, u"2026-01-01T00:00:00.000Z"_s, m_name, u"%1 %2"_s.arg(m_name).arg(m_version),
            m_person};
    }
    template <typename Row, typename Key>
    static void take(std::vector<Row>& rows, const std::vector<Row>& others, const Key& key)
    {
        std::set<QString> there;
        for (const Row& row : rows)
            there.insert(key(row));
        for (const Row& row : others)
            if (there.insert(key(row)).second)
                rows.push_back(row);
    }

    QString m_name, m_person;
    qint64 m_version = 0;
    PlantHistory m_history;
    PlantState m_remembered;
};

class Chance {
public:
    explicit Chance(unsigned seed) : m_engine(seed) {}
    int below(int end) { return end < 1 ? 0 : int(m_engine() % unsigned(end)); }
    template <typename Values>
    auto& oneOf(Values& values)
    {
        return *std::next(values.begin(), below(int(values.size())));
    }
    std::mt19937& engine() { return m_engine; }

private:
    std::mt19937 m_engine;
};

void doSomething(SimulatedStation& station, Chance& chance)
{
    const PlantState state = station.state();
    std::vector<PlantType> types;
    for (const auto& [id, type] : state.types)
        if (type.status != TypeStatus::Gone)
            types.push_back(type);
    const QString word = u"name %1"_s.arg(chance.below(6)); // few, so that they are claimed twice
    const auto isTaken = [&](const QString& name) {
        return std::any_of(types.begin(), types.end(),
                           [&](const PlantType& type) { return type.name == name; });
    };
    if (types.empty() || chance.below(8) == 0) {
        if (!isTaken(word))
            station.enrol(word);
        return;
    }
    PlantType type = chance.oneOf(types);
    const auto changed = [&](ChangeKind kind) { station.change(kind, type); };
    switch (chance.below(11)) {
    case 0:
        if (!isTaken(word)) {
            type.name = word;
            changed(ChangeKind::Rename);
        }
        break;
    case 1:
    case 2:
        type.status = TypeStatus::Approved;
        changed(ChangeKind::Approve);
        break;
    case 3:
        type.status = TypeStatus::Retired;
        changed(ChangeKind::Retire);
        break;
    case 4:
        type.recipe += u'\'';
        changed(ChangeKind::Recipe);
        break;
    case 5:
        type.limits = u"k=%1:20"_s.arg(chance.below(3));
        changed(ChangeKind::Limits);
        break;
    case 6: {
        const QString code = u"code %1"_s.arg(chance.below(4));
        if (std::none_of(types.begin(), types.end(),
                         [&](const PlantType& one) { return one.code == code; })) {
            type.code = code;
            changed(ChangeKind::Code);
        }
        break;
    }
    case 7: {
        if (state.squeezes.empty())
            break;
        const auto& [squeeze, place] = chance.oneOf(state.squeezes);
        station.place(place.accepted ? ChangeKind::Drop : ChangeKind::Undrop, state.types.at(place.typeId),
                      squeeze, place.typeId, !place.accepted);
        break;
    }
    case 8: {
        const PlantType& into = chance.oneOf(types);
        if (into.typeId != type.typeId)
            station.mergeTypes(type, into.typeId);
        break;
    }
    case 9:
        if (chance.below(2) == 0)
            station.remember();
        else
            station.restore();
        break;
    default:
        static_cast<void>(station.squeeze(type));
        break;
    }
}

QByteArray textOf(const PlantState& state)
{
    return QJsonDocument(canonicalJson(state)).toJson(QJsonDocument::Compact);
}

std::set<QString> rowsOf(const PlantHistory& history)
{
    std::set<QString> rows;
    for (const TypeChange& change : history.types)
        rows.insert(change.stamp.row);
    for (const SqueezeChange& change : history.squeezes)
        rows.insert(change.stamp.row);
    return rows;
}

const PlantConflict* conflictOf(const PlantState& state, PlantConflict::Kind kind)
{
    const auto found = std::find_if(state.conflicts.begin(), state.conflicts.end(),
                                    [kind](const PlantConflict& one) { return one.kind == kind; });
    return found == state.conflicts.end() ? nullptr : &*found;
}

/// Two stations that both know one approved type, "Cola".
struct TwoStations {
    SimulatedStation one{u"hall-1"_s, u"Ada"_s}, other{u"hall-2"_s, u"Ben"_s};
    QString cola;
    TwoStations()
    {
        cola = one.enrol(u"Cola"_s);
        static_cast<void>(one.squeeze(type(one)));
        changed(one, ChangeKind::Approve, [](PlantType& type) { type.status = TypeStatus::Approved; });
        other.meet(one);
    }
    [[nodiscard]] PlantType type(const SimulatedStation& station) const
    {
        return station.state().types.at(cola);
    }
    template <typename Change>
    void changed(SimulatedStation& station, ChangeKind kind, const Change& change) const
    {
        PlantType now = type(station);
        change(now);
        station.change(kind, now);
    }
    PlantState meet()
    {
        one.meet(other);
        other.meet(one);
        if (textOf(one.state()) != textOf(other.state()))
            qFatal("the stations do not agree");
        return one.state();
    }
};

} // namespace

class PlantStateTest : public QObject {
    Q_OBJECT
private slots:
    void anyOrderOfMeetingEndsInTheSameState_data()
    {
        QTest::addColumn<unsigned>("first");
        for (unsigned first = 1; first <= 200; first += 50)
            QTest::addRow("from %u", first) << first;
    }
    /// 200 histories: two to four stations change the same types, meet now and then, and in the end until all
    /// have met, in an order that chance gives.
    void anyOrderOfMeetingEndsInTheSameState()
    {
        QFETCH(unsigned, first);
        for (unsigned seed = first; seed < first + 50; ++seed) {
            Chance chance(seed);
            std::vector<SimulatedStation> stations;
            for (int i = 0; i < 2 + chance.below(3); ++i)
                stations.emplace_back(u"hall-%1"_s.arg(i), u"person %1"_s.arg(i));
            for (int step = 0; step < 40; ++step) {
                SimulatedStation& station = chance.oneOf(stations);
                if (chance.below(10) == 0)
                    station.meet(chance.oneOf(stations));
                else
                    doSomething(station, chance);
            }
            std::set<QString> all;
            for (const SimulatedStation& station : stations)
                all.merge(rowsOf(station.history()));
            // As many random meetings as make it certain in practice, then each with each.
            for (int i = 0; i < 20; ++i)
                chance.oneOf(stations).meet(chance.oneOf(stations));
            for (int round = 0; round < 2; ++round)
                for (SimulatedStation& one : stations)
                    for (const SimulatedStation& other : stations)
                        one.meet(other);
            const PlantState state = stations.front().state();
            for (SimulatedStation& station : stations) {
                QCOMPARE(rowsOf(station.history()), all); // each history is kept
                QCOMPARE(textOf(station.state()), textOf(state));
                QCOMPARE(station.state().conflicts, state.conflicts);
                PlantHistory shuffled = station.history();
                std::shuffle(shuffled.types.begin(), shuffled.types.end(), chance.engine());
                std::shuffle(shuffled.squeezes.begin(), shuffled.squeezes.end(), chance.engine());
                std::shuffle(shuffled.meetings.begin(), shuffled.meetings.end(), chance.engine());
                QCOMPARE(textOf(plantState(shuffled)), textOf(state));
                for (const SimulatedStation& other : stations)
                    QVERIFY(!station.meet(other)); // nothing is new any more
            }
            std::set<QString> names, codes;
            for (const auto& [id, type] : state.types) {
                if (type.status == TypeStatus::Gone)
                    continue;
                QVERIFY2(names.insert(type.name).second, qPrintable(type.name));
                QVERIFY(type.code.isEmpty() || codes.insert(type.code).second);
            }
        }
    }
    void theLaterNameIsInForceAndBothAreTold()
    {
        TwoStations plant;
        plant.changed(plant.one, ChangeKind::Rename, [](PlantType& type) { type.name = u"Cola small"_s; });
        static_cast<void>(plant.other.enrol(u"Fizz"_s)); // later by one more change
        plant.changed(plant.other, ChangeKind::Rename, [](PlantType& type) { type.name = u"Cola 330"_s; });
        const PlantState state = plant.meet();
        QCOMPARE(state.types.at(plant.cola).name, u"Cola 330"_s);
        QCOMPARE(state.conflicts.size(), std::size_t(1));
        const PlantConflict& conflict = state.conflicts.front();
        QVERIFY(conflict.kind == PlantConflict::Kind::Name);
        QCOMPARE(conflict.inForce.value, u"Cola 330"_s);
        QCOMPARE(conflict.onRecord.front().value, u"Cola small"_s);
        const QString words = inWords(conflict);
        for (const QString& word : {u"'Cola 330' by Ben on hall-2"_s, u"'Cola small' by Ada on hall-1"_s})
            QVERIFY2(words.contains(word), qPrintable(words));
    }
    void whoDecidesAfterwardsEndsTheConflict()
    {
        TwoStations plant;
        plant.changed(plant.one, ChangeKind::Rename, [](PlantType& type) { type.name = u"Cola small"_s; });
        plant.changed(plant.other, ChangeKind::Rename, [](PlantType& type) { type.name = u"Cola 330"_s; });
        QCOMPARE(plant.meet().conflicts.size(), std::size_t(1));
        plant.changed(plant.one, ChangeKind::Rename, [](PlantType& type) { type.name = u"Cola can"_s; });
        const PlantState state = plant.meet();
        QVERIFY(state.conflicts.empty());
        QCOMPARE(state.types.at(plant.cola).name, u"Cola can"_s);
    }
    void changesOfDifferentFactsDoNotConflict()
    {
        TwoStations plant;
        plant.changed(plant.one, ChangeKind::Rename, [](PlantType& type) { type.name = u"Cola small"_s; });
        plant.changed(plant.other, ChangeKind::Code, [](PlantType& type) { type.code = u"4711"_s; });
        const PlantState state = plant.meet();
        QVERIFY(state.conflicts.empty());
        QCOMPARE(state.types.at(plant.cola).name, u"Cola small"_s);
        QCOMPARE(state.types.at(plant.cola).code, u"4711"_s);
        QVERIFY(state.types.at(plant.cola).status == TypeStatus::Approved);
    }
    void twoTypesOfOneNameStayTwo()
    {
        TwoStations plant;
        const QString early = plant.one.enrol(u"Fizz"_s);
        static_cast<void>(plant.other.squeeze(plant.type(plant.other)));
        const QString late = plant.other.enrol(u"Fizz"_s);
        const PlantState state = plant.meet();
        QCOMPARE(state.types.at(early).name, u"Fizz"_s);
        QCOMPARE(state.types.at(late).name, u"Fizz (hall-2)"_s);
        const PlantConflict* conflict = conflictOf(state, PlantConflict::Kind::SameName);
        QVERIFY(conflict);
        QVERIFY(inWords(*conflict).contains(u"'Fizz (hall-2)'"_s));
    }
    void anApprovalIsOnlyOfWhatItHadSeen()
    {
        TwoStations plant;
        static_cast<void>(plant.one.squeeze(plant.type(plant.one))); // its approval is void there
        static_cast<void>(plant.other.squeeze(plant.type(plant.other)));
        plant.changed(plant.other, ChangeKind::Approve,
                      [](PlantType& type) { type.status = TypeStatus::Approved; });
        const PlantState state = plant.meet();
        QVERIFY(state.types.at(plant.cola).status == TypeStatus::Enrolled);
        QVERIFY(conflictOf(state, PlantConflict::Kind::Approval));
        plant.changed(plant.one, ChangeKind::Approve,
                      [](PlantType& type) { type.status = TypeStatus::Approved; });
        QVERIFY(plant.meet().types.at(plant.cola).status == TypeStatus::Approved);
    }
    void retiredHereAndApprovedThereGoesByTheOrder()
    {
        TwoStations plant;
        plant.changed(plant.one, ChangeKind::Approve,
                      [](PlantType& type) { type.status = TypeStatus::Approved; });
        static_cast<void>(plant.other.enrol(u"Fizz"_s));
        plant.changed(plant.other, ChangeKind::Retire,
                      [](PlantType& type) { type.status = TypeStatus::Retired; });
        const PlantState state = plant.meet();
        QVERIFY(state.types.at(plant.cola).status == TypeStatus::Retired);
        QVERIFY(conflictOf(state, PlantConflict::Kind::Status));
    }
    /// Each station merges one of two types into the other: no squeeze may be lost with both.
    void typesThatWereMergedIntoEachOtherAreNotLost()
    {
        TwoStations plant;
        const QString fizz = plant.one.enrol(u"Fizz"_s);
        static_cast<void>(plant.one.squeeze(plant.one.state().types.at(fizz)));
        plant.other.meet(plant.one);
        plant.one.mergeTypes(plant.type(plant.one), fizz);
        plant.other.mergeTypes(plant.other.state().types.at(fizz), plant.cola);
        const PlantState state = plant.meet();
        for (const auto& [squeeze, place] : state.squeezes)
            QVERIFY(state.types.at(place.typeId).status != TypeStatus::Gone);
        QVERIFY(conflictOf(state, PlantConflict::Kind::GivenUp));
    }
    void oneCodeIsOfOneType()
    {
        TwoStations plant;
        const QString fizz = plant.other.enrol(u"Fizz"_s);
        plant.changed(plant.one, ChangeKind::Code, [](PlantType& type) { type.code = u"4711"_s; });
        PlantType type = plant.other.state().types.at(fizz);
        type.code = u"4711"_s;
        plant.other.change(ChangeKind::Code, type);
        const PlantState state = plant.meet();
        QCOMPARE(state.types.at(plant.cola).code, u"4711"_s);
        QCOMPARE(state.types.at(fizz).code, QString());
        QVERIFY(conflictOf(state, PlantConflict::Kind::SameCode));
    }
};

GRIPSCOPE_TEST(PlantStateTest)
#include "plant_state_test.moc"
