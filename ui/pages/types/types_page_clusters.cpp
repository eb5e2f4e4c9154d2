// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/types/types_page_clusters.h"

#include "ui/charts/heat_map.h"
#include "ui/models/cluster_models.h"
#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr int rowHeight = 24;
constexpr int mostClusters = 100; ///< as many as types that verdicts are promised for

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
        option->text = elided(strong, option->text, sectionSize(logicalIndex) - 2 * padding);
    }
};

/// A method as the page offers it.
struct Method {
    ClusterMethod method;
    MixtureCovariance covariance;
};
constexpr Method methods[] = {{ClusterMethod::KMeans, MixtureCovariance::Full},
                              {ClusterMethod::GaussianMixture, MixtureCovariance::Tied},
                              {ClusterMethod::GaussianMixture, MixtureCovariance::Full},
                              {ClusterMethod::SelfOrganizingMap, MixtureCovariance::Full}};

} // namespace

ClustersPanel::ClustersPanel(QWidget* parent)
    : QWidget(parent), m_method(new QComboBox), m_clusters(new QSpinBox), m_scaling(new QComboBox),
      m_start(new QComboBox), m_running(makeLabel(tr("Grouping the squeezes…"), "second")),
      m_cancel(makeButton(tr("Cancel"))), m_reason(makeLabel({}, "second")), m_numbers(new QGridLayout),
      m_advice(new AdvicePanel), m_map(new MapPanel), m_tableTitle(makeLabel({}, "heading")),
      m_trials(new ClusterTableModel(this)), m_counts(new ClusterCountsModel(this)), m_table(new QTableView)
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::step);
    buildChoices();
    buildTables();
    m_reason->setWordWrap(true);
    m_reason->setObjectName(u"clusterReason"_s);
    column->addWidget(makeLabel(tr("Clusters, without labels"), "heading"));
    column->addWidget(m_method);
    column->addWidget(buildClusterCount());
    column->addWidget(m_scaling);
    column->addWidget(m_start);
    column->addWidget(m_running);
    column->addWidget(m_cancel, 0, Qt::AlignLeft);
    column->addWidget(m_reason);
    column->addLayout(m_numbers);
    column->addWidget(m_map);
    column->addWidget(m_tableTitle);
    column->addWidget(m_table);
    column->addWidget(makeRule());
    column->addWidget(m_advice);
    m_runningSoon.setSingleShot(true);
    m_runningSoon.setInterval(300ms); // what is done sooner is not worth a change of the panel
    connect(&m_runningSoon, &QTimer::timeout, this, [this] { showRunning(true); });
    showRunning(false);
    refreshChoices();
    connect(m_cancel, &QPushButton::clicked, this, &ClustersPanel::cancelled);
    connect(m_advice, &AdvicePanel::chosen, this, &ClustersPanel::setClusters);
    connect(m_method, &QComboBox::currentIndexChanged, this, [this] {
        refreshChoices();
        emit asked();
    });
    connect(m_start, &QComboBox::currentIndexChanged, this, &ClustersPanel::asked);
    connect(m_clusters, &QSpinBox::valueChanged, this, &ClustersPanel::asked);
    connect(m_scaling, &QComboBox::currentIndexChanged, this, [this] {
        emit scalingChanged();
        emit asked();
    });
}

void ClustersPanel::buildChoices()
{
    m_method->setObjectName(u"clusterMethod"_s);
    m_method->addItems({tr("K-means"), tr("Gaussian mixture, tied"), tr("Gaussian mixture, full"),
                        tr("Self-organizing map")});
    const QStringList meanings{tr("Round clusters of like size: each squeeze goes to the nearest centre"),
                               tr("Clusters of one shape, which all share: wiser with few squeezes"),
                               tr("Every cluster has a shape, a size and a share of its own"),
                               tr("Kohonen's map: a net of units that spreads over the squeezes; units that "
                                  "are alike are then merged")};
    for (int i = 0; i < m_method->count(); ++i)
        m_method->setItemData(i, meanings[i], Qt::ToolTipRole);
    m_method->setAccessibleName(tr("Method of clustering"));
    m_scaling->setObjectName(u"clusterScaling"_s);
    m_scaling->addItem(tr("raw values"), int(FeatureScaling::None));
    m_scaling->addItem(tr("z-scores"), int(FeatureScaling::ZScore));
    m_scaling->addItem(tr("logarithms"), int(FeatureScaling::Log));
    m_scaling->addItem(tr("z-scores of logs"), int(FeatureScaling::ZLog));
    m_scaling->setCurrentIndex(1);
    m_scaling->setAccessibleName(tr("Scaling of m, b and k before clustering"));
    m_scaling->setToolTip(tr("How m, b and k are scaled before squeezes are compared"));
    constexpr int randomStarts = 9;
    m_start->addItem(tr("best of 10 starts"));
    for (int n = 1; n <= randomStarts; ++n)
        m_start->addItem(tr("random start %1").arg(n));
    m_start->setAccessibleName(tr("Where the method starts"));
    m_numbers->setHorizontalSpacing(metrics::step);
    m_numbers->setVerticalSpacing(metrics::insideControl);
    m_numbers->setColumnStretch(0, 1);
}

QWidget* ClustersPanel::buildClusterCount()
{
    m_clusters->setObjectName(u"clusterCount"_s);
    m_clusters->setRange(1, mostClusters);
    m_clusters->setValue(4);
    m_clusters->setAccessibleName(tr("Number of clusters"));
    m_clusters->setKeyboardTracking(false);
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    setSpacing(line, 0, metrics::step);
    line->addWidget(makeLabel(tr("Number of clusters K"), "second"), 1);
    line->addWidget(m_clusters);
    return row;
}

void ClustersPanel::buildTables()
{
    m_table->setHorizontalHeader(new ElidedHeader(Qt::Horizontal));
    m_table->setModel(m_trials);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setTabKeyNavigation(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setMinimumSectionSize(20);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->verticalHeader()->setDefaultSectionSize(rowHeight);
    m_table->verticalHeader()->setMinimumSectionSize(20);
    m_table->setStyleSheet(u"QTableView::item { padding: 0; } QHeaderView::section { padding: 2px; }"_s);
    m_table->setAccessibleName(tr("Types against clusters"));
    m_tableTitle->setWordWrap(true);
}

void ClustersPanel::setSpace(const TypeSpace& space)
{
    if (space.types == m_types)
        return;
    m_types = space.types;
    const QSignalBlocker quiet(m_clusters);
    m_clusters->setValue(clusterRequest(space).clusters);
}

void ClustersPanel::setClusters(int clusters)
{
    m_clusters->setValue(clusters);
}

void ClustersPanel::setMethod(ClusterMethod method, MixtureCovariance covariance)
{
    for (int i = 0; i < int(std::size(methods)); ++i)
        if (methods[i].method == method &&
            (method != ClusterMethod::GaussianMixture || methods[i].covariance == covariance))
            m_method->setCurrentIndex(i);
}

ClusterRequest ClustersPanel::request() const
{
    const Method& method = methods[m_method->currentIndex()];
    ClusterRequest request;
    request.method = method.method;
    request.covariance = method.covariance;
    request.scaling = FeatureScaling(m_scaling->currentData().toInt());
    request.clusters = m_clusters->value();
    // The first start of a map is not a random one, so a single start would always be that.
    if (const int start = m_start->currentIndex();
        start > 0 && method.method != ClusterMethod::SelfOrganizingMap) {
        request.restarts = 1;
        request.candidates = 1;
        request.seed = std::uint64_t(start);
    }
    return request;
}

void ClustersPanel::refreshChoices()
{
    m_method->setToolTip(m_method->currentData(Qt::ToolTipRole).toString());
    const bool map = methods[m_method->currentIndex()].method == ClusterMethod::SelfOrganizingMap;
    m_start->setEnabled(!map);
    m_start->setToolTip(
        map ? tr("A map starts from the plane of the two widest directions, and from 9 random "
                 "draws; the best is kept")
            : tr("A single random start takes more steps and may end in the wrong clusters"));
}

void ClustersPanel::setRunning(bool running)
{
    if (running) {
        m_runningSoon.start();
        return;
    }
    m_runningSoon.stop();
    showRunning(false);
}

void ClustersPanel::showRunning(bool running)
{
    m_running->setVisible(running);
    m_cancel->setVisible(running);
}

void ClustersPanel::setClustering(const TypeSpace& space, const SpaceClustering* clustering,
                                  const QString& reason)
{
    m_reason->setText(reason);
    m_reason->setVisible(!reason.isEmpty());
    while (QLayoutItem* item = m_numbers->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    if (clustering)
        showNumbers(*clustering);
    const MapPlanes planes = clustering ? mapPlanes(space, *clustering) : MapPlanes{};
    m_map->setMap(planes);
    m_map->setVisible(!planes.planes.empty());
    showTable(space, clustering);
}

void ClustersPanel::addNumber(const QString& name, const QString& value, const QString& tip)
{
    auto* label = makeLabel(name, "second");
    auto* number = makeLabel(value, "strong");
    const int row = m_numbers->rowCount();
    for (QLabel* one : {label, number})
        one->setToolTip(tip);
    m_numbers->addWidget(label, row, 0);
    m_numbers->addWidget(number, row, 1, Qt::AlignRight);
}

void ClustersPanel::showNumbers(const SpaceClustering& clustering)
{
    const QLocale locale;
    addNumber(tr("Adjusted Rand index"),
              clustering.randIndex ? locale.toString(*clustering.randIndex, 'f', 3) : QString(QChar(0x2013)),
              clustering.randIndex ? tr("1: the clusters are the types; about 0: no better than chance")
                                   : tr("With a single type there is nothing to agree with"));
    if (const auto* map = std::get_if<SelfOrganizingMapResult>(&clustering.outcome.details)) {
        addNumber(tr("Map"), tr("%1 × %2 units").arg(map->rows).arg(map->columns),
                  tr("About 5 times the square root of the squeezes"));
        addNumber(tr("Quantisation error"), locale.toString(map->quantizationError, 'g', 3),
                  tr("Mean distance of a squeeze from its unit, in the scaled space"));
        addNumber(
            tr("Topographic error"), locale.toString(100 * map->topographicError, 'f', 1) + u" %"_s,
            tr("Share of the squeezes whose two nearest units are no neighbours; over a tenth or so the "
               "net is folded"));
        return;
    }
    if (const auto* mixture = std::get_if<GaussianMixtureResult>(&clustering.outcome.details)) {
        addNumber(tr("Log-likelihood"), locale.toString(mixture->logLikelihood, 'f', 1),
                  tr("Of all squeezes under the mixture, in the scaled space"));
        addNumber(tr("BIC"), locale.toString(mixture->bic, 'f', 1),
                  tr("Likelihood less a price for each parameter: the lower, the better"));
    }
    addNumber(tr("Inertia"), locale.toString(clustering.outcome.inertia, 'g', 6),
              tr("Sum of squared distances to the own centre, in the scaled space"));
}

void ClustersPanel::showTable(const TypeSpace& space, const SpaceClustering* clustering)
{
    const bool trials = clustering && !clustering->table.empty();
    m_trials->setTable(trials ? clustering->agreement.truths : QStringList(),
                       trials ? clustering->table : std::vector<std::vector<int>>());
    m_counts->setAgreement(clustering && !trials ? clustering->agreement : ClusterAgreement{});
    QAbstractItemModel* model = m_counts;
    if (trials)
        model = m_trials;
    if (m_table->model() != model)
        m_table->setModel(model);
    m_tableTitle->setText(space.paper ? tr("Table 1: types against clusters") : tr("Types against clusters"));
    m_tableTitle->setToolTip(trials ? tr("A column a type, a row a squeeze, in each cell its cluster")
                                    : tr("A row a type, a column a cluster, in each cell how many squeezes"));
    m_table->setVisible(clustering != nullptr);
    m_tableTitle->setVisible(clustering != nullptr);
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() + rowHeight * model->rowCount() +
                            4);
}

} // namespace gripscope
