// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit/fit_page.h"

#include "core/identification/estimators/estimator_table.h"
#include "core/identification/result/identification_json.h"
#include "core/signal/recording/recording_csv.h"
#include "ui/charts/fit_plots.h"
#include "ui/charts/region_plot.h"
#include "ui/context/workbench.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/fit/fit_page_squeezes.h"
#include "ui/pages/fit/fit_page_summary.h"
#include "ui/pages/fit/fit_page_validation.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/windows/file_dialog.h"

#include <QClipboard>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QStackedWidget>
#include <QUrl>

#include <algorithm>
#include <iterator>

namespace gripscope {

using namespace Qt::StringLiterals;

struct FitPage::Private {
    std::optional<FitSubject> subject;
    int generation = 0; ///< answers for an older subject are dropped
    bool identifying = false;

    QStackedWidget* stack = nullptr;
    FitPlots* plots = nullptr;
    FitSummary* summary = nullptr;
    FitExporter* exporter = nullptr;
    ValidationChooser* chooser = nullptr;
    QLabel* state = nullptr;
    QPushButton* all = nullptr;
    QPushButton* copy = nullptr;
    QPushButton* save = nullptr;
};

namespace {

/// Every one, output error at the head of the table.
std::vector<Estimator> everyEstimator()
{
    std::vector<Estimator> result = allEstimators();
    const auto outputError = std::find(result.begin(), result.end(), Estimator::OutputError);
    std::rotate(result.begin(), outputError, std::next(outputError));
    return result;
}

Identification identifyByAll(const Recording& recording)
{
    IdentificationOptions options;
    options.estimators = everyEstimator();
    return identify(recording, options);
}

} // namespace

FitPage::FitPage(Workbench& bench, QWidget* parent) : Page(bench, parent), d(std::make_unique<Private>())
{
    setAcceptDrops(true);
    d->plots = new FitPlots;
    d->summary = new FitSummary;
    auto* plotCard = makeCard();
    auto* plotLayout = new QHBoxLayout(plotCard);
    plotLayout->setContentsMargins(1, 1, 1, metrics::step);
    plotLayout->addWidget(d->plots);
    auto* summaryCard = makeCard();
    auto* summaryLayout = new QHBoxLayout(summaryCard);
    summaryLayout->setContentsMargins(1, 1, 1, 1);
    summaryLayout->addWidget(d->summary);
    auto* halves = new QWidget;
    auto* line = new QHBoxLayout(halves);
    setSpacing(line, 0, 2 * metrics::step);
    line->addWidget(plotCard, 64);
    summaryCard->setMinimumWidth(404); // what the table of estimators needs
    prepareExport();
    prepareValidation();
    line->addWidget(summaryCard, 36);

    d->stack = new QStackedWidget;
    d->stack->addWidget(buildEmpty());
    d->stack->addWidget(halves);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 2 * metrics::step, metrics::step);
    column->setContentsMargins(2 * metrics::step, metrics::step, 2 * metrics::step, metrics::step);
    column->addWidget(buildBar());
    column->addWidget(d->stack, 1);

    // Out of sight it waits for setActive(): each inspection is a subject, and to lay out the plots takes
    // long.
    connect(&bench.navigator(), &Navigator::fitSubjectChanged, this, [this] {
        if (isVisible())
            takeSubject();
    });
    connect(d->summary, &FitSummary::estimatorChosen, this,
            [this](Estimator estimator) { showPlots(estimator); });
    takeSubject();
}

FitPage::~FitPage() = default;

QString FitPage::id() const
{
    return u"fit"_s;
}
QString FitPage::title() const
{
    return tr("Fit");
}
QString FitPage::iconName() const
{
    return u"labplot-xy-fit-curve"_s;
}

void FitPage::prepareExport()
{
    d->exporter = new FitExporter(workbench(), this);
    d->exporter->add(d->plots->response());
    d->exporter->add(d->plots->force());
    d->exporter->add(d->plots->residuals());
    d->exporter->add(d->plots->autocorrelations());
    d->exporter->add(d->plots->crossCorrelations());
    d->exporter->add(d->summary->regionPlot());
    d->exporter->add(d->summary->validation()->plot());
    d->exporter->setNumbers([this] {
        if (!d->subject)
            return QByteArray();
        return QJsonDocument(toJson(d->subject->identification, d->subject->recording, d->subject->title))
            .toJson();
    });
    connect(d->exporter, &FitExporter::told, this,
            [this](const QString& words) { d->state->setText(words); });
}

void FitPage::prepareValidation()
{
    d->chooser = new ValidationChooser(workbench(), d->summary->validation()->choices(), this);
    connect(d->chooser, &ValidationChooser::started, this, [this] { d->state->setText(tr("validating…")); });
    connect(d->chooser, &ValidationChooser::failed, this, [this] { d->state->clear(); });
    connect(d->chooser, &ValidationChooser::validated, this, [this](const Validation& validation) {
        d->state->clear();
        d->subject->identification.validation = validation;
        d->summary->showValidation(validation);
    });
}

QWidget* FitPage::buildBar()
{
    auto* bar = new QWidget;
    auto* line = new QHBoxLayout(bar);
    setSpacing(line, 0, metrics::step);
    auto* open = makeButton(tr("Open recording…"), u"document-open"_s);
    open->setToolTip(tr("Read a recording (CSV) and identify it"));
    d->all = makeButton(tr("Identify again"), u"view-refresh"_s);
    d->all->setToolTip(tr("Run every estimator on this squeeze"));
    d->copy = makeButton(tr("Copy numbers"), u"edit-copy"_s);
    d->copy->setToolTip(tr("Copy every number, tab-separated, with full precision"));
    d->save = makeButton(tr("Export") + u" \u25BE"_s, u"document-export"_s);
    d->save->setAccessibleName(tr("Export"));
    d->save->setToolTip(tr("Save plots (PNG, SVG), their data (CSV) and all numbers (JSON)"));
    auto* menu = new QMenu(d->save);
    d->exporter->fill(menu);
    d->save->setMenu(menu);
    d->state = makeLabel({}, "second");
    line->addWidget(open);
    line->addWidget(d->all);
    line->addWidget(d->copy);
    line->addWidget(d->save);
    line->addWidget(d->state, 1, Qt::AlignRight | Qt::AlignVCenter);
    connect(open, &QPushButton::clicked, this, [this] { chooseFile(); });
    connect(d->all, &QPushButton::clicked, this, [this] { runAllEstimators(); });
    connect(d->copy, &QPushButton::clicked, this, [this] { copyNumbers(); });
    return bar;
}

QWidget* FitPage::buildEmpty()
{
    auto* card = makeCard();
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 3 * metrics::step, metrics::step);
    auto* head = makeLabel(tr("No squeeze to look at yet"), "title");
    auto* text = makeLabel(
        tr("Squeeze a part on Inspect, double-click a row in History, or open a recording (CSV): drop "
           "the file here or press Open recording."),
        "second");
    text->setWordWrap(true);
    text->setAlignment(Qt::AlignCenter);
    column->addStretch();
    column->addWidget(head, 0, Qt::AlignHCenter);
    column->addWidget(text);
    column->addStretch();
    return card;
}

void FitPage::setActive(bool active)
{
    if (active)
        takeSubject();
}

void FitPage::takeSubject()
{
    const auto& subject = workbench().navigator().fitSubject();
    if (!subject) {
        d->stack->setCurrentIndex(0);
        d->all->setEnabled(false);
        d->copy->setEnabled(false);
        d->save->setEnabled(false);
        return;
    }
    // The same one again: what was found since, by every estimator, stays.
    if (d->subject && d->subject->title == subject->title && d->subject->recording == subject->recording)
        return;
    d->subject = subject;
    ++d->generation;
    d->identifying = false;
    showSubject();
    if (d->subject->identification.estimates.size() < estimatorTable().size())
        runAllEstimators();
}

void FitPage::runAllEstimators()
{
    if (!d->subject || d->identifying)
        return;
    d->identifying = true;
    d->all->setEnabled(false);
    d->state->setText(tr("identifying…"));
    const int generation = d->generation;
    workbench().background().compute<Identification>(
        this, [recording = d->subject->recording] { return identifyByAll(recording); },
        [this, generation](Identification found) {
            if (generation != d->generation)
                return;
            d->identifying = false;
            d->subject->identification = std::move(found);
            showSubject();
        });
}

void FitPage::showSubject()
{
    const FitSubject& subject = *d->subject;
    d->stack->setCurrentIndex(1);
    d->all->setEnabled(!d->identifying);
    d->copy->setEnabled(true);
    d->save->setEnabled(true);
    d->exporter->setSubject(subject.title);
    d->chooser->setSubject(d->subject);
    d->state->setText(d->identifying ? tr("identifying…") : QString());
    d->summary->show(subject.title, subject.identification, subject.recording.forceUnit,
                     subject.recording.positionUnit);
    const Estimate* best = subject.identification.best();
    showPlots(best ? best->estimator : subject.identification.recommended);
}

void FitPage::showPlots(Estimator estimator)
{
    if (!d->subject)
        return;
    d->plots->show(d->subject->identification, estimator, d->subject->recording.forceUnit,
                   d->subject->recording.positionUnit);
}

void FitPage::chooseFile()
{
    auto* dialog =
        new FileDialog(this, tr("Open recording"), QString(), tr("Recordings (*.csv);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { openRecording(file); });
    dialog->open();
}

void FitPage::openRecording(const QString& file)
{
    d->state->setText(tr("reading %1…").arg(QFileInfo(file).fileName()));
    const auto work = [file]() -> Expected<FitSubject> {
        ASSIGN_OR_RETURN(Recording recording, readRecordingCsv(file));
        Identification identification = identifyByAll(recording);
        return FitSubject{QFileInfo(file).fileName(), std::move(recording), std::move(identification)};
    };
    workbench().background().compute<Expected<FitSubject>>(this, work, [this](Expected<FitSubject> subject) {
        d->state->clear();
        if (subject)
            workbench().navigator().setFitSubject(std::move(*subject));
        else
            workbench().messages().report(subject.error().describe());
    });
}

void FitPage::copyNumbers()
{
    QGuiApplication::clipboard()->setText(fitNumbers(
        d->subject->identification, d->subject->recording.forceUnit, d->subject->recording.positionUnit));
    d->state->setText(tr("copied"));
}

void FitPage::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().first().isLocalFile())
        event->acceptProposedAction();
}

void FitPage::dropEvent(QDropEvent* event)
{
    openRecording(event->mimeData()->urls().first().toLocalFile());
}

void FitPage::prepareTour()
{
    if (d->subject)
        return;
    InspectSession& inspection = workbench().inspection();
    if (workbench().connection().armed() && inspection.state() == InspectSession::State::Ready &&
        inspection.squeeze()) {
        connect(&workbench(), &Workbench::inspectionChanged, this, [this] { takeTourSqueeze(); });
        return;
    }
    const auto work = []() -> FitSubject {
        Recording recording = simulatedSqueeze({0.0396, 43.0, 9990}, 1);
        Identification identification = identifyByAll(recording);
        return {tr("Simulated squeeze of can A"), std::move(recording), std::move(identification)};
    };
    workbench().background().compute<FitSubject>(this, work, [this](FitSubject subject) {
        workbench().navigator().setFitSubject(std::move(subject));
    });
}

void FitPage::takeTourSqueeze()
{
    const auto& result = workbench().inspection().result();
    if (d->subject || !result || workbench().inspection().state() != InspectSession::State::Ready)
        return;
    workbench().navigator().setFitSubject(
        {tr("Inspection %1").arg(result->number), result->recording, result->identification});
}

bool FitPage::tourReady() const
{
    return d->subject && !d->identifying;
}

} // namespace gripscope
