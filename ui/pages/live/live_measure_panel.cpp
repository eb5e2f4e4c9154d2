// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/live_marker_model.h"
#include "ui/pages/live/live_pause.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/tool_button.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QSignalBlocker>
#include <QTableView>

#include <algorithm>
#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QLabel* makeReading(const char* id, const QString& name, QWidget* parent)
{
    QLabel* label = makeLabel(u"–"_s, "strong", parent);
    label->setObjectName(QString::fromLatin1(id));
    label->setAccessibleName(name);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

LiveMeasurePanel::LiveMeasurePanel(LiveMarkerModel& markers, QWidget* parent)
    : QFrame(parent), m_markers(&markers)
{
    setRole(this, "card");
    setObjectName("liveMeasure");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 8, 16, 8);
    row->setSpacing(16);
    row->addWidget(buildReadout());
    row->addWidget(buildSide(), 1);
}

QWidget* LiveMeasurePanel::buildReadout()
{
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(4);
    const auto caption = [&](const QString& text, int column) {
        QLabel* label = makeLabel(text, "caption", this);
        label->setAlignment(Qt::AlignRight);
        grid->addWidget(label, 0, column);
    };
    caption(tr("Time"), 1);
    caption(tr("Force"), 2);
    caption(tr("Position"), 3);
    addCursor(grid, 0);
    addCursor(grid, 1);
    grid->addWidget(makeLabel(tr("B − A"), "strong", this), 3, 0);
    m_timeBetween = makeReading("timeBetween", tr("Time from A to B"), this);
    m_forceBetween = makeReading("forceBetween", tr("Change of force from A to B"), this);
    m_positionBetween = makeReading("positionBetween", tr("Change of position from A to B"), this);
    grid->addWidget(m_timeBetween, 3, 1);
    grid->addWidget(m_forceBetween, 3, 2);
    grid->addWidget(m_positionBetween, 3, 3);
    m_slope = makeReading("slopeBetween", tr("Slope: change of force over change of position"), this);
    m_slope->setToolTip(tr("The stiffness, where the part is at rest at A and at B; while it moves, mass and "
                           "damping are in it too"));
    QLabel* slope = makeLabel(tr("Slope dF/dx"), "second", this);
    grid->addWidget(slope, 4, 0, 1, 2);
    grid->addWidget(m_slope, 4, 2, 1, 2);
    grid->setColumnMinimumWidth(2, 96);
    grid->setColumnMinimumWidth(3, 120);
    grid->setRowStretch(5, 1);
    return box;
}

void LiveMeasurePanel::addCursor(QGridLayout* grid, int cursor)
{
    const auto which = static_cast<std::size_t>(cursor);
    const QString name = cursor == 0 ? tr("A") : tr("B");
    auto* time = new QDoubleSpinBox(this);
    time->setObjectName(cursor == 0 ? u"cursorA"_s : u"cursorB"_s);
    time->setAccessibleName(tr("Time of cursor %1, seconds").arg(name));
    time->setToolTip(cursor == 0 ? tr("Cursor A: drag it, or Shift and the arrows in a chart")
                                 : tr("Cursor B: drag it, or Ctrl and the arrows in a chart"));
    time->setSuffix(tr(" s"));
    time->setDecimals(4);
    time->setAlignment(Qt::AlignRight);
    time->setKeyboardTracking(false);
    time->setMinimumWidth(144);
    connect(time, &QDoubleSpinBox::valueChanged, this,
            [this, cursor](double value) { emit cursorSet(cursor, value); });
    m_times[which] = time;
    m_forces[which] =
        makeReading(cursor == 0 ? "forceA" : "forceB", tr("Force at cursor %1").arg(name), this);
    m_positions[which] =
        makeReading(cursor == 0 ? "positionA" : "positionB", tr("Position at cursor %1").arg(name), this);
    grid->addWidget(makeLabel(name, "strong", this), cursor + 1, 0);
    grid->addWidget(time, cursor + 1, 1);
    grid->addWidget(m_forces[which], cursor + 1, 2);
    grid->addWidget(m_positions[which], cursor + 1, 3);
}

QWidget* LiveMeasurePanel::buildSide()
{
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    setSpacing(column, 0, 8);
    auto* tools = new QHBoxLayout;
    setSpacing(tools, 0, 4);
    const auto tool = [&](const char* id, const QString& icon, const QString& name, auto asked) {
        QToolButton* button = makeToolButton({}, icon, name);
        button->setObjectName(QString::fromLatin1(id));
        connect(button, &QToolButton::clicked, this, asked);
        tools->addWidget(button);
    };
    tool("zoomIn", u"zoom-in"_s, tr("Show less time (+)"), [this] { emit zoomAsked(2); });
    tool("zoomOut", u"zoom-out"_s, tr("Show more time (−)"), [this] { emit zoomAsked(0.5); });
    tool("earlier", u"go-previous"_s, tr("Earlier (left arrow)"), [this] { emit panAsked(-0.25); });
    tool("later", u"go-next"_s, tr("Later (right arrow)"), [this] { emit panAsked(0.25); });
    tool("whole", u"zoom-original"_s, tr("All as it was paused (Home)"), [this] { emit resetAsked(); });
    tool("cursors", u"crosshairs"_s, tr("Cursors into view"), [this] { emit cursorsAsked(); });
    tools->addStretch(1);
    m_save = makeButton(tr("Save…"), u"document-save"_s, "", this);
    m_save->setObjectName("saveView");
    m_save->setToolTip(tr("Saves what is in view as a recording (CSV), as far as it is kept sample by "
                          "sample: the last minute"));
    connect(m_save, &QPushButton::clicked, this, &LiveMeasurePanel::saveAsked);
    tools->addWidget(m_save);
    column->addLayout(tools);

    m_table = new QTableView(this);
    m_table->setObjectName("markerList");
    m_table->setAccessibleName(tr("Markers"));
    m_table->setModel(m_markers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(metrics::touchTarget);
    m_table->horizontalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setColumnWidth(static_cast<int>(LiveMarkerModel::Column::Number), 48);
    m_table->setColumnWidth(static_cast<int>(LiveMarkerModel::Column::When), 112);
    m_table->setShowGrid(false);
    m_table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored); // the readout says how high
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                             QAbstractItemView::SelectedClicked);
    m_table->setToolTip(tr("Markers (M drops one); a double click on the words changes them"));
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) {
                if (now.isValid())
                    emit markerChosen(now.row());
            });
    auto* list = new QHBoxLayout;
    setSpacing(list, 0, 4);
    list->addWidget(m_table, 1);
    m_remove = makeToolButton({}, u"edit-delete"_s, tr("Remove the selected markers"));
    m_remove->setObjectName("removeMarker");
    list->addWidget(m_remove, 0, Qt::AlignTop);
    connect(m_remove, &QToolButton::clicked, this, &LiveMeasurePanel::removeMarkers);
    const auto offerRemoval = [this] { m_remove->setEnabled(m_table->selectionModel()->hasSelection()); };
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, offerRemoval);
    offerRemoval();
    column->addLayout(list, 1);
    return side;
}

void LiveMeasurePanel::removeMarkers()
{
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    std::vector<int> numbers;
    for (const QModelIndex& index : rows)
        numbers.push_back(index.row());
    std::sort(numbers.rbegin(), numbers.rend()); // the last first: the others stay where they are
    for (const int row : numbers)
        m_markers->remove(row);
}

void LiveMeasurePanel::setTimes(double oldest_s, double step_s)
{
    for (QDoubleSpinBox* time : m_times) {
        const QSignalBlocker quiet(time);
        time->setRange(oldest_s, 0);
        time->setSingleStep(step_s);
    }
}

void LiveMeasurePanel::setSaving(bool on)
{
    m_save->setEnabled(!on);
    m_save->setText(on ? tr("Saving…") : tr("Save…"));
}

void LiveMeasurePanel::show(const Readout& readout)
{
    for (std::size_t i = 0; i < m_times.size(); ++i) {
        const QSignalBlocker quiet(m_times[i]);
        m_times[i]->setValue(readout.cursors[i].time_s);
        m_forces[i]->setText(readout.cursors[i].force);
        m_positions[i]->setText(readout.cursors[i].position);
    }
    m_timeBetween->setText(readout.time);
    m_forceBetween->setText(readout.force);
    m_positionBetween->setText(readout.position);
    m_slope->setText(readout.slope);
}

} // namespace gripscope
