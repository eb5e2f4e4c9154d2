// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/types_page_side.h"

#include "ui/models/cluster_table_model.h"
#include "ui/scene/scene_marks.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_format.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int signSize = 18;

QIcon typeIcon(int type, double ratio)
{
    QPixmap pixmap(QSize(signSize, signSize) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    drawTypeSign(painter, QPointF(signSize, signSize) / 2, 6.5, type);
    painter.end();
    return QIcon(pixmap);
}

/// A header whose names end in an ellipsis where the column is narrow (one with a style sheet cuts them at
/// both ends).
class ElidedHeader : public QHeaderView {
public:
    using QHeaderView::QHeaderView;

protected:
    void initStyleOptionForIndex(QStyleOptionHeader* option, int logicalIndex) const override
    {
        QHeaderView::initStyleOptionForIndex(option, logicalIndex);
        constexpr int padding = 6;
        const QFontMetrics strong(Theme::font(metrics::fontSmall, true));
        option->text =
            strong.elidedText(option->text, Qt::ElideRight, sectionSize(logicalIndex) - 2 * padding);
    }
};

} // namespace

TypesSide::TypesSide(QWidget* parent)
    : QScrollArea(parent), m_legend(new QGridLayout), m_highlight(makeLabel({}, "second")),
      m_picked(makeLabel({}, "second")), m_open(makeButton(tr("Open in Fit"), u"labplot-xy-fit-curve"_s)),
      m_nearest(makeLabel({})), m_scaling(new QComboBox), m_start(new QComboBox), m_numbers(new QGridLayout),
      m_randIndex(makeLabel({}, "strong")), m_inertia(makeLabel({}, "strong")),
      m_tableTitle(makeLabel({}, "heading")), m_model(new ClusterTableModel(this)), m_table(new QTableView)
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* body = new QWidget;
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(2 * metrics::step, 12, 2 * metrics::step, 2 * metrics::step);
    column->setSpacing(metrics::step);
    for (QLabel* label : {m_highlight, m_picked, m_nearest})
        label->setWordWrap(true);
    m_legend->setVerticalSpacing(0);
    m_legend->setHorizontalSpacing(metrics::step);
    m_legend->setColumnStretch(0, 1);
    auto* head = new QHBoxLayout;
    head->addWidget(makeLabel(tr("Types"), "heading"), 1);
    head->addWidget(makeLabel(tr("squeezes"), "caption"), 0, Qt::AlignBottom);
    column->addLayout(head);
    column->addLayout(m_legend);
    column->addWidget(m_highlight);
    column->addWidget(makeRule());
    column->addWidget(makeLabel(tr("Picked squeeze"), "heading"));
    column->addWidget(m_picked);
    column->addWidget(m_open, 0, Qt::AlignLeft);
    column->addWidget(makeRule());
    column->addWidget(makeLabel(tr("Nearest pair"), "heading"));
    column->addWidget(m_nearest);
    column->addWidget(makeRule());
    buildClusters(column);
    buildTable(column);
    column->addStretch();
    setWidget(body);
    setPicked({}, false);
    setHighlight({});
    connect(m_open, &QPushButton::clicked, this, &TypesSide::openAsked);
    connect(&Theme::instance(), &Theme::changed, this, [this] { refreshLegend(); });
}

void TypesSide::buildClusters(QVBoxLayout* column)
{
    m_scaling->addItem(tr("raw values"), int(FeatureScaling::None));
    m_scaling->addItem(tr("z-scores"), int(FeatureScaling::ZScore));
    m_scaling->addItem(tr("logarithms"), int(FeatureScaling::Log));
    m_scaling->addItem(tr("z-scores of logs"), int(FeatureScaling::ZLog));
    m_scaling->setCurrentIndex(1);
    m_scaling->setAccessibleName(tr("Scaling of m, b and k before clustering"));
    m_scaling->setToolTip(tr("How m, b and k are scaled before K-means compares them"));
    constexpr int randomStarts = 9;
    m_start->addItem(tr("best of 10 starts"));
    for (int n = 1; n <= randomStarts; ++n)
        m_start->addItem(tr("random start %1").arg(n));
    m_start->setAccessibleName(tr("Where K-means starts"));
    m_start->setToolTip(tr("A single random start takes more steps and may end in the wrong clusters"));
    m_numbers->setHorizontalSpacing(metrics::step);
    m_numbers->setVerticalSpacing(4);
    m_numbers->setColumnStretch(0, 1);
    const auto row = [this](int at, const QString& name, QLabel* value, const QString& tip) {
        auto* label = makeLabel(name, "second");
        label->setToolTip(tip);
        value->setToolTip(tip);
        m_numbers->addWidget(label, at, 0);
        m_numbers->addWidget(value, at, 1, Qt::AlignRight);
    };
    row(0, tr("Adjusted Rand index"), m_randIndex,
        tr("1: the clusters are the types; about 0: no better than chance"));
    row(1, tr("Inertia"), m_inertia, tr("Sum of squared distances to the own centroid, in the scaled space"));
    column->addWidget(makeLabel(tr("K-means, without labels"), "heading"));
    column->addWidget(m_scaling);
    column->addWidget(m_start);
    column->addLayout(m_numbers);
    for (const QComboBox* box : {m_scaling, m_start})
        connect(box, &QComboBox::currentIndexChanged, this, [this] { emit clusteringAsked(); });
}

void TypesSide::buildTable(QVBoxLayout* column)
{
    m_table->setHorizontalHeader(new ElidedHeader(Qt::Horizontal));
    m_table->setModel(m_model);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setTabKeyNavigation(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setMinimumSectionSize(24);
    m_table->horizontalHeader()->setTextElideMode(Qt::ElideRight);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->verticalHeader()->setDefaultSectionSize(24);
    m_table->verticalHeader()->setMinimumSectionSize(20);
    m_table->setStyleSheet(u"QTableView::item { padding: 0; } QHeaderView::section { padding: 2px; }"_s);
    m_table->setAccessibleName(tr("Types against clusters: the cluster that each squeeze fell into"));
    m_tableTitle->setWordWrap(true);
    column->addWidget(makeRule());
    column->addWidget(m_tableTitle);
    column->addWidget(m_table);
}

void TypesSide::setSpace(const TypeSpace& space)
{
    const bool sameTypes = space.types == m_space.types;
    const std::vector<bool> before = visibility();
    m_space = space;
    while (QLayoutItem* item = m_legend->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_checks.clear();
    for (int type = 0; type < int(space.types.size()); ++type) {
        auto* check = new QCheckBox(space.types[type]);
        check->setChecked(!sameTypes || before[std::size_t(type)]);
        check->setToolTip(tr("Show or hide %1").arg(space.types[type]));
        auto* count = makeLabel(formatCount(space.counts[std::size_t(type)]), "second");
        m_legend->addWidget(check, type, 0);
        m_legend->addWidget(count, type, 1, Qt::AlignRight | Qt::AlignVCenter);
        m_checks.push_back(check);
        connect(check, &QCheckBox::toggled, this, [this] { emit visibilityChanged(); });
    }
    refreshLegend();
    if (space.nearest)
        m_nearest->setText(tr("%1 and %2 are %3 sd apart.")
                               .arg(space.types[space.nearest->one], space.types[space.nearest->other],
                                    formatNumber(space.nearest->distance, std::nullopt, {}).value));
    else
        m_nearest->setText(tr("Two types with some squeezes each are needed."));
    m_nearest->setToolTip(
        tr("Mahalanobis distance of the two means, in standard deviations of the scatter that all "
           "types share. Below about 4 they overlap."));
    m_tableTitle->setText(space.paper ? tr("Table 1: types against clusters") : tr("Types against clusters"));
}

void TypesSide::refreshLegend()
{
    for (std::size_t i = 0; i < m_checks.size(); ++i) {
        m_checks[i]->setIcon(typeIcon(int(i), devicePixelRatioF()));
        m_checks[i]->setIconSize({signSize, signSize});
    }
}

void TypesSide::setClustering(const SpaceClustering* clustering, const QString& reason)
{
    if (!clustering) {
        const QString dash(QChar(0x2013));
        m_randIndex->setText(dash);
        m_inertia->setText(dash);
        m_randIndex->setToolTip(reason);
        m_model->setTable({}, {});
        m_table->hide();
        m_tableTitle->hide();
        return;
    }
    m_randIndex->setText(QLocale().toString(clustering->agreement.adjustedRandIndex, 'f', 3));
    m_inertia->setText(QLocale().toString(clustering->result.inertia, 'g', 6));
    m_model->setTable(clustering->agreement.truths, clustering->table);
    m_table->show();
    m_tableTitle->show();
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() + 24 * m_model->rowCount() + 4);
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

int TypesSide::start() const
{
    return m_start->currentIndex();
}

FeatureScaling TypesSide::scaling() const
{
    return FeatureScaling(m_scaling->currentData().toInt());
}

} // namespace gripscope
