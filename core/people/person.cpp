// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/people/person.h"

#include "core/base/words.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(Role role)
{
    return role == Role::Supervisor ? u"supervisor"_s : u"operator"_s;
}

std::optional<Role> roleFromString(const QString& text)
{
    for (const Role role : {Role::Operator, Role::Supervisor})
        if (toString(role) == text)
            return role;
    return {};
}

QString inWords(Role role)
{
    return role == Role::Supervisor ? Words::tr("supervisor") : Words::tr("operator");
}

std::chrono::seconds SignInTries::wait() const
{
    constexpr std::chrono::seconds first{30};
    constexpr std::chrono::seconds longest{15 * 60};
    if (wrong < free)
        return std::chrono::seconds(0);
    const int doublings = std::min(wrong - free, 10); // far beyond the longest
    return std::min(longest, first * (1 << doublings));
}

std::chrono::seconds SignInTries::remaining(const QDateTime& now) const
{
    if (!last.isValid())
        return std::chrono::seconds(0);
    const std::chrono::seconds passed(std::max<qint64>(0, last.secsTo(now)));
    return std::max(std::chrono::seconds(0), wait() - passed);
}

QString waitInWords(std::chrono::seconds wait)
{
    const auto count = wait.count();
    return count < 120 ? Words::tr("%1 s").arg(count) : Words::tr("%1 min").arg((count + 59) / 60);
}

} // namespace gripscope
