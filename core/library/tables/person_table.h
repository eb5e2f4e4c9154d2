// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/statement.h"
#include "core/people/person.h"

#include <vector>

namespace gripscope {

struct PersonRow {
    Person person;
    QString secretHash;
    int version = 1, secretVersion = 1;
};

namespace person_table {

/// The next version of a person, or the first.
[[nodiscard]] Expected<void> insert(Database& database, const PersonRow& row,
                                    const RowStamp& stamp = RowStamp::now());
/// Each version of each person, in the order of the versions.
[[nodiscard]] Expected<std::vector<std::pair<RowStamp, PersonRow>>> everyRow(Database& database);
[[nodiscard]] Expected<bool> isAnybodyThere(Database& database);
/// As they are now, active ones first, by name.
[[nodiscard]] Expected<std::vector<PersonRow>> all(Database& database);
/// What is signed with has to be one person's: another one who is active has this name, however it is
/// spelled.
[[nodiscard]] bool isNameTaken(const std::vector<PersonRow>& people, const QString& name,
                               const QString& exceptId);
/// Somebody who may manage people.
[[nodiscard]] bool isActiveSupervisor(const Person& person);
[[nodiscard]] Expected<std::optional<PersonRow>> find(Database& database, const QString& personId);

/// A try with the secret that the person has now; `right` once it was found to be right.
[[nodiscard]] Expected<void> insertTry(Database& database, const PersonRow& row, bool right);
[[nodiscard]] Expected<SignInTries> tries(Database& database, const PersonRow& row);

} // namespace person_table
} // namespace gripscope
