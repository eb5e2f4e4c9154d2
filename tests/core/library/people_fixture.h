// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/people/people_register.h"
#include "tests/core/library/library_fixture.h"

namespace gripscope::test {

inline const QString pin = QStringLiteral("2468135790");
inline const QString password = QStringLiteral("ein langes Wort");

/// A supervisor, Sam, with a PIN, and an operator, Olli, with a password; roles are in force.
struct People {
    QString supervisorId, operatorId;

    explicit People(Library& library)
    {
        supervisorId = valueOf(library.people().add(QStringLiteral("Sam"), Role::Supervisor, Secret(pin))).id;
        library.actAs(
            {{},
             {},
             valueOf(library.people().authorise(supervisorId, Secret(pin), Permission::ManagePeople))});
        operatorId =
            valueOf(library.people().add(QStringLiteral("Olli"), Role::Operator, Secret(password))).id;
        library.actAs({});
    }
    [[nodiscard]] Acting supervisor(Library& library) const
    {
        return {{}, valueOf(library.people().signIn(supervisorId, Secret(pin))), {}};
    }
    [[nodiscard]] Acting operatorOf(Library& library) const
    {
        return {{}, valueOf(library.people().signIn(operatorId, Secret(password))), {}};
    }
};

} // namespace gripscope::test
