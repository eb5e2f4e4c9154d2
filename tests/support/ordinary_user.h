// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>

#include <unistd.h>

namespace gripscope::test {

/// As an ordinary user, since root may write everywhere. Back to what it was at the end.
class OrdinaryUser {
public:
    OrdinaryUser() : m_user(geteuid())
    {
        if (m_user == 0 && seteuid(65534) != 0)
            qFatal("cannot become an ordinary user");
    }
    ~OrdinaryUser()
    {
        if (seteuid(m_user) != 0)
            qFatal("cannot become the old user again");
    }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;

private:
    uid_t m_user;
};

/// Readable by everybody, and writable by its owner or by nobody but root.
inline void setWritable(const QString& name, bool writable)
{
    using P = QFileDevice;
    const QFileDevice::Permissions read =
        P::ReadOwner | P::ExeOwner | P::ReadGroup | P::ExeGroup | P::ReadOther | P::ExeOther;
    QFile::setPermissions(name, writable ? read | P::WriteOwner : read);
}

} // namespace gripscope::test
