// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/authorization.h"

#include "app/terminal/ask_secret.h"
#include "core/library/people/people_register.h"

#include <QFileInfo>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

Expected<Grant> consent(PeopleRegister people, Permission permission)
{
    const QString name = qEnvironmentVariable("GRIPSCOPE_PERSON").trimmed();
    if (name.isEmpty()) {
        ASSIGN_OR_RETURN(const auto arming, people.arming());
        const bool anyone = mayDo(Role::Operator, permission, arming);
        return failure(
            ErrorCode::Usage,
            {u"%1 needs %2 in this library. Set GRIPSCOPE_PERSON to the name; the PIN or password is then "
             "asked for."_s.arg(inWords(permission), anyone ? u"one of the people"_s : u"a supervisor"_s)});
    }
    ASSIGN_OR_RETURN(const auto person, people.named(name));
    ASSIGN_OR_RETURN(const auto secret,
                     askSecret(u"%1. PIN or password of %2: "_s.arg(inWords(permission), person.name)));
    return people.authorise(person.id, secret, permission);
}

} // namespace

Expected<Acting> authorization(Library& library, const QString& operatorName, Permission permission)
{
    const Acting anybody{operatorName};
    ASSIGN_OR_RETURN(const auto inForce, library.people().inForce());
    if (!inForce)
        return anybody;
    library.actAs(anybody); // wrong tries are told with that name
    ASSIGN_OR_RETURN(auto grant, consent(library.people(), permission));
    return Acting{operatorName, std::nullopt, std::move(grant)};
}

Expected<Acting> authorization(const QString& libraryFile, const QString& operatorName, Permission permission)
{
    ASSIGN_OR_RETURN(const bool isThere, Library::isThere(libraryFile));
    if (!isThere)
        return Acting{operatorName};
    ASSIGN_OR_RETURN(const auto library, Library::open(libraryFile));
    return authorization(*library, operatorName, permission);
}

} // namespace gripscope::cli
