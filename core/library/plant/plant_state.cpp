// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/plant/plant_state.h"

#include <QJsonArray>

#include <algorithm>
#include <array>
#include <tuple>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Kind = PlantConflict::Kind;
using Side = PlantConflict::Side;

constexpr std::array facts{Kind::Name, Kind::Status, Kind::Recipe, Kind::Code, Kind::Limits};

QString valueOf(const TypeChange& change, Kind fact)
{
    switch (fact) {
    case Kind::Name:
        return change.name;
    case Kind::Status:
        return toString(change.status);
    case Kind::Recipe:
        return change.recipe;
    case Kind::Code:
        return change.code;
    default:
        return change.limits;
    }
}

/// What a change of squeezes or limits says of the status: that the approval is void, or the type given up.
bool voids(const TypeChange& change)
{
    return change.status == TypeStatus::Enrolled || change.status == TypeStatus::Gone;
}

/// Whether the change was about this fact. The row holds all facts as they were then.
bool isAbout(const TypeChange& change, Kind fact)
{
    switch (change.kind) {
    case ChangeKind::Rename:
        return fact == Kind::Name;
    case ChangeKind::Approve:
    case ChangeKind::Retire:
    case ChangeKind::Reinstate:
        return fact == Kind::Status;
    case ChangeKind::Recipe:
        return fact == Kind::Recipe;
    case ChangeKind::Code:
        return fact == Kind::Code;
    case ChangeKind::Limits:
        return fact == Kind::Limits || (fact == Kind::Status && voids(change));
    case ChangeKind::Squeeze:
    case ChangeKind::Drop:
    case ChangeKind::Undrop:
    case ChangeKind::Merge:
    case ChangeKind::Split:
        return fact == Kind::Status && voids(change);
    default:
        return true;
    }
}

struct TypeHistory {
    std::vector<const TypeChange*> changes;     ///< in order
    std::map<Kind, const TypeChange*> inForce;  ///< of each fact
    std::vector<const SqueezeChange*> squeezes; ///< that came or went
};

class StateMaker {
public:
    explicit StateMaker(const PlantHistory& history) : m_causality(history.meetings)
    {
        for (const TypeChange& change : history.types)
            m_types[change.typeId].changes.push_back(&change);
        for (const SqueezeChange& change : history.squeezes) {
            m_squeezes[change.squeeze].push_back(&change);
            m_types[change.typeId].squeezes.push_back(&change);
        }
    }

    PlantState make()
    {
        for (auto& [squeeze, changes] : m_squeezes)
            place(squeeze, changes);
        for (auto& [typeId, type] : m_types)
            if (!type.changes.empty())
                settle(typeId, type);
        keepSqueezes();
        shareOut(Kind::Name, Kind::SameName);
        shareOut(Kind::Code, Kind::SameCode);
        for (const auto& [typeId, type] : m_types)
            if (!type.changes.empty())
                tellDecisionsApart(typeId, type);
        for (PlantConflict& conflict : m_state.conflicts)
            conflict.type = m_state.types.at(conflict.typeId).name;
        std::sort(m_state.conflicts.begin(), m_state.conflicts.end(),
                  [](const PlantConflict& one, const PlantConflict& other) {
                      return std::tuple(one.kind, one.id()) < std::tuple(other.kind, other.id());
                  });
        return std::move(m_state);
    }

private:
    template <typename Change>
    static void putInOrder(std::vector<const Change*>& changes)
    {
        std::sort(changes.begin(), changes.end(), [](const Change* one, const Change* other) {
            return comesBefore(one->stamp, other->stamp);
        });
    }

    /// A drop says nothing of the type, and a move nothing of whether it counts.
    void place(const QString& squeeze, std::vector<const SqueezeChange*>& changes)
    {
        putInOrder(changes);
        SqueezePlace& found = m_state.squeezes[squeeze];
        found = {changes.front()->typeId, changes.front()->accepted};
        for (const SqueezeChange* change : changes) {
            const bool isOfCounting = change->kind == ChangeKind::Drop || change->kind == ChangeKind::Undrop;
            const bool isMove = change->kind == ChangeKind::Merge || change->kind == ChangeKind::Split;
            if (!isOfCounting)
                found.typeId = change->typeId;
            if (!isMove)
                found.accepted = change->accepted;
        }
    }

    /// The first change of a type brought all of it.
    static bool isOf(const TypeHistory& type, const TypeChange& change, Kind fact)
    {
        return &change == type.changes.front() || isAbout(change, fact);
    }

    void settle(const QString& typeId, TypeHistory& type)
    {
        putInOrder(type.changes);
        PlantType& state = m_state.types[typeId];
        state.typeId = typeId;
        for (const TypeChange* change : type.changes)
            for (const Kind fact : facts)
                if (isOf(type, *change, fact))
                    type.inForce[fact] = change;
        state.name = type.inForce.at(Kind::Name)->name;
        state.status = type.inForce.at(Kind::Status)->status;
        state.recipe = type.inForce.at(Kind::Recipe)->recipe;
        state.code = type.inForce.at(Kind::Code)->code;
        state.limits = type.inForce.at(Kind::Limits)->limits;
        if (state.status == TypeStatus::Approved)
            holdApproval(typeId, type);
    }

    /// Nobody has approved what nobody who approved has seen.
    void holdApproval(const QString& typeId, const TypeHistory& type)
    {
        const TypeChange& approval = *type.inForce.at(Kind::Status);
        const ChangeStamp* unseen = nullptr;
        const auto look = [&](const ChangeStamp& stamp) {
            if (m_causality.wereApart(stamp, approval.stamp) &&
                (unseen == nullptr || comesBefore(*unseen, stamp)))
                unseen = &stamp;
        };
        for (const SqueezeChange* change : type.squeezes)
            look(change->stamp);
        for (const TypeChange* change : type.changes)
            if (change->kind == ChangeKind::Limits && voids(*change))
                look(change->stamp);
        if (unseen == nullptr)
            return;
        m_state.types.at(typeId).status = TypeStatus::Enrolled;
        m_state.conflicts.push_back({Kind::Approval,
                                     typeId,
                                     {},
                                     {*unseen, toString(TypeStatus::Enrolled)},
                                     {{approval.stamp, toString(TypeStatus::Approved)}}});
    }

    /// A type that is gone while squeezes of it count would hide them.
    void keepSqueezes()
    {
        for (const auto& [squeeze, place] : m_state.squeezes) {
            const auto type = m_state.types.find(place.typeId);
            if (!place.accepted || type == m_state.types.end() || type->second.status != TypeStatus::Gone)
                continue;
            type->second.status = TypeStatus::Retired;
            const TypeChange& givenUp = *m_types.at(place.typeId).inForce.at(Kind::Status);
            m_state.conflicts.push_back({Kind::GivenUp,
                                         place.typeId,
                                         {},
                                         {m_squeezes.at(squeeze).back()->stamp, squeeze},
                                         {{givenUp.stamp, toString(TypeStatus::Gone)}}});
        }
    }

    /// What only one type can have goes to the one that claimed it first.
    void shareOut(Kind fact, Kind told)
    {
        std::vector<const TypeChange*> claims;
        for (const auto& [typeId, type] : m_types) {
            const auto state = m_state.types.find(typeId);
            if (state == m_state.types.end() || state->second.status == TypeStatus::Gone)
                continue;
            const TypeChange* claim = type.inForce.at(fact);
            if (!valueOf(*claim, fact).isEmpty())
                claims.push_back(claim);
        }
        putInOrder(claims);
        std::map<QString, const TypeChange*> owners;
        std::vector<const TypeChange*> late;
        for (const TypeChange* claim : claims)
            if (!owners.emplace(valueOf(*claim, fact), claim).second)
                late.push_back(claim);
        for (const TypeChange* claim : late) {
            const TypeChange* owner = owners.at(valueOf(*claim, fact));
            m_state.conflicts.push_back({told,
                                         claim->typeId,
                                         {},
                                         {owner->stamp, valueOf(*owner, fact)},
                                         {{claim->stamp, valueOf(*claim, fact)}}});
            if (fact == Kind::Code) {
                m_state.types.at(claim->typeId).code.clear();
                continue;
            }
            const QString name = freeName(*claim, owners);
            owners.emplace(name, claim);
            m_state.types.at(claim->typeId).name = name;
        }
    }

    static QString freeName(const TypeChange& claim, const std::map<QString, const TypeChange*>& owners)
    {
        QString name = u"%1 (%2)"_s.arg(claim.name, claim.stamp.station);
        for (int number = 2; owners.contains(name); ++number)
            name = u"%1 (%2, %3)"_s.arg(claim.name, claim.stamp.station, QString::number(number));
        return name;
    }

    /// The changes of a fact that nobody who changed it later had seen: one, unless stations were apart.
    void tellDecisionsApart(const QString& typeId, const TypeHistory& type)
    {
        for (const Kind fact : facts) {
            const TypeChange* last = type.inForce.at(fact);
            std::vector<Side> others;
            for (auto one = type.changes.rbegin(); one != type.changes.rend(); ++one) {
                if (*one == last || !isOf(type, **one, fact) || valueOf(**one, fact) == valueOf(*last, fact))
                    continue;
                const bool superseded =
                    std::any_of(type.changes.begin(), type.changes.end(), [&](const TypeChange* later) {
                        return later != *one && isOf(type, *later, fact) &&
                               m_causality.hasSeen(later->stamp, (*one)->stamp);
                    });
                if (!superseded)
                    others.push_back({(*one)->stamp, valueOf(**one, fact)});
            }
            if (!others.empty())
                m_state.conflicts.push_back(
                    {fact, typeId, {}, {last->stamp, valueOf(*last, fact)}, std::move(others)});
        }
    }

    Causality m_causality;
    std::map<QString, TypeHistory> m_types;
    std::map<QString, std::vector<const SqueezeChange*>> m_squeezes;
    PlantState m_state;
};

} // namespace

PlantState plantState(const PlantHistory& history)
{
    return StateMaker(history).make();
}

QJsonObject canonicalJson(const PlantState& state)
{
    QJsonArray types, squeezes, conflicts;
    for (const auto& [id, type] : state.types)
        types.append(QJsonObject{{u"id"_s, id},
                                 {u"name"_s, type.name},
                                 {u"status"_s, toString(type.status)},
                                 {u"recipe"_s, type.recipe},
                                 {u"code"_s, type.code},
                                 {u"limits"_s, type.limits}});
    for (const auto& [id, place] : state.squeezes)
        squeezes.append(
            QJsonObject{{u"id"_s, id}, {u"type"_s, place.typeId}, {u"accepted"_s, place.accepted}});
    for (const PlantConflict& conflict : state.conflicts)
        conflicts.append(conflict.id());
    return {{u"types"_s, types}, {u"squeezes"_s, squeezes}, {u"conflicts"_s, conflicts}};
}

} // namespace gripscope
