// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/types_page.h"

#include "core/signal/units.h"
#include "ui/models/type_space.h"
#include "ui/pages/fit_page_open.h"
#include "ui/pages/types_page_side.h"
#include "ui/pages/types_page_steps.h"
#include "ui/pages/types_page_tools.h"
#include "ui/scene/scene_view.h"
#include "ui/scene/type_scene.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/workbench.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>

namespace gripscope {

using namespace Qt::StringLiterals;

struct TypesPage::Private {
    bool paper = false, loading = false, stale = true;
    int loads = 0, clusterings = 0; ///< answers to older questions are dropped
    TypeSpace space;
    std::optional<SpaceClustering> clustering;
    std::optional<SceneHighlight> highlight;
    QString highlightText;
    qint64 highlightNumber = 0;

    SceneToolBar* tools = nullptr;
    QStackedWidget* stack = nullptr;
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
    sideCard->setMinimumWidth(268);
    auto* line = new QHBoxLayout(this);
    setSpacing(line, 2 * metrics::step, 2 * metrics::step);
    line->addWidget(buildSceneCard(), 75);
    line->addWidget(sideCard, 25);

    connect(d->side, &TypesSide::visibilityChanged, this, [this] { refresh(); });
    connect(d->side, &TypesSide::clusteringAsked, this, [this] { cluster(); });
    connect(d->side, &TypesSide::openAsked, this, [this] { openPicked(); });
    connect(d->view, &SceneView::picked, this, [this] { refresh(); });
    connect(d->steps, &StepBar::changed, this, [this] { refresh(); });
    connect(d->tools, &SceneToolBar::paperAsked, this, [this](bool paper) { showPaper(paper); });
    connect(d->tools, &SceneToolBar::failed, &bench, &Workbench::report);
    connect(&bench, &Workbench::inspectionChanged, this, [this] { takeInspection(); });
    connect(&bench, &Workbench::libraryChanged, this, [this] {
        d->stale = true;
        if (isVisible() && !d->paper)
            load();
    });
}

TypesPage::~TypesPage() = default;

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
    return d->clustering ? int(d->clustering->result.steps.size()) : 0;
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
    d->tools = new SceneToolBar(d->view);
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
    auto* text =
        makeLabel(tr("Enrol a type on the Enroll page: about ten squeezes of good parts. Or load the four "
                     "cans of the paper as examples."),
                  "second");
    text->setWordWrap(true);
    text->setAlignment(Qt::AlignCenter);
    auto* load = makeButton(tr("Load the example types"), {}, "primary");
    connect(load, &QPushButton::clicked, this, [this] { loadExamples(); });
    column->addStretch();
    column->addWidget(makeLabel(tr("No types in this library yet"), "title"), 0, Qt::AlignHCenter);
    column->addWidget(text);
    column->addSpacing(metrics::step);
    column->addWidget(load, 0, Qt::AlignHCenter);
    column->addStretch();
    return page;
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
        if (number != d->loads)
            return;
        d->loading = false;
        d->space = std::move(space);
        d->side->setSpace(d->space);
        cluster();
    };
    if (d->paper) {
        workbench().compute<TypeSpace>(
            this, [] { return paperTypeSpace(); }, take);
        return;
    }
    workbench().ask<TypeSpace>(
        this, [](Library& library) { return libraryTypeSpace(library); },
        [this, take](Expected<TypeSpace> space) {
            if (!space)
                workbench().report(space.error().describe());
            take(space ? std::move(*space) : TypeSpace{});
        });
}

void TypesPage::cluster()
{
    const int number = ++d->clusterings;
    d->clustering.reset();
    d->steps->setCount(0);
    if (d->space.types.size() < 2) {
        d->side->setClustering(nullptr, tr("Clusters need at least two types."));
        refresh();
        return;
    }
    workbench().compute<Expected<SpaceClustering>>(
        this,
        [space = d->space, scaling = d->side->scaling(), start = d->side->start()] {
            return clusterTypeSpace(space, scaling, start);
        },
        [this, number](Expected<SpaceClustering> found) {
            if (number != d->clusterings)
                return;
            if (found)
                d->clustering = std::move(*found);
            d->side->setClustering(d->clustering ? &*d->clustering : nullptr,
                                   found ? QString() : found.error().describe());
            d->steps->setCount(stepCount());
            refresh();
        });
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
        SceneHighlight highlight{
            {u"inspection"_s, at, 0, 0,
             d->highlightText + u'\n' + parametersText(parameters, parameterUnits(u"N"_s, u"m"_s))},
            std::nullopt};
        if (!object->covariance.isZero(0))
            highlight.ellipsoid = estimateEllipsoid(parameters, object->covariance * (*si * *si), 0.95);
        d->highlight = std::move(highlight);
    }
    refresh();
}

void TypesPage::refresh()
{
    const bool empty = d->space.squeezes.empty() && !d->loading;
    d->stack->setCurrentIndex(empty ? 1 : 0);
    const bool byCluster = d->steps->byCluster() && d->clustering;
    const bool ringed = d->highlight && !d->paper && !byCluster;
    if (d->space.types.size() == qsizetype(d->side->visibility().size()))
        d->view->setContent(
            byCluster ? clusterScene(d->space, d->side->visibility(), *d->clustering, d->steps->step())
                      : typeScene(d->space, d->side->visibility(), ringed ? d->highlight : std::nullopt));
    d->side->setHighlight(byCluster ? tr("Colour: cluster. Shape: type. The plus signs are the centroids.")
                          : ringed  ? d->highlightText
                                    : QString());
    QString picked;
    bool canOpen = false;
    for (const ScenePoint& point : d->view->content().points)
        if (point.id == d->view->pickedId())
            picked = point.tip;
    for (const SpaceSqueeze& squeeze : d->space.squeezes)
        canOpen = canOpen || (!picked.isEmpty() && squeeze.id == d->view->pickedId() && squeeze.hasRecording);
    d->side->setPicked(picked, canOpen);
}

void TypesPage::loadExamples()
{
    workbench().ask<void>(
        this, [](Library& library) { return library.loadExampleTypes(); },
        [this](Expected<void> done) {
            if (done)
                workbench().tellLibraryChanged();
            else
                workbench().report(done.error().describe());
        });
}

void TypesPage::openPicked()
{
    const QString id = d->view->pickedId();
    QString name;
    for (const SpaceSqueeze& squeeze : d->space.squeezes)
        if (squeeze.id == id)
            name = tr("%1, squeeze %2").arg(d->space.types[squeeze.type]).arg(squeeze.number);
    openStoredSqueeze(workbench(), this, id, name);
}

void TypesPage::prepareTour()
{
    if (d->stale)
        load();
}

bool TypesPage::tourReady() const
{
    return !d->loading && !d->stale && d->clustering && d->view->settled();
}

} // namespace gripscope
