// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/types_page_tools.h"

#include "core/error.h"
#include "ui/scene/scene_view.h"
#include "ui/theme/theme.h"
#include "ui/widgets/tool_button.h"

#include <QAbstractItemView>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

SceneToolBar::SceneToolBar(SceneView* view, QWidget* parent)
    : QWidget(parent), m_view(view), m_source(new QComboBox)
{
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(12, 0, 12, 0);
    line->setSpacing(metrics::insideControl);
    m_source->addItems({tr("This library"), tr("The paper's tables (units as printed)")});
    m_source->setAccessibleName(tr("Which types to show"));
    m_source->setMinimumContentsLength(12);
    m_source->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
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
    connect(save, &QToolButton::clicked, this, [this] { savePicture(); });
    line->addWidget(copy);
    line->addWidget(save);
}

void SceneToolBar::setPaper(bool paper)
{
    m_source->setCurrentIndex(paper ? 1 : 0);
}

void SceneToolBar::savePicture()
{
    auto* dialog = new QFileDialog(this, tr("Save the picture"), QString(), tr("Pictures (*.png)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
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
