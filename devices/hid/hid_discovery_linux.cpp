// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/hid_discovery.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMap>
#include <QStringList>

// All that finding HID devices needs of Linux: sysfs, hidraw and udev.

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QByteArray contents(const QString& file)
{
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

QMap<QString, QString> readUevent(const QString& file)
{
    QMap<QString, QString> values;
    for (const QByteArray& line : contents(file).split('\n')) {
        const qsizetype equals = line.indexOf('=');
        if (equals > 0)
            values[QString::fromUtf8(line.left(equals))] = QString::fromUtf8(line.mid(equals + 1));
    }
    return values;
}

/// HID_ID is bus:vendor:product in hexadecimal, 0003:00001209:00000001.
bool readIds(const QString& text, HidNode& node)
{
    const QStringList parts = text.split(u':');
    if (parts.size() != 3)
        return false;
    bool vendorFine = false;
    bool productFine = false;
    const uint vendor = parts[1].toUInt(&vendorFine, 16);
    const uint product = parts[2].toUInt(&productFine, 16);
    if (!vendorFine || !productFine || vendor > 0xFFFF || product > 0xFFFF)
        return false;
    node.vendor = static_cast<std::uint16_t>(vendor);
    node.product = static_cast<std::uint16_t>(product);
    return true;
}

} // namespace

std::vector<HidNode> listHidNodes(const QString& classFolder, const QString& deviceFolder)
{
    std::vector<HidNode> nodes;
    const QStringList names =
        QDir(classFolder).entryList({u"hidraw*"_qs}, QDir::Dirs | QDir::System, QDir::Name);
    for (const QString& name : names) {
        const QString device = classFolder + u'/' + name + u"/device/"_qs;
        const QMap<QString, QString> uevent = readUevent(device + u"uevent"_qs);
        HidNode node;
        if (!readIds(uevent[u"HID_ID"_qs], node)) // gone meanwhile, or not a HID device after all
            continue;
        node.name = uevent[u"HID_NAME"_qs];
        node.serial = uevent[u"HID_UNIQ"_qs];
        node.port = uevent[u"HID_PHYS"_qs];
        node.instance = name + u'/' + QFileInfo(QFileInfo(device).canonicalFilePath()).fileName();
        node.vendorPage =
            contents(device + u"report_descriptor"_qs).startsWith(QByteArray("\x06\x00\xFF", 3));
        node.path = deviceFolder + u'/' + name;
        const QFileInfo file(node.path);
        node.accessible = file.isReadable() && file.isWritable();
        nodes.push_back(node);
    }
    return nodes;
}

} // namespace gripscope
