// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/workbench.h"
#include "ui/pages/calibrate/calibrate_parts.h"
#include "ui/pages/calibrate/gripper_step.h"
#include "ui/pages/calibrate/gripper_texts.h"
#include "ui/pages/fit/fit_page_table.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <array>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {
constexpr std::size_t gripperSteps = 3;
/// Of how a gripper came to be known as it is.
constexpr int mostChainMeasurements = 500;
} // namespace

struct CalibrateGripper::Private {
    explicit Private(Workbench& workbench) : bench(workbench) {}

    Workbench& bench;
    QTabBar* steps = nullptr;
    QStackedWidget* stack = nullptr;
    EmptyGripperStep* empty = nullptr;
    std::array<GripperStep*, gripperSteps> all{};
    std::array<QLabel*, gripperSteps> when{};
    std::array<QGridLayout*, gripperSteps> facts{};
    std::vector<MeasuringChainRecord> measurements; ///< newest first, of `measuredOf`
    QString measuredOf;
    QLabel* meaning = nullptr;
    QPushButton* remove = nullptr;

    [[nodiscard]] GripperStep* step() const { return all[static_cast<std::size_t>(stack->currentIndex())]; }
    [[nodiscard]] bool busy() const { return std::ranges::any_of(all, &GripperStep::busy); }
};

CalibrateGripper::CalibrateGripper(Workbench& workbench, QWidget* parent)
    : QWidget(parent), d(std::make_unique<Private>(workbench))
{
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 0, 16);
    row->addWidget(makeMeasuring(), 1);
    row->addWidget(makeKnown());
    connect(&workbench, &Workbench::connectionChanged, this, &CalibrateGripper::reload);
    for (GripperStep* const step : d->all)
        connect(step, &GripperStep::changed, this, [this, step] { follow(step); });
    reload();
}

CalibrateGripper::~CalibrateGripper() = default;

QWidget* CalibrateGripper::makeMeasuring()
{
    QFrame* card = makeCard(this);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 12, 8); // the forces and their picture need the height
    d->steps = new QTabBar(card);
    d->steps->setObjectName("gripperSteps");
    d->steps->setAccessibleName(tr("What a gripper is characterised by, one after the other"));
    d->steps->setDrawBase(false);
    d->steps->setExpanding(false);
    d->stack = new QStackedWidget(card);
    d->stack->setStyleSheet(u"QStackedWidget, gripscope--GripperStep { background: transparent; }"_s);
    d->empty = new EmptyGripperStep(d->bench, card);
    d->all = {d->empty, new FrameStep(d->bench, card), new LagStep(d->bench, card)};
    const std::array names{tr("1  Empty gripper"), tr("2  Frame"), tr("3  Lag")};
    for (std::size_t i = 0; i < d->all.size(); ++i) {
        d->steps->addTab(names[i]);
        d->stack->addWidget(d->all[i]);
        if (i + 1 == d->all.size())
            continue;
        auto* next = makeButton(i == 0 ? tr("Next: the frame") : tr("Next: the lag"), {}, "", card);
        next->setObjectName(i == 0 ? "nextFrame" : "nextLag");
        connect(next, &QPushButton::clicked, this,
                [this, i] { d->steps->setCurrentIndex(static_cast<int>(i) + 1); });
        d->all[i]->guide()->addButton(next);
    }
    connect(d->steps, &QTabBar::currentChanged, this, [this](int step) {
        d->step()->guide()->leave(); // nobody looks at it any more: nothing moves on
        d->stack->setCurrentIndex(step);
    });
    column->addWidget(d->steps);
    column->addWidget(d->stack, 1);
    return card;
}

QWidget* CalibrateGripper::makeKnown()
{
    QFrame* card = makeCard(this);
    card->setFixedWidth(336);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    column->addWidget(makeLabel(tr("Known of this gripper"), "heading", card));
    auto* known = new QWidget(card);
    auto* inside = new QVBoxLayout(known);
    setSpacing(inside, 0, 8);
    constexpr std::array names{"knownEmpty", "knownFrame", "knownLag"};
    for (std::size_t i = 0; i < d->facts.size(); ++i) {
        inside->addWidget(makeRule(known));
        d->when[i] = makeLabel({}, "second", known);
        d->when[i]->setWordWrap(true);
        d->when[i]->setObjectName(names[i]);
        inside->addWidget(d->when[i]);
        d->facts[i] = makeFactGrid();
        inside->addLayout(d->facts[i]);
    }
    inside->addWidget(makeRule(known));
    d->meaning = makeLabel({}, "second", known);
    d->meaning->setObjectName("baselineMeaning");
    d->meaning->setWordWrap(true);
    inside->addWidget(d->meaning);
    inside->addStretch(1);
    column->addWidget(makeScroll(known, card), 1);
    d->remove = makeButton(tr("Take nothing off any more"), u"edit-delete"_s, "", card);
    d->remove->setObjectName("baselineRemove");
    connect(d->remove, &QPushButton::clicked, this, &CalibrateGripper::remove);
    column->addWidget(d->remove);
    return card;
}

void CalibrateGripper::follow(GripperStep* step)
{
    if (step->state() == SeriesSession::State::Stored)
        reload();
    else
        showKnown();
}

void CalibrateGripper::reload()
{
    const ConnectSession& connection = d->bench.connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const QString serial = connected ? connection.identity().serial : QString();
    if (d->measuredOf != serial)
        d->measurements.clear();
    d->measuredOf = serial;
    showKnown();
    if (serial.isEmpty())
        return;
    using Measurements = std::vector<MeasuringChainRecord>;
    d->bench.background().ask<Measurements>(
        this, [serial](Library& library) { return library.measuringChains(serial, mostChainMeasurements); },
        [this, serial](Expected<Measurements> found) {
            if (!found || serial != d->measuredOf)
                return;
            d->measurements = std::move(*found);
            showKnown();
        });
}

void CalibrateGripper::showKnown()
{
    ConnectSession& connection = d->bench.connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    NewMeasuringChain known;
    if (connected) {
        known.forceLag_s = connection.forceLag_s();
        known.chain = connection.measuringChain();
    }
    const auto sections = GripperTexts::sections(known, d->measurements, connection.identity());
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const GripperTexts::Section& section = sections[i];
        fillFacts(d->facts[i], section.facts);
        d->when[i]->setText(u"%1  ·  %2"_s.arg(section.heading, section.facts.empty() ? tr("not measured")
                                                                : section.when.isEmpty()
                                                                    ? tr("stated by the gripper")
                                                                    : section.when));
    }
    const bool takesOff = known.chain.baseline.has_value();
    d->meaning->setText(
        takesOff
            ? tr("The empty gripper is taken off every later squeeze, and its uncertainty goes into the "
                 "error bars. Types that were enrolled without this include the fingers: enroll them "
                 "again. Measure anew when the fingers are changed.")
            : tr("Nothing is taken off. The m, b and k of a part include those of the fingers, in enrolled "
                 "types and in inspections alike, so that they still compare on this gripper."));
    d->remove->setVisible(takesOff);
    d->remove->setEnabled(!d->busy());
    d->steps->setEnabled(!d->busy());
}

void CalibrateGripper::remove()
{
    askWhy(this, d->remove->text(), [this](const QString& reason) {
        authorize(d->bench, this, Permission::AcceptCalibrations, [this, reason] {
            BaselineSession& session = d->empty->session();
            session.setOperator(d->bench.operatorName());
            session.setReason(reason);
            if (const Expected<void> answer = session.remove(); !answer)
                d->bench.messages().report(answer.error().describe());
            d->empty->guide()->refresh();
        });
    });
}

void CalibrateGripper::act()
{
    d->step()->act();
}

bool CalibrateGripper::underWay() const
{
    return std::ranges::any_of(d->all, &GripperStep::underWay);
}

void CalibrateGripper::leave()
{
    for (GripperStep* const step : d->all)
        step->guide()->leave();
}

} // namespace gripscope
