// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/options.h"
#include "core/store/library.h"
#include "devices/replay/capture_folder.h"
#include "ui/main_window.h"
#include "ui/tour.h"
#include "ui/workbench.h"

#include <QApplication>
#include <QLocale>
#include <QSettings>
#include <QTextStream>

#include <cstdlib>

using namespace Qt::StringLiterals;
using namespace gripscope;

namespace {

/// Before the application exists: what the platform plugin and the scaling are chosen by.
void prepareEnvironment(int argc, char** argv)
{
    if (const QByteArray scale = earlyOption(argc, argv, "--scale"); !scale.isEmpty())
        qputenv("QT_SCALE_FACTOR", scale);
#ifdef Q_OS_LINUX
    const bool display = qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY");
    if (!display && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
#endif
}

/// The gripper that the next start connects to: one on USB by its serial number, or the virtual one.
void rememberGripper(QSettings& settings, const ConnectSession& connection)
{
    if (connection.state() != ConnectSession::State::Connected)
        return;
    const QString address = connection.identity().address;
    if (address.startsWith(u"hid:"_s))
        settings.setValue(u"gripper"_s, address);
    else if (address.startsWith(u"virtual:"_s))
        settings.setValue(u"gripper"_s, u"virtual:"_s);
}

/// On unless somebody set it otherwise; real grippers only.
void keepSessions(Workbench& bench, QSettings& settings)
{
    KeepSessions keep;
    keep.folder = settings.value(u"captures/folder"_s, CaptureFolder::defaultPath()).toString();
    const double megabytes = settings.value(u"captures/megabytes"_s, 0.0).toDouble();
    if (megabytes > 0)
        keep.limits.totalBytes = static_cast<qint64>(1e6 * megabytes);
    bench.setKeeping(keep, settings.value(u"captures/keep"_s, true).toBool());
    QObject::connect(&bench, &Workbench::keepingChanged, &bench,
                     [&bench, &settings] { settings.setValue(u"captures/keep"_s, bench.keepsSessions()); });
}

int runWindow(const DesktopOptions& options)
{
    Theme::instance().apply(options.theme);
    Workbench bench(options.library.isEmpty() ? Library::defaultFile() : options.library);
    QSettings settings;
    bench.setOperatorName(settings.value(u"operator"_s).toString());
    QObject::connect(&bench, &Workbench::operatorChanged, &bench,
                     [&bench, &settings] { settings.setValue(u"operator"_s, bench.operatorName()); });
    bench.setRates(readRates(settings));
    QObject::connect(&bench, &Workbench::ratesChanged, &bench,
                     [&bench, &settings] { writeRates(settings, bench.rates()); });
    keepSessions(bench, settings);
    MainWindow window(bench);
    if (options.size.isValid())
        window.resize(options.size);
    window.show();
    if (options.examples)
        bench.ask<void>(
            &bench, [](Library& library) { return library.loadExampleTypes(); },
            [&bench](const Expected<void>& done) {
                if (done)
                    bench.tellLibraryChanged();
                else
                    bench.report(done.error().describe());
            });
    QObject::connect(&bench, &Workbench::connectionChanged, &bench,
                     [&bench, &settings] { rememberGripper(settings, bench.connection()); });
    bench.connectTo(options.device.isEmpty() ? settings.value(u"gripper"_s, u"virtual:"_s).toString()
                                             : options.device);
    return QApplication::exec();
}

} // namespace

int main(int argc, char** argv)
{
    prepareEnvironment(argc, argv);
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(u"Gripscope"_s);
    QCoreApplication::setApplicationName(u"Gripscope"_s);
    QCoreApplication::setApplicationVersion(QStringLiteral(GRIPSCOPE_VERSION));
    const Expected<DesktopOptions> options = parseDesktopOptions(QCoreApplication::arguments());
    if (!options) {
        QTextStream(stderr) << "gripscope: " << options.error().describe() << Qt::endl;
        return 2;
    }
    if (!options->answer.isEmpty()) {
        QTextStream(stdout) << options->answer << Qt::endl;
        return 0;
    }
    QLocale::setDefault(QLocale(options->language));
    if (!options->tourFolder.isEmpty())
        return runTour({options->tourFolder, options->theme,
                        options->size.isValid() ? options->size : QSize(1440, 900)});
    return runWindow(*options);
}
