// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/manual_pages.h"

#include <QFile>
#include <QLocale>
#include <QMap>
#include <QRegularExpression>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const QString contents = u"index.md"_s;

ManualPage read(const QString& name)
{
    QFile file(manualPath(name));
    if (!file.open(QIODevice::ReadOnly))
        return {name, name, {}};
    const QString text = QString::fromUtf8(file.readAll());
    return {name, text.section(u'\n', 0, 0).mid(2).trimmed(), text}; // "# Title"
}

} // namespace

QString manualPath(const QString& file)
{
    const QString translated = u":/manual/%1/%2"_s.arg(QLocale().name().section(u'_', 0, 0), file);
    return QFile::exists(translated) ? translated : u":/manual/"_s + file;
}

std::vector<ManualPage> manualPages()
{
    std::vector<ManualPage> pages{read(contents)};
    static const QRegularExpression link(u"\\]\\((\\w+\\.md)\\)"_s);
    auto found = link.globalMatch(pages.front().text);
    while (found.hasNext()) {
        const QString name = found.next().captured(1);
        const auto isThis = [&name](const ManualPage& page) { return page.file == name; };
        if (std::none_of(pages.begin(), pages.end(), isThis))
            pages.push_back(read(name));
    }
    return pages;
}

bool speaksOf(const ManualPage& page, const QString& words)
{
    const QStringList wanted = words.split(u' ', Qt::SkipEmptyParts);
    return std::all_of(wanted.begin(), wanted.end(), [&page](const QString& word) {
        return page.text.contains(QRegularExpression(u"\\b"_s + QRegularExpression::escape(word),
                                                     QRegularExpression::CaseInsensitiveOption |
                                                         QRegularExpression::UseUnicodePropertiesOption));
    });
}

QString manualPageFor(const QString& screen)
{
    const QString page = screen + u".md"_s;
    return QFile::exists(manualPath(page)) ? page : contents;
}

} // namespace gripscope
