// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/authorization.h"

#include "app/cli/terminal_secret.h"
#include "core/store/people_register.h"

#include <QFileInfo>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

Expected<Grant> consent(PeopleRegister people, Permission permission)
{
    const QString name = qEnvironmentVariable("GRIPSCOPE_PERSON").trimmed();
    if (name.isEmpty())
        return failure(
            ErrorCode::Usage,
            {u"%1 needs a supervisor in this library. Set GRIPSCOPE_PERSON to the name of one; the PIN "
             "or password is then asked for."_s.arg(inWords(permission))});
    const auto person = people.named(name);
    if (!person)
        return tl::unexpected<Error>(person.error());
    const auto secret = askSecret(u"%1. PIN or password of %2: "_s.arg(inWords(permission), person->name));
    if (!secret)
        return tl::unexpected<Error>(secret.error());
    return people.authorise(person->id, *secret, permission);
}

} // namespace

Expected<Acting> authorization(Library& library, const QString& operatorName, Permission permission)
{
    const Acting anybody{operatorName};
    const auto inForce = library.people().inForce();
    if (!inForce)
        return tl::unexpected<Error>(inForce.error());
    if (!*inForce)
        return anybody;
    library.actAs(anybody); // wrong tries are told with that name
    auto grant = consent(library.people(), permission);
    if (!grant)
        return tl::unexpected<Error>(grant.error());
    return Acting{operatorName, std::nullopt, std::move(*grant)};
}

Expected<Acting> authorization(const QString& libraryFile, const QString& operatorName, Permission permission)
{
    if (!QFileInfo::exists(libraryFile))
        return Acting{operatorName};
    const auto library = Library::open(libraryFile);
    if (!library)
        return tl::unexpected<Error>(library.error());
    return authorization(**library, operatorName, permission);
}

} // namespace gripscope::cli
