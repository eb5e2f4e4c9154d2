// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/library/library.h"
#include "devices/emergency/end_signals.h"
#include "devices/transport/crash_stop.h"
#include "ui/context/workbench.h"
#include "ui/pages/shared/example_types_button.h"
#include "ui/settings/settings_link.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/desktop_session.h"
#include "ui/shell/main_window.h"
#include "ui/shell/tour.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTextStream>

#include <cstdlib>
#include <cstring>
#include <tuple>

using namespace Qt::StringLiterals;
using namespace gripscope;

namespace {

/// What the desktop program was asked for on its command line.
struct DesktopOptions {
    QString tourFolder;    ///< --tour DIR: pictures of every page instead of a window
    QString theme;         ///< --theme light|dark|contrast; empty: as set
    QSize size;            ///< --size 1440x900
    QString language;      ///< --language en|de; empty: as set
    QString device;        ///< --device ADDRESS; empty: the gripper used last
    QString library;       ///< --library FILE; empty: the user's own
    bool examples = false; ///< --examples: adds the example types to the library
    QString answer;        ///< --help or --version: print this and end
};

tl::unexpected<Error> usage(const QString& reason)
{
    return failure(ErrorCode::Usage, {reason});
}

Expected<QSize> parseSize(const QString& text)
{
    static const QRegularExpression form(u"^(\\d{3,5})x(\\d{3,5})$"_s);
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch())
        return usage(u"--size is %1; it must read like 1440x900."_s.arg(text));
    return QSize(match.captured(1).toInt(), match.captured(2).toInt());
}

/// A capture is opened as the desktop opens files: by its name alone.
Expected<QString> gripperOf(const QCommandLineParser& parser)
{
    const QStringList files = parser.positionalArguments();
    if (files.isEmpty())
        return parser.value(u"device"_s);
    if (!files.first().endsWith(".gscap"_L1, Qt::CaseInsensitive))
        return usage(u"%1 is not an option. Try --help."_s.arg(files.first()));
    if (files.size() > 1 || parser.isSet(u"device"_s))
        return usage(u"%1 is one gripper too many."_s.arg(files.last()));
    return u"replay:"_s + QFileInfo(files.first()).absoluteFilePath();
}

void addOptions(QCommandLineParser& parser)
{
    parser.addPositionalArgument(u"FILE.gscap"_s, u"A capture to replay, in place of a gripper."_s,
                                 u"[FILE.gscap]"_s);
    parser.addOptions({
        {u"tour"_s, u"Save one picture of every page in DIR, then end."_s, u"DIR"_s},
        {u"theme"_s, u"light, dark or contrast, for this run; otherwise as set."_s, u"THEME"_s},
        {u"size"_s, u"Size of the window in logical pixels."_s, u"WIDTHxHEIGHT"_s},
        {u"scale"_s, u"Enlarges everything, 1 to 4, for this run; otherwise as set."_s, u"FACTOR"_s},
        {u"language"_s, u"Language of the window, en or de, for this run; otherwise as set."_s, u"CODE"_s},
        {u"device"_s, u"Gripper to connect to; without it, the one used last, or virtual:."_s, u"ADDRESS"_s},
        {u"library"_s, u"Library file, or postgresql://USER@HOST:PORT/DATABASE; your own without it."_s,
         u"FILE"_s},
        {u"examples"_s, u"Adds the four example types to the library."_s},
        {{u"h"_s, u"help"_s}, u"Shows this."_s},
        {{u"v"_s, u"version"_s}, u"Shows the version."_s},
    });
}

/// Usage errors name the option and what it may be.
Expected<DesktopOptions> parseDesktopOptions(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        u"Gripscope: squeeze a part, learn its mass, damping and stiffness, and which type it is."_s);
    addOptions(parser);
    if (!parser.parse(arguments))
        return usage(parser.errorText());
    DesktopOptions options;
    ASSIGN_OR_RETURN(options.device, gripperOf(parser));
    if (parser.isSet(u"help"_s))
        options.answer = parser.helpText().trimmed();
    else if (parser.isSet(u"version"_s))
        options.answer = u"gripscope " GRIPSCOPE_VERSION ""_s;
    for (const auto& [name, key, into] : {std::tuple(u"theme"_s, setting::theme, &options.theme),
                                          std::tuple(u"language"_s, setting::language, &options.language)}) {
        if (!parser.isSet(name))
            continue;
        const Setting* one = findSetting(QString::fromLatin1(key.key));
        *into = parser.value(name);
        if (!one->accepted(*into))
            return usage(u"--%1 is %2; expected %3."_s.arg(name, *into, one->expected()));
    }
    if (parser.isSet(u"size"_s)) {
        ASSIGN_OR_RETURN(const QSize size, parseSize(parser.value(u"size"_s)));
        options.size = size;
    }
    if (parser.isSet(u"scale"_s)) {
        bool number = false;
        const double scale = parser.value(u"scale"_s).toDouble(&number);
        if (!number || scale < 1 || scale > 4)
            return usage(u"--scale is %1; it must be a number from 1 to 4."_s.arg(parser.value(u"scale"_s)));
    }
    options.tourFolder = parser.value(u"tour"_s);
    ASSIGN_OR_RETURN(options.library, Library::placeFrom(parser.value(u"library"_s)));
    options.examples = parser.isSet(u"examples"_s);
    if (parser.isSet(u"tour"_s) && options.tourFolder.isEmpty())
        return usage(u"--tour needs a folder."_s);
    return options;
}

/// The value of an option that is needed before the application exists: `--name value` or `--name=value`.
QByteArray earlyOption(int argc, char** argv, const char* name)
{
    const std::size_t length = std::strlen(name);
    for (int i = 1; i < argc; ++i) {
        if (std::strncmp(argv[i], name, length) != 0)
            continue;
        if (argv[i][length] == '=')
            return argv[i] + length + 1;
        if (argv[i][length] == '\0' && i + 1 < argc)
            return argv[i + 1];
    }
    return {};
}

/// --scale, or what is set, as a factor; of the command line it may be anything that parseDesktopOptions()
/// refuses.
QByteArray scaleFactor(int argc, char** argv, const QString& settingsFile)
{
    if (const QByteArray asked = earlyOption(argc, argv, "--scale"); !asked.isEmpty())
        return asked;
    const int percent = Settings(settingsFile).get(setting::scale).toInt();
    return percent == 100 ? QByteArray() : QByteArray::number(percent / 100.0);
}

/// Before the application exists: what the platform plugin and the scaling are chosen by.
void prepareEnvironment(int argc, char** argv)
{
    if (const QByteArray scale = scaleFactor(argc, argv, Settings::userFile()); !scale.isEmpty())
        qputenv("QT_SCALE_FACTOR", scale);
#ifdef Q_OS_LINUX
    const bool display = qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY");
    if (!display && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
#endif
}

int runWindow(const DesktopOptions& options)
{
    const DesktopSession session(
        {options.library.isEmpty() ? Library::defaultFile() : options.library, Settings::userFile(),
         [&options](Settings& settings) {
             if (!options.theme.isEmpty())
                 settings.setForThisRun(QString::fromLatin1(setting::theme.key), options.theme);
             if (!options.language.isEmpty())
                 settings.setForThisRun(QString::fromLatin1(setting::language.key), options.language);
         }});
    Workbench& bench = session.workbench(); // until another library is opened
    Settings& settings = bench.settings();
    if (options.size.isValid())
        session.window().resize(options.size);
    session.window().show();
    for (const QString& problem : settings.takeProblems())
        bench.messages().report(problem);
    if (options.examples || settings.get(setting::examplesAtStart))
        loadExampleTypes(bench, Examples::Cans);
    const QString address = options.device.isEmpty() ? SettingsLink::addressAtStart(bench) : options.device;
    if (!address.isEmpty())
        bench.connectTo(address);
    // A logout or a shutdown stops the gripper before the window has closed.
    const EndSignals ending([] {
        QMetaObject::invokeMethod(
            QCoreApplication::instance(), [] { QCoreApplication::exit(0); }, Qt::QueuedConnection);
    });
    return QApplication::exec();
}

} // namespace

int main(int argc, char** argv)
{
    QCoreApplication::setOrganizationName(u"Gripscope"_s);
    QCoreApplication::setApplicationName(u"Gripscope"_s);
    QCoreApplication::setApplicationVersion(QStringLiteral(GRIPSCOPE_VERSION));
    CrashStop::installHandler();
    prepareEnvironment(argc, argv);
    // A dialog of the desktop's own would be modal, and have no STOP.
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication application(argc, argv);
    const Expected<DesktopOptions> options = parseDesktopOptions(QCoreApplication::arguments());
    if (!options) {
        QTextStream(stderr) << "gripscope: " << options.error().describe() << Qt::endl;
        return 2;
    }
    if (!options->answer.isEmpty()) {
        QTextStream(stdout) << options->answer << Qt::endl;
        return 0;
    }
    if (!options->tourFolder.isEmpty())
        return runTour({options->tourFolder, themeKindFromString(options->theme).value_or(ThemeKind::Light),
                        options->size.isValid() ? options->size : QSize(1440, 900),
                        options->language.isEmpty() ? u"en"_s : options->language});
    return runWindow(*options);
}
