// SPDX-License-Identifier: GPL-3.0-or-later
// What the house says of itself: its papers name files that are there, and a header is there for more than
// one.
#include "tests/support/test_registry.h"
#include "tests/support/text_file.h"

#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QMap>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

const QString root = QStringLiteral(GRIPSCOPE_SOURCE_DIR);

/// The files of the repository by their path in it, without what builds leave behind.
QStringList filesOfTheHouse()
{
    QStringList files;
    QDirIterator all(root, QDir::Files, QDirIterator::Subdirectories);
    while (all.hasNext()) {
        const QString path = QDir(root).relativeFilePath(all.next());
        if (!path.startsWith(u"build/"_s) && !path.startsWith(u".git/"_s))
            files.append(path);
    }
    return files;
}

bool isOfTheProduct(const QString& path)
{
    static const QRegularExpression product(u"^(core|devices|ui|app)/"_s);
    return product.match(path).hasMatch();
}

/// Who includes each header, but for the source of its own name. (A second source of the same subject is a
/// client: it could not be without the header.)
QMap<QString, QStringList> clientsOfHeaders(const QStringList& files)
{
    static const QRegularExpression include(u"^\\s*#\\s*include\\s+\"([^\"]+)\""_s,
                                            QRegularExpression::MultilineOption);
    QMap<QString, QStringList> clients;
    for (const QString& path : files) {
        if (path.endsWith(u".h") && isOfTheProduct(path))
            clients[path];
    }
    for (const QString& path : files) {
        if (!path.endsWith(u".h") && !path.endsWith(u".cpp") && !path.endsWith(u".c"))
            continue;
        const QString text = gripscope::test::textOf(root + u'/' + path);
        auto matches = include.globalMatch(text);
        while (matches.hasNext()) {
            const QString header = matches.next().captured(1);
            if (clients.contains(header) && path != header.chopped(2) + u".cpp"_s)
                clients[header].append(path);
        }
    }
    return clients;
}

/// PATH: WHY, a line each.
QMap<QString, QString> loneHeaders()
{
    QMap<QString, QString> reasons;
    for (const QString& line : gripscope::test::textOf(root + u"/tests/support/lone_headers.txt"_s)
                                   .split(u'\n', Qt::SkipEmptyParts)) {
        if (!line.startsWith(u'#'))
            reasons.insert(line.section(u':', 0, 0), line.section(u':', 1).trimmed());
    }
    return reasons;
}

/// What `paper` names, bare or by a path: from the root, from its own folder, or behind a folder that it has
/// been speaking of. A test is named by its file alone.
bool isThere(const QString& named, const QString& paper, const QStringList& files,
             const QSet<QString>& folders)
{
    const QString here = QFileInfo(paper).path();
    const bool atRoot = here == u".";
    if (QFileInfo::exists(root + u'/' + named) || QFileInfo::exists(root + u'/' + here + u'/' + named))
        return true;
    return std::any_of(files.begin(), files.end(), [&](const QString& file) {
        if (!file.endsWith(u'/' + named) && !(named.endsWith(u'/') && file.contains(u'/' + named)))
            return false;
        // The root's papers speak of the whole house, a room's of itself and of the rooms that it names.
        return atRoot || named.contains(u'/') || named.endsWith(u"_test.cpp") ||
               file.startsWith(here + u'/') || folders.contains(QFileInfo(file).path());
    });
}

/// The folders that a paper names, of paths to files too.
QSet<QString> foldersNamed(const QString& text)
{
    static const QRegularExpression path(
        u"(?:core|devices|ui|app|tests|packaging|resources)(?:/[a-z_0-9]+)*"_s);
    QSet<QString> folders;
    auto matches = path.globalMatch(text);
    while (matches.hasNext()) {
        const QString folder = matches.next().captured(); // or a file of it without its ending
        folders.insert(folder);
        folders.insert(QFileInfo(folder).path());
    }
    return folders;
}

} // namespace

/// Reads the sources themselves; a copy without some of them fails.
class HouseTest : public QObject {
    Q_OBJECT
private slots:
    void papersNameWhatIsThere()
    {
        // A word with capitals stands for what a reader chooses: command_NAME.cpp, x_y_test.cpp is a pattern
        // too.
        static const QRegularExpression name(
            u"`([a-z_0-9.][a-z_0-9./-]*(?:\\.(?:h|cpp|c|cmake|sh|txt|ts|md)|/)|"
            "(?:core|devices|ui|app|tests|packaging|resources)(?:/[a-z_0-9.]+)+)`"_s);
        const QStringList files = filesOfTheHouse();
        QStringList missing;
        int looked = 0;
        for (const QString& paper : files) {
            // (The manual speaks of the files of its readers.)
            if (!paper.endsWith(u".md") || paper.startsWith(u"resources/manual/") || paper == u"CHANGELOG.md")
                continue;
            const QString text = gripscope::test::textOf(root + u'/' + paper);
            const QSet<QString> folders = foldersNamed(text);
            auto matches = name.globalMatch(text);
            while (matches.hasNext()) {
                const QString named = matches.next().captured(1);
                ++looked;
                if (!named.startsWith(u"build/") && named != u"x_y_test.cpp" &&
                    !isThere(named, paper, files, folders))
                    missing.append(paper + u": "_s + named);
            }
        }
        QVERIFY(looked > 300); // it has read them
        QVERIFY2(missing.isEmpty(), qPrintable(u"named, and not there:\n"_s + missing.join(u'\n')));
    }
    void aHeaderHasTwoClientsOrATest()
    {
        const QMap<QString, QStringList> clients = clientsOfHeaders(filesOfTheHouse());
        QVERIFY(clients.size() > 300);
        QMap<QString, QString> listed = loneHeaders();
        QStringList faults;
        int few = 0;
        for (auto header = clients.begin(); header != clients.end(); ++header) {
            const auto ofTheProduct = std::count_if(header->begin(), header->end(), isOfTheProduct);
            if (ofTheProduct > 1)
                continue;
            ++few;
            const bool hasATest = ofTheProduct < header->size();
            const QString why = listed.take(header.key());
            if (!hasATest && why.isEmpty())
                faults.append(header.key() +
                              u": one client and no test; make it part of its client, or say why not in "
                              "tests/support/lone_headers.txt"_s);
            else if (hasATest && !why.isEmpty())
                faults.append(header.key() + u": in tests/support/lone_headers.txt, but it has a test"_s);
        }
        for (auto left = listed.begin(); left != listed.end(); ++left)
            faults.append(left.key() +
                          u": in tests/support/lone_headers.txt, but it has two clients or is not there"_s);
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(u'\n')));
        QVERIFY2(few < 60, qPrintable(u"%1 headers have at most one client in the product"_s.arg(few)));
    }
};

GRIPSCOPE_TEST(HouseTest)
#include "house_test.moc"
