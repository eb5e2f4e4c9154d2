// SPDX-License-Identifier: GPL-3.0-or-later
// From the arrival of the last sample of a squeeze to its painted verdict, in the whole window on the virtual
// gripper: median and 99th percentile, with 4 types and with 100. What a technician waits is to be under 100
// ms.
//   verdict_bench [--squeezes N]
#include "core/library/library.h"
#include "ui/context/workbench.h"
#include "ui/shell/main_window.h"
#include "ui/theme/theme.h"
#include "ui/widgets/outcome_view.h"

#include <QApplication>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

using Clock = LinkCounters::TimePoint::clock;

/// Types spread over what a gripper meets, with the scatter of the paper's cans.
void enrol(const QString& file, int types)
{
    const auto library = Library::open(file);
    if (!library || !(*library)->loadExampleTypes())
        qFatal("the library cannot be filled");
    for (int type = 4; type < types; ++type) {
        const auto added = (*library)->addType(u"type %1"_s.arg(type), {}, u"N"_s, u"m"_s);
        for (int squeeze = 0; added && squeeze < 10; ++squeeze) {
            const double spread = 1 + 0.01 * std::sin(37.0 * squeeze + type);
            NewGrasp grasp;
            grasp.typeId = added->id;
            grasp.forceUnit = u"N"_s;
            grasp.positionUnit = u"m"_s;
            Estimate estimate;
            estimate.status = EstimateStatus::Converged;
            estimate.parameters =
                MassDampingStiffness{0.02 * (1 + type % 10) * spread, 15.0 * (1 + type * 7 % 11) / spread,
                                     15000.0 + 900.0 * type * spread};
            grasp.estimates = {estimate};
            if (!(*library)->addGrasp(grasp))
                qFatal("a squeeze cannot be enrolled");
        }
        if (!added || !(*library)->approveType(added->id, {}))
            qFatal("a type cannot be approved");
    }
}

/// Notes when the panel has painted.
class PaintWatch : public QObject {
public:
    Clock::time_point painted;
    bool eventFilter(QObject*, QEvent* event) override
    {
        // The filter is asked before the panel paints; what it takes is the time of the event after it.
        if (event->type() == QEvent::Paint)
            QMetaObject::invokeMethod(
                this, [this] { painted = Clock::now(); }, Qt::QueuedConnection);
        return false;
    }
};

/// Waits as a program does: for events, without sleeping beside them.
void until(const std::function<bool()>& done)
{
    const auto begin = Clock::now();
    while (!done()) {
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
        if (Clock::now() - begin > std::chrono::minutes(1))
            qFatal("nothing came of it");
    }
}

/// Of one squeeze, each in milliseconds from the arrival of its last sample: when it was known to be through,
/// when it was judged, when that was painted.
struct Waits {
    double through = 0, judged = 0, painted = 0;
};

std::vector<Waits> waits(int types, int squeezes)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(u"bench.db"_s);
    enrol(file, types);
    Workbench bench(file);
    MainWindow window(bench);
    window.resize(1440, 900);
    window.show();
    window.showPage(u"inspect"_s);
    bench.connectTo(u"virtual:?object=A&seed=5"_s);
    InspectSession& session = bench.inspection();
    until([&] {
        return session.state() == InspectSession::State::Ready &&
               bench.connection().state() == ConnectSession::State::Connected;
    });
    bench.arm();
    auto* panel = window.findChild<VerdictPanel*>();
    PaintWatch watch;
    panel->installEventFilter(&watch);
    std::vector<Waits> waited;
    for (int i = 0; i < squeezes; ++i) {
        until([&] { return bench.connection().armed() && session.state() == InspectSession::State::Ready; });
        std::optional<Clock::time_point> last;
        Clock::time_point through;
        const auto follow = QObject::connect(&bench, &Workbench::ticked, &bench, [&] {
            if (last || session.state() != InspectSession::State::Judging)
                return;
            last = bench.connection().counters().newestArrival;
            through = Clock::now();
        });
        if (!session.squeeze())
            qFatal("a squeeze cannot begin");
        until([&] { return session.result().has_value(); });
        const Clock::time_point known = Clock::now();
        until([&] { return panel->outcome().has_value() && watch.painted > known; });
        QObject::disconnect(follow);
        const auto since = [&](Clock::time_point then) {
            return std::chrono::duration<double, std::milli>(then - *last).count();
        };
        if (last)
            waited.push_back({since(through), since(known), since(watch.painted)});
        until([&] { return !session.storing(); });
    }
    return waited;
}

double quantile(const std::vector<Waits>& waited, double Waits::*which, double share)
{
    std::vector<double> sorted;
    for (const Waits& one : waited)
        sorted.push_back(one.*which);
    std::sort(sorted.begin(), sorted.end());
    const auto at = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    return sorted.empty() ? 0 : sorted[std::min(std::max<std::size_t>(at, 1), sorted.size()) - 1];
}

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    Theme::instance().apply(ThemeKind::Light);
    const QStringList arguments = QApplication::arguments();
    const auto option = arguments.indexOf(u"--squeezes"_s);
    const int squeezes = option > 0 ? arguments.value(option + 1).toInt() : 200;
    for (const int types : {4, 100}) {
        const std::vector<Waits> waited = waits(types, squeezes);
        std::printf("%3d types, %zu squeezes: last sample to painted verdict, median %.0f ms, p99 %.0f ms\n",
                    types, waited.size(), quantile(waited, &Waits::painted, 0.5),
                    quantile(waited, &Waits::painted, 0.99));
        std::printf("    known to be through %.0f, %.0f; judged %.0f, %.0f\n",
                    quantile(waited, &Waits::through, 0.5), quantile(waited, &Waits::through, 0.99),
                    quantile(waited, &Waits::judged, 0.5), quantile(waited, &Waits::judged, 0.99));
    }
    return 0;
}
