// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "devices/hid/node_permission.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString idText(std::uint16_t id)
{
    return u"%1"_s.arg(id, 4, 16, QLatin1Char('0'));
}

/// "rw-rw----"
QString modeText(QFileDevice::Permissions permissions)
{
    QString text;
    for (const auto& [flag, letter] :
         {std::pair(QFileDevice::ReadOwner, 'r'), std::pair(QFileDevice::WriteOwner, 'w'),
          std::pair(QFileDevice::ExeOwner, 'x'), std::pair(QFileDevice::ReadGroup, 'r'),
          std::pair(QFileDevice::WriteGroup, 'w'), std::pair(QFileDevice::ExeGroup, 'x'),
          std::pair(QFileDevice::ReadOther, 'r'), std::pair(QFileDevice::WriteOther, 'w'),
          std::pair(QFileDevice::ExeOther, 'x')})
        text += QLatin1Char(permissions.testFlag(flag) ? letter : '-');
    return text;
}

bool isRuleFor(const QString& line, std::uint16_t vendor, std::uint16_t product)
{
    const auto names = [&line](const QString& attribute, std::uint16_t id) {
        const QRegularExpression condition(u"ATTRS?\\{%1\\}==\"%2\""_s.arg(attribute, idText(id)),
                                           QRegularExpression::CaseInsensitiveOption);
        return condition.match(line).hasMatch();
    };
    return !line.trimmed().startsWith(u'#') && line.contains("TAG+=\"uaccess\""_L1) &&
           names(u"idVendor"_s, vendor) && names(u"idProduct"_s, product);
}

} // namespace

NodeAccess NodeAccess::here()
{
    const auto isSet = [](const char* name) { return !qEnvironmentVariableIsEmpty(name); };
    const bool screen = isSet("XDG_SEAT") || isSet("DISPLAY") || isSet("WAYLAND_DISPLAY");
    return {{u"/etc/udev/rules.d"_s, u"/run/udev/rules.d"_s, u"/usr/local/lib/udev/rules.d"_s,
             u"/usr/lib/udev/rules.d"_s, u"/lib/udev/rules.d"_s},
            QFileInfo(u"/proc/self"_s).owner(), // the one whose rights count
            screen && !isSet("SSH_CONNECTION")};
}

bool hasRule(const QStringList& folders, std::uint16_t vendor, std::uint16_t product)
{
    for (const QString& folder : folders)
        for (const QFileInfo& rules : QDir(folder).entryInfoList({u"*.rules"_s}, QDir::Files)) {
            QFile file(rules.filePath());
            if (!file.open(QIODevice::ReadOnly))
                continue;
            for (const QByteArray& line : file.readAll().split('\n'))
                if (isRuleFor(QString::fromUtf8(line), vendor, product))
                    return true;
        }
    return false;
}

NodePermission permissionOf(const HidNode& node, const NodeAccess& access)
{
    const QFileInfo file(node.path);
    return {file.isReadable(),
            file.isWritable(),
            file.owner(),
            file.group(),
            modeText(file.permissions()),
            hasRule(access.ruleFolders, node.vendor, node.product)};
}

QString missingIn(const NodePermission& permission)
{
    if (permission.read && permission.write)
        return {};
    const QString what = permission.read    ? Words::tr("writing")
                         : permission.write ? Words::tr("reading")
                                            : Words::tr("reading and writing");
    if (permission.owner.isEmpty())
        return what;
    return Words::tr("%1 (it belongs to %2, group %3, %4)")
        .arg(what, permission.owner, permission.group, permission.mode);
}

QString permissionCommand(const HidNode& node, const NodeAccess& access)
{
    if (hasRule(access.ruleFolders, node.vendor, node.product))
        return access.atTheScreen ? u"sudo udevadm trigger --action=change --subsystem-match=hidraw"_s
                                  : u"sudo setfacl -m u:%1:rw %2"_s.arg(access.user, node.path);
    const QString rule =
        u"KERNEL==\"hidraw*\", SUBSYSTEM==\"hidraw\", ATTRS{idVendor}==\"%1\", "
        "ATTRS{idProduct}==\"%2\", TAG+=\"uaccess\""_s.arg(idText(node.vendor), idText(node.product));
    // One line: where the first of several asks for a password, the others would be taken for it.
    return u"echo '%1' | sudo tee -a /etc/udev/rules.d/70-gripscope.rules && sudo udevadm control --reload "
           u"&& "
           "sudo udevadm trigger --subsystem-match=hidraw"_s.arg(rule);
}

QString permissionAdvice(const HidNode& node, const NodeAccess& access)
{
    const QString missing = missingIn(permissionOf(node, access));
    const QString advice = Words::tr("Type this in a terminal, then it is connected by itself:\n") +
                           permissionCommand(node, access);
    return missing.isEmpty() ? advice : Words::tr("What is missing is %1.").arg(missing) + u' ' + advice;
}

} // namespace gripscope
