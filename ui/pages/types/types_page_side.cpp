// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/number_format.h"
#include "ui/pages/types/types_page_clusters.h"
#include "ui/pages/types/types_page_parts.h"
#include "ui/scene/scene_marks.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/plain_text.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int listSignSize = 18;

QIcon typeIcon(int type, double ratio)
{
    QPixmap pixmap(QSize(listSignSize, listSignSize) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    drawTypeSign(painter, QPointF(listSignSize, listSignSize) / 2, 6.5, type);
    painter.end();
    return QIcon(pixmap);
}

} // namespace

TypesSide::TypesSide(QWidget* parent)
    : QScrollArea(parent), m_clusters(new ClustersPanel), m_rule(makeRule()), m_legend(new QGridLayout),
      m_spread(makeLabel({}, "second")), m_elsewhere(makeLabel({}, "second")),
      m_highlight(makeLabel({}, "second")), m_picked(makeLabel({}, "second")),
      m_open(makeButton(tr("Open in Fit"), u"labplot-xy-fit-curve"_s)), m_nearest(makeLabel({}))
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* body = new QWidget;
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(2 * metrics::step, 12, 2 * metrics::step, 2 * metrics::step);
    column->setSpacing(metrics::step);
    for (QLabel* label : {m_spread, m_elsewhere, m_highlight, m_picked, m_nearest})
        label->setWordWrap(true);
    m_nearestPart = buildNearest();
    column->addWidget(m_clusters);
    column->addWidget(m_rule);
    column->addWidget(buildTypes());
    column->addWidget(makeRule());
    column->addWidget(buildPicked());
    column->addWidget(m_nearestPart);
    column->addStretch();
    setWidget(body);
    setPicked({}, false);
    setHighlight({});
    showClusters(false);
    connect(m_open, &QPushButton::clicked, this, &TypesSide::openAsked);
    connect(&Theme::instance(), &Theme::changed, this, [this] { refreshLegend(); });
}

QWidget* TypesSide::buildTypes()
{
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    setSpacing(column, 0, metrics::step);
    m_legend->setVerticalSpacing(metrics::step); // a finger finds one, not its neighbour
    m_legend->setHorizontalSpacing(metrics::step);
    m_legend->setColumnStretch(0, 1);
    auto* head = new QHBoxLayout;
    head->addWidget(makeLabel(tr("Types"), "heading"), 1);
    head->addWidget(makeLabel(tr("squeezes"), "caption"), 0, Qt::AlignBottom);
    column->addLayout(head);
    column->addLayout(m_legend);
    QPushButton* manage = makeButton(tr("Manage types…"));
    manage->setObjectName("manageTypesButton");
    manage->setToolTip(tr("Rename, merge, split or retire types; undo changes"));
    connect(manage, &QPushButton::clicked, this, &TypesSide::manageAsked);
    QPushButton* limits = makeButton(tr("Limits…"));
    limits->setObjectName("typeLimitsButton");
    limits->setToolTip(tr("What mass, damping and stiffness of the parts of a type may be"));
    connect(limits, &QPushButton::clicked, this, &TypesSide::limitsAsked);
    auto* actions = new QHBoxLayout;
    actions->setSpacing(8);
    actions->addWidget(manage);
    actions->addWidget(limits);
    actions->addStretch(1);
    column->addLayout(actions);
    column->addWidget(m_spread);
    column->addWidget(m_elsewhere);
    column->addWidget(m_highlight);
    return part;
}

QWidget* TypesSide::buildPicked()
{
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    setSpacing(column, 0, metrics::step);
    column->addWidget(makeLabel(tr("Picked squeeze"), "heading"));
    column->addWidget(m_picked);
    column->addWidget(m_open, 0, Qt::AlignLeft);
    return part;
}

QWidget* TypesSide::buildNearest()
{
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    setSpacing(column, 0, metrics::step);
    column->addWidget(makeRule());
    column->addWidget(makeLabel(tr("Nearest pair"), "heading"));
    column->addWidget(m_nearest);
    return part;
}

void TypesSide::showClusters(bool clusters)
{
    if (clusters == m_showsClusters)
        return;
    m_showsClusters = clusters;
    m_clusters->setVisible(clusters);
    m_rule->setVisible(clusters);
    m_nearestPart->setVisible(!clusters);
    ensureVisible(0, 0);
}

QString elsewhereText(const TypeSpace& space)
{
    QStringList names;
    for (const TypeSpace::Elsewhere& type : space.elsewhere)
        names << u"%1 (%2)"_s.arg(type.name, formatCount(type.squeezes));
    return names.join(u", "_s);
}

void TypesSide::setSpace(const TypeSpace& space)
{
    const bool sameTypes = space.types == m_types;
    const std::vector<bool> before = visibility();
    m_types = space.types;
    m_signs = space.signs;
    while (QLayoutItem* item = m_legend->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_checks.clear();
    for (int type = 0; type < int(space.types.size()); ++type) {
        auto* check = new QCheckBox(withoutKeys(space.types[type]));
        check->setChecked(!sameTypes || before[std::size_t(type)]);
        check->setToolTip(tr("Show or hide %1").arg(space.types[type]));
        auto* count = makeLabel(formatCount(space.counts[std::size_t(type)]), "second");
        m_legend->addWidget(check, type, 0);
        m_legend->addWidget(count, type, 1, Qt::AlignRight | Qt::AlignVCenter);
        m_checks.push_back(check);
        connect(check, &QCheckBox::toggled, this, [this] { emit visibilityChanged(); });
    }
    refreshLegend();
    const bool spreadKnown = space.models.degreesOfFreedom > 0;
    m_spread->setText(tr("With one squeeze a type nothing is known of how squeezes scatter, so there is no "
                         "ellipsoid yet. Enrol more: ten a type is good."));
    m_spread->setVisible(!spreadKnown && !space.types.isEmpty());
    m_elsewhere->setText(tr("Without m, b and k, so not in this picture: %1.").arg(elsewhereText(space)));
    m_elsewhere->setVisible(!space.elsewhere.empty());
    if (space.nearest)
        m_nearest->setText(tr("%1 and %2 are %3 sd apart.")
                               .arg(space.nearest->one, space.nearest->other,
                                    formatNumber(space.nearest->distance, std::nullopt, {}).value));
    else
        m_nearest->setText(tr("Two types with some squeezes each are needed."));
    m_nearest->setToolTip(
        tr("Mahalanobis distance of the two means, in standard deviations of the scatter that all "
           "types share. Below about 4 they overlap."));
    m_clusters->setSpace(space);
}

void TypesSide::refreshLegend()
{
    for (std::size_t i = 0; i < m_checks.size(); ++i) {
        m_checks[i]->setIcon(typeIcon(m_signs[i], devicePixelRatioF()));
        m_checks[i]->setIconSize({listSignSize, listSignSize});
    }
}

void TypesSide::setHighlight(const QString& text)
{
    m_highlight->setText(text);
    m_highlight->setVisible(!text.isEmpty());
}

void TypesSide::setPicked(const QString& text, bool canOpen)
{
    m_picked->setText(text.isEmpty() ? tr("Click a point, or press N for the next one.") : text);
    m_open->setVisible(canOpen);
}

std::vector<bool> TypesSide::visibility() const
{
    std::vector<bool> visible;
    for (const QCheckBox* check : m_checks)
        visible.push_back(check->isChecked());
    return visible;
}

} // namespace gripscope
