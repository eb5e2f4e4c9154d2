// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/options.h"
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
