// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit/fit_page.h"

#include "core/base/work_watch.h"
#include "core/identification/estimators/estimator_table.h"
#include "core/identification/result/identification_json.h"
#include "ui/charts/bode_plots.h"
#include "ui/charts/fit_plots.h"
#include "ui/charts/region_plot.h"
#include "ui/context/workbench.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/fit/fit_page_squeezes.h"
#include "ui/pages/fit/fit_page_summary.h"
#include "ui/pages/fit/fit_page_validation.h"
#include "ui/pages/fit/opened_recordings.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/tool_button.h"

#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QShortcut>
#include <QStackedWidget>
#include <QUrl>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

struct FitPage::Private {
    std::optional<FitSubject> subject;
    int generation = 0;                     ///< answers for an older subject are dropped
    std::shared_ptr<WorkWatch> identifying; ///< by every estimator; null: it is done
    bool identifiesOpened = false;          ///< a recording that is not in view yet

    Estimator shown = Estimator::OutputError;  ///< whose model is in the plots
    std::optional<EmpiricalResponse> measured; ///< the subject's; none yet

    QStackedWidget* stack = nullptr;
    QStackedWidget* views = nullptr; ///< over time, or the Bode plot
    FitPlots* plots = nullptr;
    BodePlots* bode = nullptr;
    FitSummary* summary = nullptr;
    FitExporter* exporter = nullptr;
    ValidationChooser* chooser = nullptr;
    OpenedRecordings* files = nullptr;
    ElidedLabel* state = nullptr;
    QToolButton* back = nullptr;
    QPushButton* all = nullptr;
    QPushButton* bodeShown = nullptr;
    QPushButton* copy = nullptr;
    QPushButton* save = nullptr;
};

namespace {

/// Every one, output error at the head of the table.
std::vector<Estimator> everyEstimator()
{
    std::vector<Estimator> result = estimatorsOnPages();
    const auto outputError = std::find(result.begin(), result.end(), Estimator::OutputError);
    std::rotate(result.begin(), outputError, std::next(outputError));
    return result;
}

Identification identifyByAll(const Recording& recording, std::shared_ptr<WorkWatch> watch = {})
{
    IdentificationOptions options;
    options.watch = std::move(watch);
    options.estimators = everyEstimator();
    return identify(recording, options);
}

QStringList localFiles(const QMimeData& dropped)
{
    QStringList files;
    for (const QUrl& url : dropped.urls())
        if (url.isLocalFile())
            files << url.toLocalFile();
    return files;
}

} // namespace

FitPage::FitPage(Workbench& bench, QWidget* parent) : Page(bench, parent), d(std::make_unique<Private>())
{
    setAcceptDrops(true);
    d->state = new ElidedLabel;
    d->files = new OpenedRecordings(bench, this);
    connect(d->files, &OpenedRecordings::stateChanged, d->state, &ElidedLabel::setFullText);
    connect(d->files, &OpenedRecordings::opened, this, &FitPage::identifyOpened);
    connect(d->files, &OpenedRecordings::chosen, &bench.navigator(), &Navigator::setFitSubject);
    d->plots = new FitPlots;
    d->summary = new FitSummary;
    auto* plotCard = makeCard();
    auto* plotLayout = new QHBoxLayout(plotCard);
    plotLayout->setContentsMargins(1, 1, 1, metrics::step);
    d->bode = new BodePlots;
    d->views = new QStackedWidget;
    d->views->setStyleSheet(u"QStackedWidget { background: transparent; }"_s); // the card's
    d->views->addWidget(d->plots);
    d->views->addWidget(d->bode);
    plotLayout->addWidget(d->views);
    auto* summaryCard = makeCard();
    auto* summaryLayout = new QHBoxLayout(summaryCard);
    summaryLayout->setContentsMargins(1, 1, 1, 1);
    summaryLayout->addWidget(d->summary);
    auto* halves = new QWidget;
    auto* line = new QHBoxLayout(halves);
    setSpacing(line, 0, 2 * metrics::step);
    line->addWidget(plotCard, 64);
    summaryCard->setMinimumWidth(408); // what the table of estimators needs, with thick lines too
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
    d->exporter->addStack(d->bode);
    d->exporter->add(d->summary->regionPlot());
    d->exporter->add(d->summary->validation()->plot());
    d->exporter->setNumbers([this] {
        if (!d->subject)
            return QByteArray();
        return QJsonDocument(toJson(d->subject->identification, d->subject->recording, d->subject->title))
            .toJson();
    });
    connect(d->exporter, &FitExporter::told, d->state, &ElidedLabel::setFullText);
}

void FitPage::prepareValidation()
{
    d->chooser = new ValidationChooser(workbench(), d->summary->validation()->choices(), this);
    connect(d->chooser, &ValidationChooser::started, this,
            [this] { d->state->setFullText(tr("validating…")); });
    connect(d->chooser, &ValidationChooser::failed, this, [this] { d->state->setFullText({}); });
    connect(d->chooser, &ValidationChooser::validated, this, [this](const Validation& validation) {
        d->state->setFullText({});
        d->subject->identification.validation = validation;
        d->summary->showValidation(validation);
    });
}

QWidget* FitPage::buildBar()
{
    auto* bar = new QWidget;
    auto* line = new QHBoxLayout(bar);
    setSpacing(line, 0, metrics::step);
    auto* open = makeButton(tr("Open…"), u"document-open"_s);
    open->setToolTip(tr("Read recordings (CSV) and identify them"));
    d->all = makeButton(tr("Identify again"), u"view-refresh"_s);
    d->all->setObjectName("identifyAgain");
    d->all->setToolTip(tr("Run every estimator on this squeeze"));
    d->copy = makeButton(tr("Copy numbers") + u" \u25BE"_s, u"edit-copy"_s);
    d->copy->setAccessibleName(tr("Copy numbers"));
    d->copy->setToolTip(tr("Copy the results rounded for a text, for LaTeX or as a table, or every number"));
    d->copy->setMenu(makeCopyMenu(
        d->copy, [this]() -> const FitSubject& { return *d->subject; },
        [this] { d->state->setFullText(tr("copied")); }));
    d->save = makeButton(tr("Export") + u" \u25BE"_s, u"document-export"_s);
    d->save->setAccessibleName(tr("Export"));
    d->save->setToolTip(tr("Save plots (PNG, SVG), their data (CSV) and all numbers (JSON)"));
    auto* menu = new QMenu(d->save);
    d->exporter->fill(menu);
    d->save->setMenu(menu);
    d->bodeShown = makeButton(tr("Bode"));
    d->bodeShown->setObjectName("bodeShown");
    d->bodeShown->setCheckable(true);
    d->bodeShown->setAccessibleName(tr("Bode plot"));
    d->bodeShown->setToolTip(tr("Magnitude and phase of measurement and model over frequency"));
    connect(d->bodeShown, &QPushButton::toggled, this,
            [this](bool on) { d->views->setCurrentWidget(on ? static_cast<QWidget*>(d->bode) : d->plots); });
    d->state->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setRole(d->state, "second");
    buildBack();
    line->addWidget(d->back);
    line->addWidget(open);
    line->addWidget(d->files);
    line->addWidget(d->all);
    line->addWidget(d->bodeShown);
    line->addWidget(d->copy);
    line->addWidget(d->save);
    line->addWidget(d->state, 1);
    connect(open, &QPushButton::clicked, this, [this] { d->files->choose(); });
    connect(d->all, &QPushButton::clicked, this, [this] {
        d->files->cancel();
        d->identifying ? stopIdentifying() : runAllEstimators();
    });
    connect(&workbench(), &Workbench::ticked, this, [this] {
        if (d->identifying)
            d->state->setFullText(identifyingWords());
    });
    return bar;
}

void FitPage::buildBack()
{
    d->back = makeToolButton({}, u"go-previous"_s, {});
    d->back->setObjectName("fitBack");
    d->back->setMinimumSize(metrics::touchTarget, metrics::touchTarget);
    const auto go = [this] {
        if (d->subject && !d->subject->backTo.isEmpty())
            workbench().navigator().showPage(d->subject->backTo);
    };
    connect(d->back, &QToolButton::clicked, this, go);
    auto* shortcut = new QShortcut(QKeySequence(Qt::ALT | Qt::Key_Left), this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, go);
    showBack();
}

void FitPage::showBack()
{
    const QString to = d->subject ? d->subject->backTo : QString();
    const QString words = to == u"types"     ? tr("Back to Types (Alt+Left)")
                          : to == u"inspect" ? tr("Back to Inspect (Alt+Left)")
                                             : tr("Back to History (Alt+Left)");
    d->back->setAccessibleName(words);
    d->back->setToolTip(words);
    d->back->setVisible(!to.isEmpty());
}

QWidget* FitPage::buildEmpty()
{
    auto* card = makeCard();
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 3 * metrics::step, metrics::step);
    auto* head = makeLabel(tr("No squeeze to look at yet"), "title");
    auto* text = makeLabel(
        tr("Squeeze a part on Inspect, double-click a row in History, or open recordings (CSV): drop "
           "the files here or press Open."),
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
        d->all->setEnabled(d->identifying != nullptr);
        d->copy->setEnabled(false);
        d->bodeShown->setEnabled(false);
        d->save->setEnabled(false);
        return;
    }
    // The same one again: what was found since, by every estimator, stays.
    if (d->subject && d->subject->title == subject->title && d->subject->recording == subject->recording) {
        d->subject->backTo = subject->backTo;
        showBack();
        return;
    }
    if (!d->identifiesOpened)
        stopIdentifying();
    d->subject = subject;
    d->measured.reset();
    ++d->generation;
    showSubject();
    if (d->subject->identification.estimates.size() < estimatorsOnPages().size())
        runAllEstimators();
}

void FitPage::runAllEstimators()
{
    if (!d->subject || d->identifying)
        return;
    const int generation = d->generation;
    const std::shared_ptr<WorkWatch> watch = beginIdentifying();
    workbench().background().compute<Identification>(
        this, [recording = d->subject->recording, watch] { return identifyByAll(recording, watch); },
        [this, generation, watch](Identification found) {
            if (generation != d->generation || watch->stopped())
                return;
            stopIdentifying();
            d->subject->identification = std::move(found);
            showSubject();
        });
}

std::shared_ptr<WorkWatch> FitPage::beginIdentifying()
{
    stopIdentifying();
    d->identifying = std::make_shared<WorkWatch>();
    d->all->setEnabled(true);
    nameButton(tr("Cancel"));
    d->state->setFullText(identifyingWords());
    return d->identifying;
}

void FitPage::nameButton(const QString& words)
{
    d->all->setText(words);
    d->all->setAccessibleName(words);
}

void FitPage::stopIdentifying()
{
    if (!d->identifying)
        return;
    d->identifying->stop();
    d->identifying.reset();
    d->identifiesOpened = false;
    d->all->setEnabled(d->subject.has_value());
    nameButton(tr("Identify again"));
    d->state->setFullText({});
}

QString FitPage::identifyingWords() const
{
    return tr("identifying… %1 %").arg(static_cast<int>(100 * d->identifying->share()));
}

void FitPage::showSubject()
{
    const FitSubject& subject = *d->subject;
    d->stack->setCurrentIndex(1);
    d->all->setEnabled(true);
    d->copy->setEnabled(true);
    d->bodeShown->setEnabled(true);
    d->save->setEnabled(true);
    d->exporter->setSubject(subject.title);
    d->chooser->setSubject(d->subject);
    showBack();
    if (!d->measured)
        measureResponse();
    d->state->setFullText(d->identifying ? identifyingWords() : QString());
    d->files->follow(subject);
    d->summary->show(subject.title, subject.identification, lengthSeconds(subject.recording),
                     subject.recording.forceUnit, subject.recording.positionUnit);
    showPlots(subject.identification.recommended);
}

void FitPage::showPlots(Estimator estimator)
{
    if (!d->subject)
        return;
    d->shown = estimator;
    d->plots->show(d->subject->identification, estimator, d->subject->recording.forceUnit,
                   d->subject->recording.positionUnit);
    d->bode->show(bodeContent(*d->subject, estimator, d->measured));
}

void FitPage::measureResponse()
{
    const Identification& found = d->subject->identification;
    workbench().background().compute<EmpiricalResponse>(
        this,
        [force = found.force, position = found.position, lost = found.lost,
         sampleTime_s = found.sampleTime_s] {
            return empiricalResponse(force, position, sampleTime_s, lost);
        },
        [this, generation = d->generation](EmpiricalResponse measured) {
            if (generation != d->generation)
                return;
            d->measured = std::move(measured);
            d->bode->show(bodeContent(*d->subject, d->shown, d->measured));
        });
}

void FitPage::identifyOpened(const QString& name, const Recording& recording)
{
    const std::shared_ptr<WorkWatch> watch = beginIdentifying();
    d->identifiesOpened = true;
    workbench().background().compute<FitSubject>(
        this,
        [name, recording, watch] {
            return FitSubject{name, recording, identifyByAll(recording, watch)};
        },
        [this, watch](FitSubject subject) {
            if (watch->stopped()) {
                d->files->skip();
                return;
            }
            stopIdentifying();
            d->files->add(std::move(subject));
        });
}

void FitPage::openRecordings(const QStringList& files)
{
    d->files->open(files);
}

void FitPage::dragEnterEvent(QDragEnterEvent* event)
{
    if (!localFiles(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void FitPage::dropEvent(QDropEvent* event)
{
    openRecordings(localFiles(*event->mimeData()));
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
