// SPDX-License-Identifier: GPL-3.0-or-later
// What `cmake --install` puts into a folder, and that it works from there.
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"
#include "tests/support/text_file.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QXmlStreamReader>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// The build as it is, installed into a folder of the test's own.
struct Installed {
    QTemporaryDir folder;
    int exit = -1;
    QByteArray output;

    Installed()
    {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(QStringLiteral(GRIPSCOPE_CMAKE),
                      {u"--install"_s, QStringLiteral(GRIPSCOPE_BUILD_DIR), u"--prefix"_s, folder.path()});
        process.waitForFinished(120'000);
        output = process.readAll();
        exit = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    }
    [[nodiscard]] QString path(const QString& name) const { return folder.filePath(name); }
};

const Installed& installed()
{
    static const Installed one;
    return one;
}

/// What a manual page shows: without its requests and escapes.
QString shownBy(const QString& page)
{
    QString text = textOf(page);
    return text.replace(u"\\-"_s, u"-"_s).replace(u"\\e"_s, u"\\"_s);
}

ProgramRun run(const QString& program, const QStringList& arguments)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"QT_QPA_PLATFORM"_s, u"offscreen"_s);
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    const bool ended = process.waitForFinished(60'000) && process.exitStatus() == QProcess::NormalExit;
    return {ended ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

QStringList optionsIn(const QByteArray& help)
{
    static const QRegularExpression form(u"(?<![\\w-])--[a-z][a-z0-9-]*"_s);
    QStringList options;
    QRegularExpressionMatchIterator it = form.globalMatch(QString::fromUtf8(help));
    while (it.hasNext())
        options << it.next().captured();
    options.removeDuplicates();
    return options;
}

/// The part of a page that is about one command, from its heading to the next.
QString sectionOf(const QString& page, const QString& command)
{
    const qsizetype from = page.indexOf(u"\n.SS %1\n"_s.arg(command));
    return from < 0 ? QString() : page.mid(from, page.indexOf(u"\n.S"_s, from + 2) - from);
}

/// "demo", "types", "types rename"...: what the program's help names, and the helps of those.
QStringList allCommands()
{
    QStringList all;
    static const QRegularExpression listed(u"^  ([a-z][a-z0-9-]*) {2,}"_s,
                                           QRegularExpression::MultilineOption);
    static const QRegularExpression action(u"(?:\\. |; )([a-z0-9-]+): "_s);
    const QString help = QString::fromUtf8(run(cliProgram(), {u"--help"_s}).out);
    for (auto it = listed.globalMatch(help); it.hasNext();) {
        const QString command = it.next().captured(1);
        all << command;
        const QString text = QString::fromUtf8(run(cliProgram(), {command, u"--help"_s}).out).simplified();
        if (!text.contains(u"\"%1 ACTION --help\""_s.arg(command)) &&
            !text.contains(u"\"%1 NAME --help\""_s.arg(command)))
            continue;
        for (auto one = action.globalMatch(text.section(u"Options:"_s, 0, 0)); one.hasNext();)
            all << command + u' ' + one.next().captured(1);
    }
    return all;
}

} // namespace

class InstallationTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY2(installed().exit == 0, installed().output.constData()); }

    void everythingIsWhereItIsLookedFor_data()
    {
        QTest::addColumn<bool>("isOfTheWindow");
        for (const char* file :
             {"bin/gripscope-cli", "bin/gripscope-virtual-gripper", "share/man/man1/gripscope-cli.1",
              "share/man/man1/gripscope-virtual-gripper.1", "lib/udev/rules.d/70-gripscope.rules",
              "share/doc/gripscope/manual/index.md", "share/doc/gripscope/manual/de/index.md",
              "share/doc/gripscope/manual/pictures/inspect.png", "share/doc/gripscope/PROTOCOL.md",
              "share/doc/gripscope/examples/profiles/example_bare.json"})
            QTest::newRow(file) << false;
        for (const char* file : {"bin/gripscope", "share/man/man1/gripscope.1",
                                 "share/applications/org.gripscope.gripscope.desktop",
                                 "share/metainfo/org.gripscope.gripscope.metainfo.xml",
                                 "share/mime/packages/org.gripscope.gripscope.xml",
                                 "share/icons/hicolor/scalable/apps/org.gripscope.gripscope.svg"})
            QTest::newRow(file) << true;
    }
    void everythingIsWhereItIsLookedFor()
    {
        QFETCH(bool, isOfTheWindow);
        if (isOfTheWindow && !GRIPSCOPE_HAS_UI)
            QSKIP("the window is not built here");
        const QFileInfo file(installed().path(QLatin1String(QTest::currentDataTag())));
        QVERIFY2(file.exists() && file.size() > 0, qPrintable(file.filePath()));
    }

    void theInstalledProgramRunsFromThere()
    {
        const ProgramRun told = run(installed().path(u"bin/gripscope-cli"_s), {u"reproduce-paper"_s});
        QVERIFY2(told.exit == 0, told.err.constData());
        QVERIFY(told.out.contains("83.99")); // the paper's table is inside
        QVERIFY(!told.err.contains("not found"));
    }

    void theManualPageHasEveryCommandAndOption()
    {
        const QString page = shownBy(installed().path(u"share/man/man1/gripscope-cli.1"_s));
        const QStringList commands = allCommands();
        QVERIFY2(commands.size() > 50 && commands.contains(u"types rename"_s) &&
                     commands.contains(u"study gauge"_s),
                 qPrintable(commands.join(u", "_s)));
        for (const QString& command : commands) {
            const QString section = sectionOf(page, command);
            QVERIFY2(!section.isEmpty(), qPrintable(command));
            const ProgramRun help = run(cliProgram(), command.split(u' ') << u"--help"_s);
            QVERIFY2(help.err.isEmpty(), qPrintable(command + u": "_s + QString::fromUtf8(help.err)));
            for (const QString& option : optionsIn(help.out.mid(help.out.indexOf("Options:"))))
                QVERIFY2(section.contains(option), qPrintable(command + u' ' + option));
        }
    }

    void thePagesOfTheOtherProgramsHaveEveryOption_data()
    {
        QTest::addColumn<bool>("isOfTheWindow");
        QTest::newRow("gripscope") << true;
        QTest::newRow("gripscope-virtual-gripper") << false;
    }
    void thePagesOfTheOtherProgramsHaveEveryOption()
    {
        QFETCH(bool, isOfTheWindow);
        if (isOfTheWindow && !GRIPSCOPE_HAS_UI)
            QSKIP("the window is not built here");
        const QString name = QLatin1String(QTest::currentDataTag());
        const QString page = shownBy(installed().path(u"share/man/man1/%1.1"_s.arg(name)));
        const ProgramRun help = run(installed().path(u"bin/"_s + name), {u"--help"_s});
        QCOMPARE(help.exit, 0);
        const QStringList options = optionsIn(help.out);
        QVERIFY(!options.isEmpty());
        for (const QString& option : options)
            QVERIFY2(page.contains(option), qPrintable(option));
        static const QRegularExpression value(u"\\b([a-z]+)=[A-Z0-9]"_s); // object=A, seed=7 ...
        for (auto it = value.globalMatch(QString::fromUtf8(help.out)); !isOfTheWindow && it.hasNext();) {
            const QString word = it.next().captured(1) + u'=';
            QVERIFY2(page.contains(word), qPrintable(word));
        }
    }

    void manualPagesHoldNoRequestByAccident()
    {
        // A line that begins with a dot is a request: all that are there are man(7)'s.
        static const QRegularExpression request(
            u"^[.'](?!\\\\\"|TH |SH |SS |TP$|PP$|B |I |BI |BR |RB |RI |IR |IP|EX$|EE$|br$)"_s,
            QRegularExpression::MultilineOption);
        for (const QString& name : QDir(installed().path(u"share/man/man1"_s)).entryList(QDir::Files)) {
            const QString page = textOf(installed().path(u"share/man/man1/"_s + name));
            const QRegularExpressionMatch match = request.match(page);
            QVERIFY2(!match.hasMatch(), qPrintable(name + u": "_s + page.mid(match.capturedStart(), 60)));
            static const QRegularExpression place(u"@[A-Z]+@"_s);
            QVERIFY2(!page.contains(place), qPrintable(name)); // none was left open
        }
    }

    void whatADesktopReadsIsValid_data()
    {
        QTest::addColumn<QStringList>("command");
        QTest::newRow("menu entry") << QStringList{u"desktop-file-validate"_s,
                                                   u"share/applications/org.gripscope.gripscope.desktop"_s};
        QTest::newRow("AppStream") << QStringList{u"appstreamcli"_s, u"validate"_s, u"--pedantic"_s,
                                                  u"--no-net"_s,
                                                  u"share/metainfo/org.gripscope.gripscope.metainfo.xml"_s};
    }
    void whatADesktopReadsIsValid()
    {
        if (!GRIPSCOPE_HAS_UI)
            QSKIP("the window is not built here");
        QFETCH(QStringList, command);
        const QString program = QStandardPaths::findExecutable(command.takeFirst());
        QVERIFY2(!program.isEmpty(), "desktop-file-utils or appstream is not installed");
        command.last() = installed().path(command.last());
        const ProgramRun checked = run(program, command);
        QVERIFY2(checked.exit == 0, (checked.out + checked.err).constData());
        QVERIFY2(!checked.out.contains("P: ") && !checked.out.contains("I: "), checked.out.constData());
    }

    void whatTheTypeOfACaptureIsCalledIsOneThing()
    {
        const QString mime = u"application/x-gripscope-capture"_s;
        const QString folder =
            QStringLiteral(GRIPSCOPE_SOURCE_DIR "/packaging/desktop/org.gripscope.gripscope");
        for (const QString& end : {u".desktop"_s, u".metainfo.xml"_s, u".xml"_s})
            QVERIFY2(textOf(folder + end).contains(mime), qPrintable(end));
        QXmlStreamReader xml(textOf(folder + u".xml"_s));
        while (!xml.atEnd())
            xml.readNext();
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    }

    void thePackageNeedsWhatTheProgramNeeds()
    {
        const QString folder = QStringLiteral(GRIPSCOPE_SOURCE_DIR "/packaging");
        const QString control = textOf(folder + u"/debian/control"_s);
        // What only makes building quicker, or serves benchmarks, is no part of a package's build.
        const QStringList spared{u"build-essential"_s, u"ccache"_s, u"mold"_s, u"git"_s,
                                 u"libbenchmark-dev"_s};
        for (const QString& line : textOf(folder + u"/dependencies.txt"_s).split(u'\n')) {
            const QStringList words = line.simplified().split(u' ');
            if (words.size() != 2 || (words[1] != u"build"_s && words[1] != u"run"_s) ||
                spared.contains(words[0]))
                continue;
            const QRegularExpression named(
                u"(^|[\\s,])%1([\\s,]|$)"_s.arg(QRegularExpression::escape(words[0])));
            QVERIFY2(named.match(control).hasMatch(), qPrintable(words[0]));
        }
    }

    void theChangelogBeginsWithThisVersion()
    {
        const QString changelog = textOf(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/packaging/debian/changelog"));
        QVERIFY(changelog.startsWith(u"gripscope (%1) "_s.arg(QStringLiteral(GRIPSCOPE_VERSION))));
        const QString metainfo = textOf(
            QStringLiteral(GRIPSCOPE_SOURCE_DIR "/packaging/desktop/org.gripscope.gripscope.metainfo.xml"));
        QVERIFY(metainfo.contains(u"<release version=\"%1\""_s.arg(QStringLiteral(GRIPSCOPE_VERSION))));
    }
};

GRIPSCOPE_TEST(InstallationTest)
#include "installation_test.moc"
