// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/options.h"
#include "core/store/library.h"
#include "ui/example_types_button.h"
#include "ui/main_window.h"
#include "ui/settings/settings.h"
#include "ui/settings/settings_link.h"
#include "ui/tour.h"
#include "ui/window_host.h"
#include "ui/workbench.h"

#include <QApplication>
#include <QTextStream>

#include <cstdlib>

using namespace Qt::StringLiterals;
using namespace gripscope;

namespace {

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
    Workbench bench(options.library.isEmpty() ? Library::defaultFile() : options.library,
                    Settings::userFile());
    Settings& settings = bench.settings();
    if (!options.theme.isEmpty())
        settings.setForThisRun(QString::fromLatin1(setting::theme.key), options.theme);
    if (!options.language.isEmpty())
        settings.setForThisRun(QString::fromLatin1(setting::language.key), options.language);
    const SettingsLink link(bench);
    const WindowHost host(bench);
    if (options.size.isValid())
        host.window().resize(options.size);
    host.window().show();
    for (const QString& problem : settings.takeProblems())
        bench.report(problem);
    if (options.examples || settings.get(setting::examplesAtStart))
        loadExampleTypes(bench);
    const QString address = options.device.isEmpty() ? SettingsLink::addressAtStart(bench) : options.device;
    if (!address.isEmpty())
        bench.connectTo(address);
    return QApplication::exec();
}

} // namespace

int main(int argc, char** argv)
{
    QCoreApplication::setOrganizationName(u"Gripscope"_s);
    QCoreApplication::setApplicationName(u"Gripscope"_s);
    QCoreApplication::setApplicationVersion(QStringLiteral(GRIPSCOPE_VERSION));
    prepareEnvironment(argc, argv);
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
