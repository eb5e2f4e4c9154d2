// SPDX-License-Identifier: GPL-3.0-or-later
// The force of a recipe: where its levels come from, and how it looks.
#include "core/base/words.h"
#include "core/signal/recording/units.h"
#include "ui/context/workbench.h"
#include "ui/pages/shared/enroll_recipe_form.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/windows/file_dialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

ForceLevelsRow::ForceLevelsRow(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_file(makeButton(tr("From a file…"), {}, "", this)),
      m_design(makeButton(tr("Optimise"), {}, "", this)), m_says(makeLabel({}, "second", this))
{
    m_file->setObjectName("forceFromFile");
    m_file->setToolTip(
        tr("A table with a column \"force\" in newtons and the times of its rows (time_s), such as a "
           "recording"));
    m_design->setObjectName("forceOptimise");
    m_design->setToolTip(tr("Searches the two-level force that tells the enrolled types apart best, within "
                            "these forces and times"));
    m_says->setObjectName("forceLevels");
    m_says->setWordWrap(true);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 8, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_file);
    row->addWidget(m_design);
    row->addWidget(m_says, 1);
    connect(m_file, &QPushButton::clicked, this, &ForceLevelsRow::chooseFile);
    connect(m_design, &QPushButton::clicked, this, &ForceLevelsRow::design);
}

void ForceLevelsRow::setAllowed(std::function<Recipe()> recipe, std::function<GripperIdentity()> gripper)
{
    m_recipe = std::move(recipe);
    m_gripper = std::move(gripper);
}

void ForceLevelsRow::show(const Recipe& recipe)
{
    constexpr double milliseconds = 1e3;
    m_says->setText(recipe.levels.empty() ? tr("None yet.")
                                          : tr("%1 levels of %2 ms.")
                                                .arg(QLocale().toString(qulonglong(recipe.levels.size())),
                                                     Words::number(milliseconds * recipe.bit_s)));
}

void ForceLevelsRow::chooseFile()
{
    auto* dialog =
        new FileDialog(this, tr("A force to squeeze with"), {}, tr("Tables (*.csv *.txt);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &ForceLevelsRow::open);
    dialog->open();
}

void ForceLevelsRow::open(const QString& file)
{
    m_workbench->background().compute<Expected<ForceLevels>>(
        this,
        [file] {
            return readForceLevels(file).and_then(
                [&](const ForceLevels& force) { return inNewtons(force, file); });
        },
        [this](const Expected<ForceLevels>& force) { take(force, &ForceLevelsRow::read); });
}

void ForceLevelsRow::design()
{
    m_design->setEnabled(false);
    const auto& types = m_workbench->inspection().types();
    const bool si = !types.empty() && siFactor(types.front().forceUnit, types.front().positionUnit);
    m_workbench->background().compute<Expected<ForceLevels>>(
        this,
        [recipe = m_recipe(), gripper = m_gripper(),
         models = si ? m_workbench->inspection().models() : TypeModels{}] {
            return designedForce(recipe, gripper, models);
        },
        [this](const Expected<ForceLevels>& force) {
            m_design->setEnabled(true);
            take(force, &ForceLevelsRow::designed);
        });
}

void ForceLevelsRow::take(const Expected<ForceLevels>& force,
                          void (ForceLevelsRow::*tell)(const ForceLevels&))
{
    if (force)
        emit(this->*tell)(*force);
    else
        m_workbench->messages().report(force.error().describe());
}

ForcePicture::ForcePicture(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Picture of the force"));
    setMinimumHeight(56);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

QSize ForcePicture::sizeHint() const
{
    return {320, 56};
}

void ForcePicture::show(std::vector<double> force_N, double limit_N)
{
    m_force_N = std::move(force_N);
    m_limit_N = limit_N;
    update();
}

void ForcePicture::paintEvent(QPaintEvent*)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    QPainter painter(this);
    painter.setPen(QPen(tokens.line, tokens.lineWidth));
    painter.setBrush(tokens.page);
    const QRect frame = rect().adjusted(0, 0, -1, -1);
    painter.drawRect(frame);
    if (m_force_N.empty() || !(m_limit_N > 0))
        return;
    const double largest = std::max(m_limit_N, *std::max_element(m_force_N.begin(), m_force_N.end()));
    const QRectF inside = QRectF(frame).adjusted(6, 6, -6, -6);
    const auto height = [&](double force_N) { return inside.bottom() - inside.height() * force_N / largest; };
    QPen limit(tokens.notValid, tokens.lineWidth, Qt::DashLine);
    painter.setPen(limit);
    painter.drawLine(QPointF(inside.left(), height(m_limit_N)), QPointF(inside.right(), height(m_limit_N)));
    QPainterPath path(QPointF(inside.left(), height(m_force_N.front())));
    const double step = inside.width() / static_cast<double>(m_force_N.size());
    for (std::size_t i = 0; i < m_force_N.size(); ++i) {
        // The force is held from sample to sample.
        const double y = height(m_force_N[i]);
        path.lineTo(inside.left() + static_cast<double>(i) * step, y);
        path.lineTo(inside.left() + static_cast<double>(i + 1) * step, y);
    }
    painter.setPen(QPen(tokens.force, tokens.lineWidth));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

} // namespace gripscope
