// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profiles/profile_dialog.h"

#include "core/people/audit_entry.h"
#include "devices/profile/profiled_device.h"
#include "devices/profile/report_watch.h"
#include "ui/charts/strip_chart.h"
#include "ui/context/workbench.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"
#include "ui/windows/file_dialog.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int ticksBetweenLooks = 6; ///< about ten times a second: faster than bytes can be read
constexpr double shownSeconds = 6;

/// A start for a gripper that nothing is known of.
GripperProfile blankProfile()
{
    GripperProfile profile;
    profile.reportLength = 8;
    profile.samplesPerSecond = 1000;
    profile.force.field.type = profile.position.field.type = FieldType::I16;
    profile.position.field.byte = 2;
    profile.force.unit = u"N"_s;
    profile.position.unit = u"mm"_s;
    return profile;
}

} // namespace

struct ProfileDialog::Private {
    explicit Private(Workbench& bench) : workbench(bench) {}

    Workbench& workbench;
    ReportWatch watch;
    ByteTableModel* bytes = nullptr;
    ProfileForm* form = nullptr;
    QPlainTextEdit* json = nullptr;
    QStackedWidget* views = nullptr;
    QLineEdit* address = nullptr;
    QLabel *seen = nullptr, *problems = nullptr;
    StripChart *force = nullptr, *position = nullptr;
    QPushButton *save = nullptr, *showJson = nullptr;
    LiveHistory history{shownSeconds * 2};
    std::optional<GripperProfile> valid; ///< what is read by
    int ticks = 0;

    void showCurves();
    [[nodiscard]] const ReportStatistics* shownKind(const ReportWatch::Snapshot& now) const;
    [[nodiscard]] QString inWords(const ReportWatch::Snapshot& now) const;
};

const ReportStatistics* ProfileDialog::Private::shownKind(const ReportWatch::Snapshot& now) const
{
    if (valid)
        if (const auto meant = now.kinds.find({valid->reportLength, valid->reportId});
            meant != now.kinds.end())
            return &meant->second;
    const auto newest = now.kinds.find(now.newest);
    return newest == now.kinds.end() ? nullptr : &newest->second;
}

QString ProfileDialog::Private::inWords(const ReportWatch::Snapshot& now) const
{
    if (now.error)
        return now.error->describe();
    const ReportStatistics* kind = shownKind(now);
    if (!kind)
        return now.state == ReportWatch::State::Idle
                   ? tr("Name a gripper, then listen. Nothing is sent to it.")
                   : tr("Listening; no report came yet.");
    QString text = tr("%1 bytes, %2 reports a second.")
                       .arg(kind->bytes().size())
                       .arg(QLocale().toString(kind->reportsPerSecond(), 'f', 1));
    if (valid)
        text += u' ' +
                (valid->lossEvidence() == LossEvidence::None ? tr("What gets lost cannot be seen.")
                                                             : tr("Lost samples: %1.").arg(now.lostSamples)) +
                u' ' + tr("Not as the profile says: %1.").arg(now.badReports);
    return text;
}

void ProfileDialog::Private::showCurves()
{
    const auto show = [&](StripChart* chart, LiveHistory::Channel channel) {
        chart->setStretches(history.columns(channel, history.newestTime_s(), chart->seconds(),
                                            static_cast<std::size_t>(std::max(1, chart->columns()))));
    };
    show(force, LiveHistory::Channel::Force);
    show(position, LiveHistory::Channel::Position);
}

namespace {
const RegisteredDialog<ProfileDialog> profileDialogRow("profile", [](Workbench& bench, QWidget* over) {
    return new ProfileDialog(bench, over);
});
} // namespace

ProfileDialog::ProfileDialog(Workbench& workbench, QWidget* parent)
    : Dialog(parent, Conduct::Beside), d(std::make_unique<Private>(workbench))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("profileDialog");
    setManualPage(u"profiles"_s);
    setWindowTitle(tr("Profile of another maker's gripper"));
    build();
    connectEditors();
    d->form->setProfile(blankProfile());
    refresh();
}

ProfileDialog::~ProfileDialog() = default;

QWidget* ProfileDialog::buildBytes()
{
    auto* panel = new QWidget(this);
    auto* column = new QVBoxLayout(panel);
    setSpacing(column, 0, 8);
    column->addWidget(makeLabel(tr("Bytes (● moves, ◀ chosen field)"), "strong", panel));
    d->bytes = new ByteTableModel(this);
    auto* table = new QTableView(panel);
    table->setObjectName("profileBytes");
    table->setAccessibleName(tr("Bytes of the last report"));
    table->setModel(d->bytes);
    table->setShowGrid(false);
    table->setSelectionMode(QAbstractItemView::NoSelection);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(24);
    table->horizontalHeader()->setStretchLastSection(true);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->horizontalHeader()->setMinimumSectionSize(40);
    constexpr int widths[] = {60, 46, 50, 48, 60};
    for (int i = 0; i < d->bytes->columnCount() - 1; ++i)
        table->setColumnWidth(i, widths[i]);
    column->addWidget(table, 1);
    panel->setFixedWidth(368);
    return panel;
}

QWidget* ProfileDialog::buildProfile()
{
    auto* panel = new QWidget(this);
    auto* column = new QVBoxLayout(panel);
    setSpacing(column, 0, 8);
    d->form = new ProfileForm;
    QScrollArea* scroll = makeScroll(d->form, panel);
    d->json = new QPlainTextEdit(panel);
    d->json->setReadOnly(true);
    d->json->setObjectName("profileJson");
    d->json->setAccessibleName(tr("The profile as a JSON document"));
    d->views = new QStackedWidget(panel);
    d->views->addWidget(scroll);
    d->views->addWidget(d->json);
    column->addWidget(d->views, 1);
    d->problems = makeLabel({}, "error", panel);
    d->problems->setObjectName("profileProblems");
    d->problems->setWordWrap(true);
    column->addWidget(d->problems);
    d->force = new StripChart(LiveHistory::Channel::Force, 1, panel);
    d->position = new StripChart(LiveHistory::Channel::Position, 0.01, panel);
    auto* charts = new QHBoxLayout;
    charts->setSpacing(8);
    for (StripChart* chart : {d->force, d->position}) {
        chart->setTime(shownSeconds, 0, tr("now"));
        chart->setFixedHeight(96);
        charts->addWidget(chart, 1);
    }
    d->force->setAccessibleName(tr("Force of the last seconds"));
    d->position->setAccessibleName(tr("Position of the last seconds"));
    column->addLayout(charts);
    return panel;
}

void ProfileDialog::build()
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 8);
    auto* top = new QHBoxLayout;
    top->setSpacing(8);
    d->address = new QLineEdit(this);
    d->address->setObjectName("profileAddress");
    d->address->setAccessibleName(tr("Address of the gripper"));
    d->address->setPlaceholderText(tr("hid:VENDOR:PRODUCT, or virtual:?like=walkthrough to try it"));
    auto* listenButton = makeButton(tr("Listen"), {}, "primary", this);
    listenButton->setObjectName("profileListen");
    top->addWidget(d->address, 1);
    top->addWidget(listenButton);
    column->addLayout(top);
    d->seen = makeLabel({}, "second", this);
    d->seen->setObjectName("profileSeen");
    d->seen->setWordWrap(true);
    column->addWidget(d->seen);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addWidget(buildBytes());
    middle->addWidget(buildProfile(), 1);
    column->addLayout(middle, 1);

    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    d->showJson = makeButton(tr("Show as JSON"), {}, "", this);
    d->showJson->setCheckable(true);
    auto* loadButton = makeButton(tr("Load…"), {}, "", this);
    auto* close = makeButton(tr("Close"), {}, "", this);
    d->save = makeButton(tr("Save to my profiles"), {}, "primary", this);
    d->save->setObjectName("profileSave");
    for (QPushButton* button : {d->showJson, loadButton, close, d->save})
        button->setAutoDefault(false);
    row->addWidget(d->showJson);
    row->addWidget(loadButton);
    row->addStretch(1);
    row->addWidget(close);
    row->addWidget(d->save);
    column->addLayout(row);
    connect(listenButton, &QPushButton::clicked, this, [this] { listen(d->address->text().trimmed()); });
    connect(loadButton, &QPushButton::clicked, this, &ProfileDialog::load);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(d->save, &QPushButton::clicked, this, &ProfileDialog::save);
    resize(1016, 624);
}

void ProfileDialog::connectEditors()
{
    connect(d->form, &ProfileForm::edited, this, &ProfileDialog::takeEdit);
    connect(d->form, &ProfileForm::fieldChosen, d->bytes, &ByteTableModel::setChosenField);
    connect(d->showJson, &QPushButton::toggled, this,
            [this](bool on) { d->views->setCurrentIndex(on ? 1 : 0); });
    connect(&d->workbench, &Workbench::ticked, this, [this] {
        if (++d->ticks % ticksBetweenLooks == 0)
            refresh();
    });
}

void ProfileDialog::listen(const QString& address)
{
    d->address->setText(address);
    const Expected<std::shared_ptr<Transport>> transport = listenAt(address);
    if (!transport) {
        d->seen->setText(transport.error().describe());
        return;
    }
    d->watch.start(*transport);
    d->workbench.background().compute<Expected<GripperProfile>>(
        this, [address] { return profileAt(address); },
        [this](const Expected<GripperProfile>& known) {
            if (known)
                d->form->setProfile(*known);
        });
    refresh();
}

void ProfileDialog::takeEdit()
{
    const QByteArray json = writeProfile(d->form->profile());
    ProfileReading reading = readProfile(json);
    d->json->setPlainText(QString::fromUtf8(json));
    d->valid = reading.profile;
    d->watch.use(d->valid);
    d->bytes->setProfile(d->form->profile());
    d->history.reset(d->valid ? d->valid->sampleTime_s() : 0.001);
    d->force->setUnit(d->form->profile().force.unit);
    d->position->setUnit(d->form->profile().position.unit);
    d->save->setEnabled(d->valid.has_value());
    QStringList lines;
    for (const ProfileProblem& problem : reading.problems)
        lines << tr("⚠ %1: %2. Expected: %3.").arg(problem.pointer, problem.found, problem.expected);
    constexpr qsizetype mostLines = 2; // the rest follows when these are mended
    if (lines.size() > mostLines)
        lines = lines.mid(0, mostLines) << tr("…and %1 more.").arg(reading.problems.size() - mostLines);
    d->problems->setText(lines.join(u'\n'));
    d->problems->setVisible(!lines.isEmpty());
}

void ProfileDialog::refresh()
{
    const ReportWatch::Snapshot now = d->watch.snapshot();
    d->seen->setText(d->inWords(now));
    if (const ReportStatistics* kind = d->shownKind(now)) {
        d->bytes->setBytes(*kind);
        d->form->showValues(d->valid, kind->last());
    }
    d->history.append(now.fresh);
    d->showCurves();
}

void ProfileDialog::load()
{
    auto* chooser = new FileDialog(this, tr("Load a profile"), userProfileFolder(), tr("Profiles (*.json)"));
    chooser->setAttribute(Qt::WA_DeleteOnClose);
    connect(chooser, &QFileDialog::fileSelected, this, [this](const QString& file) {
        d->workbench.background().compute<Expected<GripperProfile>>(
            this, [file] { return readProfileFile(file); },
            [this](const Expected<GripperProfile>& read) {
                if (read)
                    d->form->setProfile(*read);
                else
                    d->problems->setText(read.error().describe());
                d->problems->setVisible(!d->problems->text().isEmpty());
            });
    });
    chooser->open();
}

void ProfileDialog::save()
{
    const GripperProfile profile = d->form->profile();
    const auto install = [this, json = writeProfile(profile)] {
        d->workbench.background().compute<Expected<QString>>(
            this, [json] { return installProfile(json); },
            [this](const Expected<QString>& saved) {
                d->problems->setText(
                    saved ? tr("Saved as %1. The gripper is found by it from now on.").arg(*saved)
                          : saved.error().describe());
                d->problems->setVisible(true);
            });
    };
    // It says what a gripper's numbers mean, so that it decides about verdicts.
    authorizeRecorded(d->workbench, this, Permission::ChangeSettings,
                      QString::fromUtf16(audit_action::profileInstalled), profile.name,
                      {{u"device"_s, profile.usbNumbers()}, {u"from"_s, u"window"_s}}, install);
}

} // namespace gripscope
