// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/types/types_page.h"

#include "core/base/work_watch.h"
#include "core/signal/recording/units.h"
#include "ui/charts/heat_map.h"
#include "ui/context/navigator.h"
#include "ui/context/workbench.h"
#include "ui/models/space_clustering.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/fit/fit_page_squeezes.h"
#include "ui/pages/shared/example_types_button.h"
#include "ui/pages/shared/type_limits_dialog.h"
#include "ui/pages/types/types_page_clusters.h"
#include "ui/pages/types/types_page_parts.h"
#include "ui/scene/scene_view.h"
#include "ui/scene/type_scene.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

void stop(const std::shared_ptr<WorkWatch>& watch)
{
    if (watch)
        watch->stop();
}

/// What the colours and the marks of the scene mean.
QString sceneWords(const SpaceClustering& clustering)
{
    const QString colors = TypesPage::tr("Colour: cluster. Shape: type.") + u' ';
    switch (clustering.outcome.request.method) {
    case ClusterMethod::KMeans:
        return colors + TypesPage::tr("The plus signs are the centroids.");
    case ClusterMethod::GaussianMixture:
        return colors +
               TypesPage::tr("The plus signs are the means, the ellipsoids hold 95 % of each component.");
    case ClusterMethod::SelfOrganizingMap:
        return colors + TypesPage::tr("The net is the map: a dot a unit, a line between neighbours.");
    }
    return colors;
}

/// The words of a failure. A request that makes no sense is told in the words it comes with.
QString wordsOf(const Error& error)
{
    return error.code == ErrorCode::Usage && !error.arguments.empty() ? error.argument(0) : error.describe();
}

} // namespace

struct TypesPage::Private {
    bool paper = false, loading = false, stale = true;
    bool clusteringUnderWay = false;
    int loads = 0, clusterings = 0, advices = 0; ///< answers to older questions are dropped
    /// Shared with the work that is done on it elsewhere.
    std::shared_ptr<const TypeSpace> space = std::make_shared<TypeSpace>();
    std::optional<SpaceClustering> clustering;
    std::shared_ptr<WorkWatch> clusteringWatch, adviceWatch;
    std::optional<SceneHighlight> highlight;
    QString highlightText, highlightTip;
    qint64 highlightNumber = 0;

    SceneToolBar* tools = nullptr;
    FitExporter* exporter = nullptr;
    QStackedWidget* stack = nullptr;
    QLabel *emptyTitle = nullptr, *emptyText = nullptr;
    QPushButton *loadExamples = nullptr, *loadSimulated = nullptr;
    SceneView* view = nullptr;
    StepBar* steps = nullptr;
    TypesSide* side = nullptr;
};

TypesPage::TypesPage(Workbench& bench, QWidget* parent) : Page(bench, parent), d(std::make_unique<Private>())
{
    d->side = new TypesSide;
    auto* sideCard = makeCard();
    auto* sideLayout = new QHBoxLayout(sideCard);
    sideLayout->setContentsMargins(1, 1, 1, 1);
    sideLayout->addWidget(d->side);
    sideCard->setMinimumWidth(292);
    auto* line = new QHBoxLayout(this);
    setSpacing(line, 2 * metrics::step, 2 * metrics::step);
    line->addWidget(buildSceneCard(), 75);
    line->addWidget(sideCard, 25);

    connect(d->side, &TypesSide::visibilityChanged, this, [this] { refresh(); });
    connect(d->side, &TypesSide::openAsked, this, [this] { openPicked(); });
    connect(d->side, &TypesSide::manageAsked, &bench.navigator(), &Navigator::manageTypes);
    connect(d->side, &TypesSide::limitsAsked, this,
            [this, &bench] { (new TypeLimitsDialog(bench, {}, this))->open(); });
    connect(clusters(), &ClustersPanel::asked, this, [this] { cluster(); });
    connect(clusters(), &ClustersPanel::cancelled, this, [this] { stop(d->clusteringWatch); });
    connect(clusters(), &ClustersPanel::scalingChanged, this, [this] { dropAdvice(); });
    connect(clusters()->advice(), &AdvicePanel::asked, this, [this] { advise(); });
    connect(clusters()->advice(), &AdvicePanel::cancelled, this, [this] { stop(d->adviceWatch); });
    connect(d->view, &SceneView::picked, this, [this](const QString& id) { takePick(id); });
    d->view->setTips([this](const QString& id) { return tipOf(id); });
    connect(d->steps, &StepBar::changed, this, [this] { refresh(); });
    connect(d->tools, &SceneToolBar::paperAsked, this, [this](bool paper) { showPaper(paper); });
    for (HeatMap* map : findChildren<HeatMap*>())
        d->exporter->addFigure(map); // its context menu
    connect(d->tools, &SceneToolBar::failed, this,
            [&bench](const QString& why) { bench.messages().report(why); });
    connect(&bench, &Workbench::inspectionChanged, this, [this] { takeInspection(); });
    connect(&bench, &Workbench::libraryChanged, this, [this] {
        d->stale = true;
        if (isVisible() && !d->paper)
            load();
    });
}

TypesPage::~TypesPage()
{
    stop(d->clusteringWatch);
    stop(d->adviceWatch);
}

QString TypesPage::id() const
{
    return u"types"_s;
}
QString TypesPage::title() const
{
    return tr("Types");
}
QString TypesPage::iconName() const
{
    return u"office-chart-scatter"_s;
}
SceneView* TypesPage::view() const
{
    return d->view;
}
int TypesPage::stepCount() const
{
    return d->clustering ? d->clustering->states() : 0;
}
ClustersPanel* TypesPage::clusters() const
{
    return d->side->clusters();
}

QWidget* TypesPage::buildSceneCard()
{
    d->view = makeSceneView(nullptr);
    d->stack = new QStackedWidget;
    d->stack->setStyleSheet(u"QStackedWidget { background: transparent; }"_s);
    d->stack->addWidget(d->view);
    d->stack->addWidget(buildEmpty());
    auto* card = makeCard();
    auto* column = new QVBoxLayout(card);
    column->setContentsMargins(2, 12, 2, 12);
    column->setSpacing(metrics::step);
    d->exporter = new FitExporter(workbench(), this);
    d->tools = new SceneToolBar(d->view, d->exporter);
    d->steps = new StepBar;
    column->addWidget(d->tools);
    column->addWidget(d->stack, 1);
    column->addWidget(d->steps);
    return card;
}

QWidget* TypesPage::buildEmpty()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    setSpacing(column, 3 * metrics::step, metrics::step);
    d->emptyTitle = makeLabel({}, "title");
    d->emptyText = makeLabel({}, "second");
    d->emptyText->setObjectName(u"typesEmptyText"_s);
    d->emptyText->setWordWrap(true);
    d->emptyText->setAlignment(Qt::AlignCenter);
    d->loadExamples = new ExampleTypesButton(workbench(), Examples::Cans);
    d->loadSimulated = new ExampleTypesButton(workbench(), Examples::Simulated);
    setRole(d->loadExamples, "primary");
    column->addStretch();
    column->addWidget(d->emptyTitle, 0, Qt::AlignHCenter);
    column->addWidget(d->emptyText);
    column->addSpacing(metrics::step);
    column->addWidget(d->loadExamples, 0, Qt::AlignHCenter);
    column->addWidget(d->loadSimulated, 0, Qt::AlignHCenter);
    column->addStretch();
    refreshEmpty();
    return page;
}

void TypesPage::refreshEmpty()
{
    const bool elsewhere = !d->space->elsewhere.empty();
    d->emptyTitle->setText(elsewhere ? tr("No type here has m, b and k")
                                     : tr("No types in this library yet"));
    d->emptyText->setText(
        elsewhere ? tr("Recognised without a mass, by what their squeezes tell, and not in this picture: %1.")
                        .arg(elsewhereText(*d->space))
                  : tr("Enrol a type on the Enroll page: about ten squeezes of good parts. Or load the four "
                       "cans of the paper as examples, or simulated parts that go on yielding."));
    d->loadExamples->setVisible(!elsewhere);
    d->loadSimulated->setVisible(!elsewhere);
}

void TypesPage::setActive(bool active)
{
    if (!active) {
        d->steps->play(false);
        return;
    }
    takeInspection();
    if (d->stale)
        load();
}

void TypesPage::showPaper(bool paper)
{
    if (d->paper == paper)
        return;
    d->paper = paper;
    d->tools->setPaper(paper);
    load();
}

void TypesPage::load()
{
    const int number = ++d->loads;
    d->loading = true;
    d->stale = false;
    const auto take = [this, number](TypeSpace space) {
        if (number == d->loads)
            takeSpace(std::move(space));
    };
    if (d->paper) {
        workbench().background().compute<TypeSpace>(
            this, [] { return paperTypeSpace(); }, take);
        return;
    }
    workbench().background().ask<TypeSpace>(
        this, [](Library& library) { return libraryTypeSpace(library); },
        [this, take](Expected<TypeSpace> space) {
            if (!space)
                workbench().messages().report(space.error().describe());
            take(space ? std::move(*space) : TypeSpace{});
        });
}

void TypesPage::takeSpace(TypeSpace space)
{
    d->loading = false;
    d->space = std::make_shared<TypeSpace>(std::move(space));
    d->side->setSpace(*d->space);
    takeClustering(std::nullopt, {}); // of another space: not to be mixed with this one
    dropAdvice();
    cluster();
}

void TypesPage::cluster()
{
    stop(d->clusteringWatch);
    const int number = ++d->clusterings;
    d->clusteringUnderWay = false;
    if (d->space->squeezes.empty()) {
        takeClustering(std::nullopt, {});
        return;
    }
    d->clusteringUnderWay = true;
    d->clusteringWatch = std::make_shared<WorkWatch>();
    ClusterRequest request = clusters()->request();
    request.watch = d->clusteringWatch;
    clusters()->setRunning(true);
    workbench().background().compute<Expected<SpaceClustering>>(
        this, [space = d->space, request] { return clusterTypeSpace(*space, request); },
        [this, number](Expected<SpaceClustering> found) {
            if (number != d->clusterings)
                return;
            d->clusteringUnderWay = false;
            const QString words = found ? found->remark() : wordsOf(found.error());
            takeClustering(found ? std::optional(std::move(*found)) : std::nullopt, words);
        });
}

void TypesPage::takeClustering(std::optional<SpaceClustering> clustering, const QString& words)
{
    d->clustering = std::move(clustering);
    clusters()->setRunning(false);
    clusters()->setClustering(*d->space, d->clustering ? &*d->clustering : nullptr, words);
    d->steps->setCount(stepCount());
    refresh();
}

void TypesPage::advise()
{
    stop(d->adviceWatch);
    const int number = ++d->advices;
    d->adviceWatch = std::make_shared<WorkWatch>();
    clusters()->advice()->setRunning(d->adviceWatch);
    workbench().background().compute<Expected<ClusterAdvice>>(
        this,
        [space = d->space, scaling = clusters()->request().scaling, watch = d->adviceWatch] {
            return adviseTypeSpace(*space, scaling, watch);
        },
        [this, number](const Expected<ClusterAdvice>& found) {
            if (number != d->advices)
                return;
            if (found)
                clusters()->advice()->setAdvice(*found);
            else if (found.error().code == ErrorCode::Cancelled)
                clusters()->advice()->clear();
            else
                clusters()->advice()->setFailure(wordsOf(found.error()));
        });
}

void TypesPage::dropAdvice()
{
    const bool wanted = clusters()->advice()->running() || clusters()->advice()->showsAdvice();
    stop(d->adviceWatch);
    ++d->advices;
    clusters()->advice()->clear();
    if (wanted)
        advise();
}

void TypesPage::showStep(int step)
{
    d->steps->goTo(step);
}

void TypesPage::takeInspection()
{
    const auto& result = workbench().inspection().result();
    if (!result || (d->highlight && result->number != 0 && result->number == d->highlightNumber))
        return;
    d->highlightNumber = result->number;
    d->highlight.reset();
    d->highlightText.clear();
    const std::optional<CorrectedParameters> object = result->identification.object();
    const std::optional<double> si = siFactor(result->recording.forceUnit, result->recording.positionUnit);
    if (object && si) {
        const Eigen::Vector3d at = object->parameters.vector() * *si;
        const MassDampingStiffness parameters{at.x(), at.y(), at.z()};
        d->highlightText = result->number > 0 ? tr("Ringed: inspection %1").arg(result->number)
                                              : tr("Ringed: the latest inspection");
        SceneHighlight highlight{{u"inspection"_s, at, 0, 0}, std::nullopt};
        std::optional<Eigen::Matrix3d> covariance;
        if (!object->covariance.isZero(0))
            covariance = object->covariance * (*si * *si);
        if (covariance)
            highlight.ellipsoid = estimateEllipsoid(parameters, *covariance, 0.95);
        d->highlightTip =
            d->highlightText + u'\n' + parametersText(parameters, siParameterUnits(), covariance);
        d->highlight = std::move(highlight);
    }
    refresh();
}

void TypesPage::refresh()
{
    const bool empty = d->space->squeezes.empty() && !d->loading;
    refreshEmpty();
    d->stack->setCurrentIndex(empty ? 1 : 0);
    d->side->showClusters(d->steps->byCluster());
    const bool byCluster = d->steps->byCluster() && d->clustering;
    const bool ringed = d->highlight && !d->paper && !byCluster;
    if (d->space->types.size() == qsizetype(d->side->visibility().size()))
        d->view->setContent(
            byCluster ? clusterScene(*d->space, d->side->visibility(), *d->clustering, d->steps->step())
                      : typeScene(*d->space, d->side->visibility(), ringed ? d->highlight : std::nullopt));
    if (byCluster)
        d->steps->setFigure(d->clustering->figure(d->steps->step()));
    d->side->setHighlight(byCluster ? sceneWords(*d->clustering) : ringed ? d->highlightText : QString());
    takePick(d->view->pickedId());
}

void TypesPage::takePick(const QString& id)
{
    const SpaceSqueeze* squeeze = id.isEmpty() ? nullptr : d->space->find(id);
    const bool visible = squeeze && d->side->visibility()[std::size_t(squeeze->type)];
    const bool ringed =
        !id.isEmpty() && d->view->content().highlight && id == d->view->content().highlight->point.id;
    d->view->pick(visible || ringed ? id : QString(), visible ? ownEllipsoid(*squeeze) : std::nullopt);
    d->side->setPicked(visible || ringed ? tipOf(id) : QString(), visible && squeeze->hasRecording);
}

QString TypesPage::tipOf(const QString& id) const
{
    if (const SpaceSqueeze* squeeze = d->space->find(id))
        return squeezeName(*d->space, *squeeze) + u'\n' +
               parametersText(squeeze->parameters, d->space->units, squeeze->covariance);
    return d->highlightTip;
}

void TypesPage::openPicked()
{
    if (const SpaceSqueeze* squeeze = d->space->find(d->view->pickedId()))
        openStoredSqueeze(workbench(), this, squeeze->id, squeezeName(*d->space, *squeeze), id());
}

void TypesPage::prepareTour()
{
    if (d->stale)
        load();
}

bool TypesPage::tourReady() const
{
    return !d->loading && !d->stale && !d->clusteringUnderWay && d->view->settled();
}

} // namespace gripscope
