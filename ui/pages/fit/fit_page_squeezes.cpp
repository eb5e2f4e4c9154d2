// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit/fit_page_squeezes.h"

#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/signal/excitation/excitation.h"
#include "core/signal/preparation/preparation.h"
#include "ui/charts/overlay_plots.h"
#include "ui/context/workbench.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"

#include <QHBoxLayout>
#include <QMenu>

#include <algorithm>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const RegisteredDialog<OverlayDialog> overlayDialogRow("overlay", [](Workbench& bench, QWidget* over) {
    return new OverlayDialog(bench, {}, 0, over);
});

struct NamedRecording {
    QString name;
    Recording recording;
};

OverlaidSqueeze overlaid(const NamedRecording& from)
{
    PreparedRecord record = prepare(from.recording);
    OverlaidSqueeze squeeze;
    squeeze.name = from.name;
    squeeze.forceUnit = from.recording.forceUnit;
    squeeze.positionUnit = from.recording.positionUnit;
    squeeze.held = record.hold == ForceHold::Zero;
    const double start = record.time_s.empty() ? 0 : record.time_s.front();
    for (double& time : record.time_s)
        time -= start;
    const auto shared = [](std::vector<double>& values) {
        return std::make_shared<const std::vector<double>>(std::move(values));
    };
    squeeze.time_s = shared(record.time_s);
    squeeze.force = shared(record.force);
    squeeze.position = shared(record.position);
    return squeeze;
}

} // namespace

void openStoredSqueeze(Workbench& workbench, QObject* context, const QString& graspId, const QString& title,
                       const QString& backTo)
{
    Workbench* bench = &workbench;
    workbench.background().ask<Recording>(
        context, [graspId](Library& library) { return library.recording(graspId); },
        [bench, context, title, backTo](Expected<Recording> recording) {
            if (!recording) {
                bench->messages().report(recording.error().describe());
                return;
            }
            bench->background().compute<FitSubject>(
                context,
                [recording = std::move(*recording), title, backTo]() -> FitSubject {
                    Identification identification = identify(recording);
                    return {title, recording, std::move(identification), backTo};
                },
                [bench](FitSubject subject) { bench->navigator().showInFit(std::move(subject)); });
        });
}

Recording simulatedSqueeze(const MassDampingStiffness& object, std::uint64_t seed)
{
    constexpr double positionNoise_m = 5e-6;
    ExcitationOptions excitation; // the defaults are those of a squeeze: PRBS, 20 +- 10 N, 2 kHz, 1 s
    excitation.seed = seed;
    const Expected<std::vector<double>> force = makeExcitation(excitation);
    if (!force)
        return {};
    Recording recording;
    recording.sampleTime_s = excitation.sampleTime_s;
    recording.forceUnit = u"N"_s;
    recording.positionUnit = u"m"_s;
    recording.hold = ForceHold::Zero;
    recording.force = *force;
    SimulationOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = ForceHold::Zero;
    options.x0 = excitation.bias / object.k; // it rests under the bias when the squeeze begins
    recording.position = simulate(object, recording.force, options);
    GaussianNoise noise(seed);
    recording.time_s.reserve(recording.force.size());
    for (std::size_t i = 0; i < recording.force.size(); ++i) {
        recording.time_s.push_back(double(i) * recording.sampleTime_s);
        recording.position[i] += positionNoise_m * noise();
    }
    recording.provenance.insert(u"source"_s, u"simulated"_s);
    return recording;
}

OverlayDialog::OverlayDialog(Workbench& workbench, std::vector<Chosen> chosen, std::size_t all,
                             QWidget* parent)
    : Dialog(parent, Conduct::Beside), m_workbench(&workbench), m_plots(new OverlayPlots),
      m_state(new ElidedLabel)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("overlayDialog");
    setManualPage(u"history"_s);
    setWindowTitle(tr("Squeezes over each other"));
    auto* exporter = new FitExporter(workbench, this);
    exporter->addStack(m_plots);
    exporter->setSubject(tr("squeezes"));
    connect(exporter, &FitExporter::told, m_state, &ElidedLabel::setFullText);
    auto* save = makeButton(tr("Export") + u" \u25BE"_s, u"document-export"_s);
    save->setObjectName("overlayExport");
    save->setAccessibleName(tr("Export"));
    auto* menu = new QMenu(save);
    exporter->fillFigure(menu, m_plots);
    save->setMenu(menu);
    auto* close = makeButton(tr("Close"));
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    setRole(m_state, "second");
    m_state->setObjectName("overlayState");
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 2 * metrics::step, metrics::step);
    column->addWidget(m_plots, 1);
    auto* bar = new QHBoxLayout;
    setSpacing(bar, 0, metrics::step);
    bar->addWidget(m_state, 1);
    bar->addWidget(save);
    bar->addWidget(close);
    column->addLayout(bar);
    resize(800, 560);
    if (!chosen.empty())
        fetch(std::move(chosen), all);
}

void OverlayDialog::fetch(std::vector<Chosen> chosen, std::size_t all)
{
    chosen.resize(std::min(chosen.size(), OverlayPlots::most));
    m_state->setFullText(tr("reading…"));
    m_workbench->background().ask<std::vector<NamedRecording>>(
        this,
        [chosen](Library& library) -> Expected<std::vector<NamedRecording>> {
            std::vector<NamedRecording> found;
            for (const Chosen& one : chosen) {
                Expected<Recording> recording = library.recording(one.graspId);
                if (!recording)
                    return tl::unexpected<Error>(recording.error());
                found.push_back({one.name, std::move(*recording)});
            }
            return found;
        },
        [this, all](Expected<std::vector<NamedRecording>> found) {
            if (!found) {
                m_state->setFullText({});
                m_workbench->messages().report(found.error().describe());
                return;
            }
            m_workbench->background().compute<std::vector<OverlaidSqueeze>>(
                this,
                [recordings = std::move(*found)] {
                    std::vector<OverlaidSqueeze> squeezes;
                    for (const NamedRecording& recording : recordings)
                        squeezes.push_back(overlaid(recording));
                    return squeezes;
                },
                [this, all](std::vector<OverlaidSqueeze> squeezes) {
                    showSqueezes(std::move(squeezes), all);
                });
        });
}

void OverlayDialog::showSqueezes(std::vector<OverlaidSqueeze> squeezes, std::size_t all)
{
    m_plots->setSqueezes(std::move(squeezes));
    const std::size_t shown = m_plots->squeezes().size();
    m_state->setFullText(
        shown == all
            ? tr("%n squeeze(s), each from its start", nullptr, int(shown))
            : tr("%1 of %2 chosen squeezes, each from its start: at most %3, in the units of the first")
                  .arg(shown)
                  .arg(all)
                  .arg(OverlayPlots::most));
}

} // namespace gripscope
