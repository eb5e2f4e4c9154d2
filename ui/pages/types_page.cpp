// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/types_page.h"

#include "core/signal/units.h"
#include "ui/models/type_space.h"
#include "ui/pages/fit_page_open.h"
#include "ui/pages/types_page_side.h"
#include "ui/scene/scene_view.h"
#include "ui/scene/type_scene.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/workbench.h"

#include <QButtonGroup>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QSlider>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>

namespace gripscope {

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

struct TypesPage::Private {
    bool paper = false, loading = false, stale = true, byCluster = false;
    int generation = 0; ///< answers to older questions are dropped
    TypeSpace space;
    std::optional<SpaceClustering> clustering;
    std::optional<SceneHighlight> highlight;
    QString highlightText;
    qint64 highlightNumber = -1;
    QTimer playing;

    QComboBox* source = nullptr;
    QStackedWidget* stack = nullptr;
    SceneView* view = nullptr;
    QToolButton* orthographic = nullptr;
    QPushButton* byTypeButton = nullptr;
    QPushButton* byClusterButton = nullptr;
    QToolButton* play = nullptr;
    QToolButton* back = nullptr;
    QToolButton* forward = nullptr;
    QSlider* steps = nullptr;
    QLabel* stepText = nullptr;
    TypesSide* side = nullptr;
};

namespace {

QToolButton* toolButton(const QString& text, const QString& icon, const QString& tip)
{
    auto* button = new QToolButton;
    button->setAccessibleName(tip);
    button->setToolTip(tip);
    if (icon.isEmpty()) {
        button->setText(text);
        return button;
    }
    const auto paint = [button, icon] { button->setIcon(Theme::instance().icon(icon)); };
    paint();
    button->setIconSize({20, 20});
    QObject::connect(&Theme::instance(), &Theme::changed, button, paint);
    return button;
}

} // namespace

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

    d->playing.setInterval(700ms);
    connect(&d->playing, &QTimer::timeout, this, [this] {
        if (d->steps->value() < d->steps->maximum())
            showStep(d->steps->value() + 1);
        else
            play(false);
    });
    connect(d->side, &TypesSide::visibilityChanged, this, [this] { refresh(); });
    connect(d->side, &TypesSide::clusteringAsked, this, [this] { cluster(); });
    connect(d->side, &TypesSide::openAsked, this, [this] { openPicked(); });
    connect(d->view, &SceneView::picked, this, [this] { refresh(); });
    connect(d->view, &SceneView::cameraChanged, this,
            [this] { d->orthographic->setChecked(d->view->orthographic()); });
    connect(&bench, &Workbench::inspectionChanged, this, [this] { takeInspection(); });
    connect(&bench, &Workbench::libraryChanged, this, [this] {
        d->stale = true;
        if (isVisible() && !d->paper)
            load();
    });
    refreshStepBar();
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
    column->addLayout(buildToolBar());
    column->addWidget(d->stack, 1);
    column->addLayout(buildStepBar());
    return card;
}

QLayout* TypesPage::buildToolBar()
{
    auto* line = new QHBoxLayout;
    line->setContentsMargins(12, 0, 12, 0);
    line->setSpacing(metrics::insideControl);
    d->source = new QComboBox;
    d->source->addItems({tr("This library"), tr("The paper's tables (units as printed)")});
    d->source->setAccessibleName(tr("Which types to show"));
    d->source->setMinimumContentsLength(12);
    d->source->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    d->source->view()->setMinimumWidth(300);
    connect(d->source, &QComboBox::currentIndexChanged, this, [this](int index) { showPaper(index == 1); });
    line->addWidget(d->source, 1);
    line->addStretch(1);
    if (d->view->threeDimensional()) {
        const auto look = [this, line](const QString& text, const QString& icon, const QString& tip,
                                       SceneDirection where) {
            auto* button = toolButton(text, icon, tip);
            connect(button, &QToolButton::clicked, d->view, [this, where] { d->view->lookAlong(where); });
            line->addWidget(button);
        };
        look(u"m"_s, {}, tr("Look along the mass axis (M)"), SceneDirection::AlongMass);
        look(u"b"_s, {}, tr("Look along the damping axis (B)"), SceneDirection::AlongDamping);
        look(u"k"_s, {}, tr("Look along the stiffness axis (K)"), SceneDirection::AlongStiffness);
        look({}, u"zoom-fit-best"_s, tr("The whole space from its corner (I)"), SceneDirection::Isometric);
    }
    d->orthographic = toolButton({}, u"grid-axonometric"_s, tr("Orthographic instead of perspective (O)"));
    d->orthographic->setCheckable(true);
    d->orthographic->setVisible(d->view->threeDimensional());
    connect(d->orthographic, &QToolButton::clicked, d->view,
            [this](bool on) { d->view->setOrthographic(on); });
    auto* copy = toolButton({}, u"edit-copy"_s, tr("Copy the picture"));
    auto* save = toolButton({}, u"document-save"_s, tr("Save the picture…"));
    connect(copy, &QToolButton::clicked, this, [this] { copyPicture(); });
    connect(save, &QToolButton::clicked, this, [this] { savePicture(); });
    line->addWidget(d->orthographic);
    line->addSpacing(metrics::step);
    line->addWidget(copy);
    line->addWidget(save);
    return line;
}

QLayout* TypesPage::buildStepBar()
{
    auto* line = new QHBoxLayout;
    line->setContentsMargins(12, 0, 12, 0);
    line->setSpacing(metrics::insideControl);
    d->byTypeButton = makeButton(tr("Types"));
    d->byClusterButton = makeButton(tr("K-means"));
    auto* group = new QButtonGroup(this);
    for (QPushButton* button : {d->byTypeButton, d->byClusterButton}) {
        button->setCheckable(true);
        group->addButton(button);
        line->addWidget(button);
    }
    d->byTypeButton->setChecked(true);
    d->byTypeButton->setToolTip(tr("Colour by type, with the ellipsoid that holds 95 % of its squeezes"));
    d->byClusterButton->setToolTip(tr("Colour by the cluster that K-means finds without knowing the types"));
    d->play = toolButton({}, u"media-playback-start"_s, tr("Play the iterations"));
    d->play->setCheckable(true);
    d->back = toolButton({}, u"go-previous"_s, tr("One iteration back"));
    d->forward = toolButton({}, u"go-next"_s, tr("One iteration on"));
    d->steps = new QSlider(Qt::Horizontal);
    d->steps->setAccessibleName(tr("K-means iteration"));
    d->steps->setPageStep(1);
    d->stepText = makeLabel({}, "second");
    d->stepText->setMinimumWidth(92);
    line->addSpacing(metrics::step);
    for (QWidget* widget : std::initializer_list<QWidget*>{d->play, d->back, d->forward})
        line->addWidget(widget);
    line->addWidget(d->steps, 1);
    line->addSpacing(metrics::step);
    line->addWidget(d->stepText);
    connect(group, &QButtonGroup::buttonClicked, this, [this](QAbstractButton* button) {
        d->byCluster = button == d->byClusterButton;
        play(false);
        refresh();
    });
    connect(d->play, &QToolButton::clicked, this, [this](bool on) { play(on); });
    connect(d->back, &QToolButton::clicked, this, [this] { showStep(d->steps->value() - 1); });
    connect(d->forward, &QToolButton::clicked, this, [this] { showStep(d->steps->value() + 1); });
    connect(d->steps, &QSlider::valueChanged, this, [this](int step) { showStep(step); });
    return line;
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
    if (!active)
        play(false);
    else if (d->stale)
        load();
}

void TypesPage::showPaper(bool paper)
{
    if (d->paper == paper)
        return;
    d->paper = paper;
    d->source->setCurrentIndex(paper ? 1 : 0);
    load();
}

void TypesPage::load()
{
    const int generation = ++d->generation;
    d->loading = true;
    d->stale = false;
    const auto take = [this, generation](TypeSpace space) {
        if (generation != d->generation)
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
    const int generation = ++d->generation;
    d->clustering.reset();
    play(false);
    if (d->space.types.size() < 2) {
        d->side->setClustering(nullptr, tr("Clusters need at least two types."));
        refreshStepBar();
        refresh();
        return;
    }
    workbench().compute<Expected<SpaceClustering>>(
        this,
        [space = d->space, scaling = d->side->scaling(), start = d->side->start()] {
            return clusterTypeSpace(space, scaling, start);
        },
        [this, generation](Expected<SpaceClustering> found) {
            if (generation != d->generation)
                return;
            if (found)
                d->clustering = std::move(*found);
            d->side->setClustering(d->clustering ? &*d->clustering : nullptr,
                                   found ? QString() : found.error().describe());
            refreshStepBar();
            refresh();
        });
}

void TypesPage::refreshStepBar()
{
    const QSignalBlocker quiet(d->steps);
    const int last = std::max(0, stepCount() - 1);
    d->steps->setRange(0, last);
    d->steps->setValue(last);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{d->byClusterButton, d->play, d->back, d->forward, d->steps})
        widget->setEnabled(stepCount() > 0);
    if (stepCount() == 0) {
        d->byCluster = false;
        d->byTypeButton->setChecked(true);
    }
}

void TypesPage::showStep(int step)
{
    if (!d->clustering)
        return;
    const QSignalBlocker quiet(d->steps);
    d->steps->setValue(step);
    d->byCluster = true;
    d->byClusterButton->setChecked(true);
    refresh();
}

void TypesPage::play(bool on)
{
    if (on && d->steps->value() == d->steps->maximum())
        showStep(0);
    on ? d->playing.start() : d->playing.stop();
    d->play->setChecked(on);
    d->play->setIcon(Theme::instance().icon(on ? u"media-playback-pause"_s : u"media-playback-start"_s));
}

void TypesPage::takeInspection()
{
    const auto& result = workbench().inspection().result();
    if (!result || result->number == d->highlightNumber)
        return;
    d->highlightNumber = result->number;
    d->highlight.reset();
    d->highlightText.clear();
    const Estimate* best = result->identification.best();
    const std::optional<double> si = siFactor(result->recording.forceUnit, result->recording.positionUnit);
    if (best && best->parameters && si) {
        const Eigen::Vector3d at = best->parameters->vector() * *si;
        const MassDampingStiffness parameters{at.x(), at.y(), at.z()};
        d->highlightText = tr("Ringed: inspection %1").arg(result->number);
        SceneHighlight highlight{
            {u"inspection"_s, at, 0, 0,
             d->highlightText + u'\n' + parametersText(parameters, parameterUnits(u"N"_s, u"m"_s))},
            std::nullopt};
        if (best->covariance)
            highlight.ellipsoid = estimateEllipsoid(parameters, *best->covariance * (*si * *si), 0.95);
        d->highlight = std::move(highlight);
    }
    refresh();
}

void TypesPage::refresh()
{
    const bool empty = d->space.squeezes.empty() && !d->loading;
    d->stack->setCurrentIndex(empty ? 1 : 0);
    const int step = d->steps->value();
    const bool byCluster = d->byCluster && d->clustering;
    const bool ringed = d->highlight && !d->paper && !byCluster;
    if (d->space.types.size() == qsizetype(d->side->visibility().size()))
        d->view->setContent(
            byCluster ? clusterScene(d->space, d->side->visibility(), *d->clustering, step)
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
    d->back->setEnabled(stepCount() > 0 && step > 0);
    d->forward->setEnabled(stepCount() > 0 && step < d->steps->maximum());
    d->stepText->setText(!d->clustering ? QString()
                         : step == 0    ? tr("start of %1").arg(d->steps->maximum())
                                        : tr("step %1 of %2").arg(step).arg(d->steps->maximum()));
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

void TypesPage::copyPicture()
{
    QGuiApplication::clipboard()->setImage(d->view->picture());
}

void TypesPage::savePicture()
{
    auto* dialog = new QFileDialog(this, tr("Save the picture"), QString(), tr("Pictures (*.png)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(u"png"_s);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, image = d->view->picture()](const QString& file) {
                if (!image.save(file))
                    workbench().report(
                        Error{ErrorCode::FileUnwritable, {file, tr("the picture could not be written")}}
                            .describe());
            });
    dialog->open();
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
