// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/device_inspector.h"

#include "core/base/words.h"
#include "core/session/connection/report_log.h"
#include "devices/protocol/descriptor_words.h"
#include "ui/context/workbench.h"
#include "ui/format/link_words.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_unit.h"
#include "ui/inspector/inspector_tabs.h"
#include "ui/widgets/controls.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QTabWidget>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int refreshEvery_ms = 200; ///< what changes faster cannot be read

struct Counter {
    QString name;
    std::uint64_t LinkCounters::*value;
};

QString number(double value)
{
    return Words::number(value, 'g', 6);
}

} // namespace

DeviceInspector* DeviceInspector::open(Workbench& workbench, QWidget* parent)
{
    auto* inspector = parent->findChild<DeviceInspector*>();
    if (!inspector) {
        inspector = new DeviceInspector(workbench, parent);
        inspector->setAttribute(Qt::WA_DeleteOnClose);
    }
    inspector->Dialog::open();
    return inspector;
}

namespace {
const RegisteredDialog<DeviceInspector> deviceInspectorRow("inspector", [](Workbench& bench, QWidget* over) {
    return new DeviceInspector(bench, over);
});
} // namespace

DeviceInspector::DeviceInspector(Workbench& workbench, QWidget* parent)
    : Dialog(parent, Conduct::Beside), m_workbench(&workbench)
{
    setObjectName("deviceInspector");
    setManualPage(u"link"_s);
    setWindowTitle(tr("Gripper inspector"));
    m_reports = new ReportsTab(this);
    m_selfTest = new SelfTestTab(workbench, this);
    auto* tabs = new QTabWidget(this);
    tabs->setDocumentMode(true);
    tabs->addTab(makeIdentity(), tr("Identity"));
    tabs->addTab(m_reports, tr("Reports"));
    tabs->addTab(makeCounters(), tr("Counters"));
    tabs->addTab(m_selfTest, tr("Self-test"));
    tabs->addTab(makeDescriptor(), tr("Descriptor"));
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 8, 8);
    column->addWidget(tabs);
    connect(&workbench, &Workbench::connectionChanged, this, &DeviceInspector::lookUp);
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, &DeviceInspector::refresh);
    timer->start(refreshEvery_ms);
    resize(960, 600);
    m_lookedAt = workbench.connection().counters();
    lookUp();
    refresh();
}

QWidget* DeviceInspector::makeIdentity()
{
    m_identity = makeFactTable({tr("Property"), tr("Value")}, this);
    m_identity->setObjectName("identity");
    m_identity->setAccessibleName(tr("Identity"));
    m_identity->setColumnWidth(0, 208);
    return m_identity;
}

QWidget* DeviceInspector::makeDescriptor()
{
    auto* page = new QWidget(this);
    m_descriptor = makeFactTable({tr("Bytes"), tr("In words")}, page);
    m_descriptor->setObjectName("descriptor");
    m_descriptor->setAccessibleName(tr("Report descriptor"));
    m_descriptor->setColumnWidth(0, 208);
    auto* copy = makeButton(tr("Copy the bytes"), {}, "", page);
    connect(copy, &QPushButton::clicked, this, [this] {
        QStringList bytes;
        for (int row = 0; row < m_descriptor->rowCount(); ++row)
            bytes << m_descriptor->item(row, 0)->text();
        QApplication::clipboard()->setText(bytes.join(u' '));
    });
    auto* row = new QHBoxLayout;
    row->addWidget(copy);
    row->addStretch(1);
    auto* column = new QVBoxLayout(page);
    setSpacing(column, 16, 8);
    column->addLayout(row);
    column->addWidget(m_descriptor, 1);
    return page;
}

QWidget* DeviceInspector::makeCounters()
{
    auto* page = new QWidget(this);
    m_counters = makeFactTable({tr("Counter"), tr("Since it was opened"), tr("Since I looked")}, page);
    m_counters->setObjectName("counters");
    m_counters->setAccessibleName(tr("Counters"));
    m_counters->setColumnWidth(0, 272);
    m_counters->setColumnWidth(1, 208);
    auto* look = makeButton(tr("Count from here on"), {}, "", page);
    look->setObjectName("countFromHere");
    connect(look, &QPushButton::clicked, this, [this] {
        m_lookedAt = m_workbench->connection().counters();
        showCounters();
    });
    auto* row = new QHBoxLayout;
    row->addWidget(look);
    row->addStretch(1);
    auto* column = new QVBoxLayout(page);
    setSpacing(column, 16, 8);
    column->addLayout(row);
    column->addWidget(m_counters, 1);
    return page;
}

void DeviceInspector::lookUp()
{
    const GripperIdentity identity = m_workbench->connection().identity();
    const QString address = m_workbench->connection().address();
    const QString now = address + u'\n' + identity.serial;
    if (now == m_known)
        return;
    m_known = now;
    m_lookedAt = {};
    // The device list is read off the screen's thread.
    m_workbench->background().compute<DeviceFacts>(
        this, [address, serial = identity.serial] { return findDeviceFacts(address, serial); },
        [this](const DeviceFacts& facts) {
            showIdentity(facts);
            showDescriptor(facts);
        });
}

void DeviceInspector::showIdentity(const DeviceFacts& facts)
{
    const GripperIdentity identity = m_workbench->connection().identity();
    const auto orDash = [](const QString& text) { return text.isEmpty() ? u"–"_s : text; };
    const QString protocol = identity.protocolMajor > 0
                                 ? u"%1.%2"_s.arg(identity.protocolMajor).arg(identity.protocolMinor)
                                 : QString();
    const bool limited = identity.limits.maxForce_N > 0;
    const std::pair<QString, QString> rows[] = {
        {tr("Name"), orDash(identity.name)},
        {tr("Serial number"), orDash(identity.serial)},
        {tr("Firmware"), orDash(identity.firmware)},
        {tr("Protocol"), orDash(protocol)},
        {tr("Address"), orDash(m_workbench->connection().address())},
        {tr("USB vendor and product"), orDash(facts.usbIds)},
        {tr("Device node"), orDash(facts.node)},
        {tr("Units"), tr("force in %1, position in %2").arg(identity.forceUnit, identity.positionUnit)},
        {tr("Sample time"), tr("%1 ms").arg(number(1000 * identity.sampleTime_s))},
        {tr("Position later than force by"), tr("%1 µs, as it says").arg(number(1e6 * identity.forceLag_s))},
        {tr("Takes commands"), identity.commandable ? tr("yes") : tr("no, it only streams")},
        {tr("Its own limits"), limited
                                   ? tr("%1, %2, %3 samples")
                                         .arg(forceText(identity.limits.maxForce_N))
                                         .arg(lengthText(identity.limits.maxTravel_m))
                                         .arg(formatCount(static_cast<qint64>(identity.limits.maxSamples)))
                                   : u"–"_s}};
    m_identity->setRowCount(0);
    for (const auto& [name, value] : rows)
        addFacts(m_identity, {name, value});
}

void DeviceInspector::showDescriptor(const DeviceFacts& facts)
{
    m_descriptor->setRowCount(0);
    const QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    for (const protocol::DescriptorItem& item : protocol::descriptorInWords(facts.descriptor)) {
        addFacts(m_descriptor, {item.hex, QString(4 * item.depth, u' ') + item.words});
        m_descriptor->item(m_descriptor->rowCount() - 1, 0)->setFont(fixed);
    }
    if (facts.descriptor.empty())
        addFacts(m_descriptor, {u"–"_s, tr("There is no report descriptor: this is no USB device.")});
}

void DeviceInspector::refresh()
{
    // A gripper that went away leaves its last reports in view.
    const GripperPort* const port = m_workbench->connection().port();
    if (const ReportLog* const log = port ? port->reportLog() : nullptr)
        m_reports->show(log->last(), log->missed());
    showCounters();
}

void DeviceInspector::showCounters()
{
    const LinkCounters now = m_workbench->connection().counters();
    if (now.reports < m_lookedAt.reports)
        m_lookedAt = {}; // it was opened anew
    const Counter counters[] = {{tr("Reports"), &LinkCounters::reports},
                                {tr("Samples"), &LinkCounters::samples},
                                {tr("Samples lost on the way"), &LinkCounters::lostSamples},
                                {tr("Places where samples are missing"), &LinkCounters::sequenceGaps},
                                {tr("Samples dropped here"), &LinkCounters::droppedSamples},
                                {tr("Reports that came twice"), &LinkCounters::duplicateReports},
                                {tr("Damaged reports"), &LinkCounters::badReports},
                                {tr("Silences of 50 ms and more"), &LinkCounters::stalls},
                                {tr("Jumps of the gripper's clock"), &LinkCounters::clockSteps},
                                {tr("Commands sent"), &LinkCounters::commandsSent},
                                {tr("Commands repeated"), &LinkCounters::commandsRepeated},
                                {tr("Commands answered"), &LinkCounters::commandsAnswered},
                                {tr("Commands refused"), &LinkCounters::commandsRefused},
                                {tr("Commands without an answer"), &LinkCounters::commandsUnanswered},
                                {tr("Heartbeats"), &LinkCounters::heartbeats}};
    const auto count = [](std::uint64_t n) { return formatCount(static_cast<qint64>(n)); };
    QList<QStringList> rows;
    for (const Counter& counter : counters)
        rows << QStringList{counter.name, count(now.*counter.value),
                            count(now.*counter.value - m_lookedAt.*counter.value)};
    rows << QStringList{tr("Longest silence"), tr("%1 s").arg(now.longestStall_s, 0, 'g', 2), {}}
         << QStringList{tr("Clock beside the computer's"),
                        now.clocks.clock ? tr("%1 ± %2 ppm")
                                               .arg(now.clocks.clock->ppm, 0, 'f', 0)
                                               .arg(now.clocks.clock->uncertainty_ppm, 0, 'f', 0)
                                         : u"–"_s,
                        {}}
         << QStringList{tr("Until the program took a sample over"),
                        latencyWords(now.latency50_ms, now.latency99_ms),
                        {}};
    // In place, so that a person's scrolling and selection stay.
    while (m_counters->rowCount() < rows.size())
        addFacts(m_counters, {{}, {}, {}});
    for (int row = 0; row < rows.size(); ++row)
        for (int column = 0; column < rows[row].size(); ++column)
            m_counters->item(row, column)->setText(rows[row][column]);
}

} // namespace gripscope
