// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/options.h"

#include "core/library/library.h"
#include "ui/settings/values/settings.h"

#include <QCommandLineParser>
#include <QFileInfo>
#include <QRegularExpression>

#include <cstring>
#include <tuple>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

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

} // namespace

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

QByteArray scaleFactor(int argc, char** argv, const QString& settingsFile)
{
    if (const QByteArray asked = earlyOption(argc, argv, "--scale"); !asked.isEmpty())
        return asked;
    const int percent = Settings(settingsFile).get(setting::scale).toInt();
    return percent == 100 ? QByteArray() : QByteArray::number(percent / 100.0);
}

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

} // namespace gripscope
