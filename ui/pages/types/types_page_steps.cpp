// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/types/types_page_parts.h"
#include "ui/scene/scene_view.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/narrow_choice.h"
#include "ui/widgets/tool_button.h"
#include "ui/windows/file_dialog.h"

#include <QAbstractItemView>
#include <QButtonGroup>
#include <QClipboard>
#include <QComboBox>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <QSlider>

#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

using namespace std::chrono_literals;

StepBar::StepBar(QWidget* parent)
    : QWidget(parent), m_types(makeButton(tr("Types"))), m_clusters(makeButton(tr("Clusters"))),
      m_play(makeToolButton({}, u"media-playback-start"_s, tr("Play the iterations"))),
      m_back(makeToolButton({}, u"go-previous"_s, tr("One iteration back"))),
      m_forward(makeToolButton({}, u"go-next"_s, tr("One iteration on"))),
      m_slider(new QSlider(Qt::Horizontal)), m_text(makeLabel({}, "second")),
      m_figure(makeLabel({}, "caption"))
{
    m_types->setToolTip(tr("Colour by type, with the ellipsoid that holds 95 % of its squeezes"));
    m_clusters->setToolTip(tr("Colour by the clusters that are found without knowing the types"));
    auto* group = new QButtonGroup(this);
    for (QPushButton* button : {m_types, m_clusters}) {
        button->setCheckable(true);
        group->addButton(button);
    }
    m_types->setChecked(true);
    m_play->setCheckable(true);
    m_slider->setAccessibleName(tr("Iteration of the method"));
    m_slider->setPageStep(1);
    m_types->setObjectName(u"byType"_s);
    m_clusters->setObjectName(u"byCluster"_s);
    constexpr int textWidth = 140; // "quantisation error 0.412"
    m_text->setMinimumWidth(textWidth);
    auto* texts = new QVBoxLayout;
    texts->setSpacing(0);
    texts->addWidget(m_text);
    texts->addWidget(m_figure);
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(12, 0, 12, 0);
    line->setSpacing(metrics::insideControl);
    line->addWidget(m_types);
    line->addWidget(m_clusters);
    line->addSpacing(metrics::step);
    for (QToolButton* button : {m_play, m_back, m_forward})
        line->addWidget(button);
    line->addWidget(m_slider, 8);
    line->addStretch(1); // keeps the rest to the left while the slider is away
    line->addSpacing(metrics::step);
    line->addLayout(texts);

    m_playing.setInterval(700ms);
    connect(&m_playing, &QTimer::timeout, this,
            [this] { step() + 1 < m_count ? goTo(step() + 1) : play(false); });
    connect(group, &QButtonGroup::buttonClicked, this,
            [this](QAbstractButton* button) { showClusters(button == m_clusters); });
    connect(m_play, &QToolButton::clicked, this, [this](bool on) { play(on); });
    connect(m_back, &QToolButton::clicked, this, [this] { goTo(step() - 1); });
    connect(m_forward, &QToolButton::clicked, this, [this] { goTo(step() + 1); });
    connect(m_slider, &QSlider::valueChanged, this, [this](int at) { goTo(at); });
    refresh();
}

int StepBar::step() const
{
    return m_slider->value();
}

void StepBar::setCount(int count)
{
    play(false);
    m_count = count;
    const QSignalBlocker quiet(m_slider);
    m_slider->setRange(0, std::max(0, count - 1));
    m_slider->setValue(m_slider->maximum());
    m_figure->clear();
    refresh();
}

void StepBar::setFigure(const QString& text)
{
    m_figure->setText(text);
}

void StepBar::showClusters(bool clusters)
{
    m_byCluster = clusters;
    (clusters ? m_clusters : m_types)->setChecked(true);
    play(false);
    refresh();
    emit changed();
}

void StepBar::goTo(int step)
{
    if (m_count == 0)
        return;
    {
        const QSignalBlocker quiet(m_slider);
        m_slider->setValue(step);
    }
    m_byCluster = true;
    m_clusters->setChecked(true);
    refresh();
    emit changed();
}

void StepBar::play(bool on)
{
    if (on && step() + 1 >= m_count)
        goTo(0);
    on ? m_playing.start() : m_playing.stop();
    m_play->setChecked(on);
    m_play->setIcon(Theme::instance().icon(on ? u"media-playback-pause"_s : u"media-playback-start"_s));
}

void StepBar::refresh()
{
    for (QWidget* widget : std::initializer_list<QWidget*>{m_play, m_back, m_forward, m_slider, m_text})
        widget->setVisible(m_byCluster); // types have no iterations
    for (QWidget* widget : std::initializer_list<QWidget*>{m_play, m_slider})
        widget->setEnabled(m_count > 1);
    m_back->setEnabled(step() > 0);
    m_forward->setEnabled(step() + 1 < m_count);
    const int last = m_slider->maximum();
    m_figure->setVisible(m_byCluster && m_count > 0);
    m_text->setText(m_count == 0  ? QString()
                    : step() == 0 ? tr("start of %1").arg(last)
                                  : tr("step %1 of %2").arg(step()).arg(last));
}

SceneToolBar::SceneToolBar(SceneView* view, FitExporter* exporter, QWidget* parent)
    : QWidget(parent), m_view(view), m_source(new NarrowChoice(1))
{
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(12, 0, 12, 0);
    line->setSpacing(metrics::insideControl);
    m_source->addItems({tr("This library"), tr("The paper's tables (units as printed)")});
    m_source->setAccessibleName(tr("Which types to show"));
    // In the least window each tool needs its room: there are no icons, and only the first entry is whole
    // there.
    const QFontMetricsF letters(Theme::font(metrics::fontBase));
    m_source->setIconSize({});
    m_source->setMinimumContentsLength(
        int(std::ceil(letters.horizontalAdvance(m_source->itemText(0)) / letters.horizontalAdvance(u'X'))));
    m_source->view()->setMinimumWidth(300);
    connect(m_source, &QComboBox::currentIndexChanged, this,
            [this](int index) { emit paperAsked(index == 1); });
    line->addWidget(m_source, 1);
    line->addStretch(1);
    if (view->threeDimensional()) {
        const auto look = [this, line](const QString& text, const QString& icon, const QString& tip,
                                       SceneDirection where) {
            auto* button = makeToolButton(text, icon, tip);
            connect(button, &QToolButton::clicked, m_view, [this, where] { m_view->lookAlong(where); });
            line->addWidget(button);
        };
        line->addWidget(makeLabel(tr("View along"), "second"));
        look(u"m"_s, {}, tr("Look along the mass axis (M)"), SceneDirection::AlongMass);
        look(u"b"_s, {}, tr("Look along the damping axis (B)"), SceneDirection::AlongDamping);
        look(u"k"_s, {}, tr("Look along the stiffness axis (K)"), SceneDirection::AlongStiffness);
        look({}, u"zoom-fit-best"_s, tr("The whole space from its corner (I)"), SceneDirection::Isometric);
        m_orthographic =
            makeToolButton({}, u"grid-axonometric"_s, tr("Orthographic instead of perspective (O)"));
        m_orthographic->setCheckable(true);
        connect(m_orthographic, &QToolButton::clicked, view, [view](bool on) { view->setOrthographic(on); });
        connect(view, &SceneView::cameraChanged, this,
                [this] { m_orthographic->setChecked(m_view->orthographic()); });
        line->addWidget(m_orthographic);
        line->addSpacing(metrics::step);
    }
    auto* copy = makeToolButton({}, u"edit-copy"_s, tr("Copy the picture"));
    auto* save = makeToolButton({}, u"document-save"_s, tr("Save the picture…"));
    connect(copy, &QToolButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setImage(m_view->picture()); });
    auto* menu = new QMenu(save);
    menu->addAction(tr("Picture as it is rendered, as PNG…"), this, [this] { savePicture(); });
    menu->addSeparator();
    exporter->fillFigure(menu, view);
    save->setMenu(menu);
    save->setPopupMode(QToolButton::InstantPopup);
    save->setObjectName("saveScene");
    line->addWidget(copy);
    line->addWidget(save);
}

void SceneToolBar::setPaper(bool paper)
{
    m_source->setCurrentIndex(paper ? 1 : 0);
}

void SceneToolBar::savePicture()
{
    auto* dialog = new FileDialog(this, tr("Save the picture"), QString(), tr("Pictures (*.png)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(u"png"_s);
    connect(dialog, &QFileDialog::fileSelected, this, [this, image = m_view->picture()](const QString& file) {
        if (!image.save(file))
            emit failed(
                Error{ErrorCode::FileUnwritable, {file, tr("the picture could not be written")}}.describe());
    });
    dialog->open();
}

} // namespace gripscope
