// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/people/people_register.h"

#include "core/base/words.h"
#include "core/library/sql/time_ordered_id.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/permission_check.h"
#include "core/library/tables/person_table.h"
#include "core/library/tables/policy_table.h"
#include "core/library/tables/write_transaction.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString changing()
{
    return Words::tr("change its people");
}

tl::unexpected<Error> refused(const QString& why)
{
    return failure(ErrorCode::Usage, {why});
}

Expected<PersonRow> requirePerson(Database& database, const QString& personId)
{
    ASSIGN_OR_RETURN(const auto found, person_table::find(database, personId));
    if (!found)
        return failure(ErrorCode::NotFound, {Words::tr("such person")});
    return *found;
}

/// For who may manage people.
Expected<PersonRow> personToManage(Database& database, const QString& personId)
{
    RETURN_IF_ERROR(requirePermission(database, Permission::ManagePeople));
    return requirePerson(database, personId);
}

Expected<void> requireFreePersonName(const std::vector<PersonRow>& people, const QString& name,
                                     const QString& exceptId = {})
{
    if (person_table::isNameTaken(people, name, exceptId))
        return refused(
            Words::tr("There is already somebody called %1. Add a second name or a number.").arg(name));
    return {};
}

/// Nobody could ever change anything again.
Expected<void> requireSupervisorLeft(const std::vector<PersonRow>& people, const PersonRow& next)
{
    const bool left = std::any_of(people.begin(), people.end(), [&](const PersonRow& row) {
        return person_table::isActiveSupervisor(row.person.id == next.person.id ? next.person : row.person);
    });
    return left ? Expected<void>()
                : refused(Words::tr("%1 is the last supervisor. Make somebody else a supervisor first.")
                              .arg(next.person.name));
}

/// What `person_table::tries` says, as a refusal.
Expected<void> requireNoWait(Database& database, const PersonRow& row)
{
    ASSIGN_OR_RETURN(const auto tries, person_table::tries(database, row));
    const auto wait = tries.remaining(QDateTime::currentDateTimeUtc());
    if (wait.count() == 0)
        return {};
    return refused(
        Words::tr(
            "There were too many wrong tries for %1. Wait %2, then try again, or ask a supervisor for a "
            "new PIN or password.")
            .arg(row.person.name, waitInWords(wait)));
}

/// What is said after a wrong try.
Expected<QString> wrongInWords(Database& database, const PersonRow& row)
{
    ASSIGN_OR_RETURN(const auto tries, person_table::tries(database, row));
    const QString wrong = Words::tr("That is not the PIN or password of %1.").arg(row.person.name);
    const auto wait = tries.wait();
    return wait.count() > 0 ? Words::tr("%1 Wait %2 before the next try.").arg(wrong, waitInWords(wait))
                            : Words::tr("%1 Tries left before there is a wait: %2.")
                                  .arg(wrong)
                                  .arg(SignInTries::free - tries.wrong);
}

} // namespace

Expected<bool> PeopleRegister::inForce() const
{
    return person_table::isAnybodyThere(*m_database);
}

Expected<std::vector<Person>> PeopleRegister::all() const
{
    ASSIGN_OR_RETURN(const auto rows, person_table::all(*m_database));
    std::vector<Person> people;
    people.reserve(rows.size());
    for (const PersonRow& row : rows)
        people.push_back(row.person);
    return people;
}

Expected<Person> PeopleRegister::named(const QString& name) const
{
    ASSIGN_OR_RETURN(const auto people, all());
    for (const Person& person : people)
        if (person.active && person.name.compare(name.trimmed(), Qt::CaseInsensitive) == 0)
            return person;
    return failure(ErrorCode::NotFound, {Words::tr("person called %1 in the library").arg(name)});
}

Expected<void> PeopleRegister::require(Permission permission) const
{
    return requirePermission(*m_database, permission);
}

Expected<ArmingPolicy> PeopleRegister::arming() const
{
    return policy_table::arming(*m_database);
}

Expected<void> PeopleRegister::setArming(ArmingPolicy policy, const QString& reason)
{
    return writeTo<void>(*m_database, changing(), [&]() -> Expected<void> {
        RETURN_IF_ERROR(requirePermission(*m_database, Permission::ManagePeople));
        ASSIGN_OR_RETURN(const auto before, policy_table::arming(*m_database));
        if (before == policy)
            return {};
        RETURN_IF_ERROR(policy_table::insertArming(*m_database, policy));
        return audit_table::append(*m_database,
                                   {QString::fromUtf16(audit_action::armingPolicy),
                                    {},
                                    reason,
                                    {{u"from"_s, toString(before)}, {u"to"_s, toString(policy)}}});
    });
}

Expected<ApprovalPolicy> PeopleRegister::approval() const
{
    return policy_table::approval(*m_database);
}

Expected<void> PeopleRegister::setApproval(ApprovalPolicy policy, const QString& reason)
{
    return writeTo<void>(*m_database, changing(), [&]() -> Expected<void> {
        RETURN_IF_ERROR(requirePermission(*m_database, Permission::ManagePeople));
        ASSIGN_OR_RETURN(const auto before, policy_table::approval(*m_database));
        if (before == policy)
            return {};
        RETURN_IF_ERROR(policy_table::insertApproval(*m_database, policy));
        return audit_table::append(*m_database,
                                   {QString::fromUtf16(audit_action::approvalPolicy),
                                    {},
                                    reason,
                                    {{u"from"_s, toString(before)}, {u"to"_s, toString(policy)}}});
    });
}

Expected<Person> PeopleRegister::add(const QString& name, Role role, const Secret& secret)
{
    const QString trimmed = name.simplified();
    if (trimmed.isEmpty())
        return refused(Words::tr("The person needs a name."));
    if (const auto problem = secret.problem())
        return refused(*problem);
    const auto hash = hashOf(secret); // before the transaction: others need not wait for it
    if (!hash)
        return tl::unexpected(hash.error());
    return writeTo<Person>(*m_database, changing(), [&]() -> Expected<Person> {
        RETURN_IF_ERROR(requirePermission(*m_database, Permission::ManagePeople));
        ASSIGN_OR_RETURN(const auto people, person_table::all(*m_database));
        if (people.empty() && role != Role::Supervisor)
            return refused(
                Words::tr("The first person must be a supervisor: from then on only a supervisor can add "
                          "others."));
        RETURN_IF_ERROR(requireFreePersonName(people, trimmed));
        PersonRow row;
        row.person = {newTimeOrderedId(), trimmed, role, true, QDateTime::currentDateTimeUtc()};
        row.secretHash = *hash;
        auto done = person_table::insert(*m_database, row);
        if (done)
            done = audit_table::append(
                *m_database,
                {QString::fromUtf16(audit_action::personAdded), trimmed, {}, {{u"role"_s, toString(role)}}});
        if (!done)
            return tl::unexpected(done.error());
        return row.person;
    });
}

Expected<void> PeopleRegister::change(const QString& personId, const PersonRow& next, const char16_t* action,
                                      const QString& reason)
{
    ASSIGN_OR_RETURN(const auto people, person_table::all(*m_database));
    RETURN_IF_ERROR(requireSupervisorLeft(people, next));
    if (next.person.active)
        RETURN_IF_ERROR(requireFreePersonName(people, next.person.name, personId));
    PersonRow row = next;
    ++row.version;
    RETURN_IF_ERROR(person_table::insert(*m_database, row));
    return audit_table::append(
        *m_database,
        {QString::fromUtf16(action), row.person.name, reason, {{u"role"_s, toString(row.person.role)}}});
}

Expected<void> PeopleRegister::setRole(const QString& personId, Role role, const QString& reason)
{
    return writeTo<void>(*m_database, changing(), [&]() -> Expected<void> {
        ASSIGN_OR_RETURN(auto row, personToManage(*m_database, personId));
        if (row.person.role == role)
            return {};
        row.person.role = role;
        return change(personId, row, audit_action::personRole, reason);
    });
}

Expected<void> PeopleRegister::setSecret(const QString& personId, const Secret& secret)
{
    if (const auto problem = secret.problem())
        return refused(*problem);
    ASSIGN_OR_RETURN(const auto hash, hashOf(secret));
    return writeTo<void>(*m_database, changing(), [&]() -> Expected<void> {
        const auto& signedIn = m_database->acting().signedIn;
        const bool own = signedIn && signedIn->personId() == personId;
        if (auto may = requirePermission(*m_database, Permission::ManagePeople); !may && !own)
            return may;
        ASSIGN_OR_RETURN(auto row, requirePerson(*m_database, personId));
        row.secretHash = hash;
        ++row.secretVersion;
        return change(personId, row, audit_action::personSecret);
    });
}

Expected<void> PeopleRegister::setActive(const QString& personId, bool active)
{
    return writeTo<void>(*m_database, changing(), [&]() -> Expected<void> {
        ASSIGN_OR_RETURN(auto row, personToManage(*m_database, personId));
        if (row.person.active == active)
            return {};
        row.person.active = active;
        return change(personId, row,
                      active ? audit_action::personReactivated : audit_action::personDeactivated);
    });
}

Expected<Authority> PeopleRegister::check(const QString& personId, const Secret& secret,
                                          const std::optional<Permission>& permission)
{
    // Counted as wrong first: two processes at once, or one that is ended in between, win no free try.
    const auto row =
        writeTo<PersonRow>(*m_database, Words::tr("note the try to sign in"), [&]() -> Expected<PersonRow> {
            auto person = requirePerson(*m_database, personId);
            if (!person)
                return person;
            if (!person->person.active)
                return refused(
                    Words::tr("%1 is not active in this library any more.").arg(person->person.name));
            ASSIGN_OR_RETURN(const auto arming, policy_table::arming(*m_database));
            if (permission && !mayDo(person->person.role, *permission, arming))
                return refused(
                    Words::tr("%1 is an operator. A supervisor is needed.").arg(person->person.name));
            auto done = requireNoWait(*m_database, *person);
            if (done)
                done = person_table::insertTry(*m_database, *person, false);
            if (!done)
                return tl::unexpected(done.error());
            return person;
        });
    if (!row)
        return tl::unexpected(row.error());
    const bool right = matches(secret, row->secretHash);
    const Authority authority(row->person);
    NewAuditEntry entry;
    entry.subject = permission ? toString(*permission) : row->person.name;
    entry.action = QString::fromUtf16(permission ? audit_action::authorised : audit_action::signIn);
    entry.by = authority;
    if (!right) {
        entry.action = QString::fromUtf16(audit_action::signInFailed);
        entry.subject = row->person.name;
        entry.by.reset(); // whoever it was
    }
    const auto noted =
        writeTo<QString>(*m_database, Words::tr("note the try to sign in"), [&]() -> Expected<QString> {
            Expected<void> done = right ? person_table::insertTry(*m_database, *row, true) : Expected<void>();
            if (done)
                done = audit_table::append(*m_database, entry);
            if (!done)
                return tl::unexpected(done.error());
            return right ? Expected<QString>(QString()) : wrongInWords(*m_database, *row);
        });
    if (!noted)
        return tl::unexpected(noted.error());
    return right ? Expected<Authority>(authority) : refused(*noted);
}

Expected<Authority> PeopleRegister::signIn(const QString& personId, const Secret& secret)
{
    return check(personId, secret, std::nullopt);
}

Expected<Grant> PeopleRegister::authorise(const QString& personId, const Secret& secret,
                                          Permission permission)
{
    ASSIGN_OR_RETURN(const auto by, check(personId, secret, permission));
    return Grant{by, permission};
}

Expected<void> PeopleRegister::signedOut(const Authority& who, bool idle)
{
    return writeTo<void>(*m_database, Words::tr("note that somebody signed out"), [&] {
        NewAuditEntry entry;
        entry.action = QString::fromUtf16(audit_action::signOut);
        entry.subject = who.name();
        entry.by = who;
        entry.details = {{u"idle"_s, idle}};
        return audit_table::append(*m_database, entry);
    });
}

} // namespace gripscope
