// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include "ui/context/connection_words.h"
#include "ui/context/workbench.h"
#include "ui/help/help_windows.h"
#include "ui/inspector/device_inspector.h"
#include "ui/library/station_conflicts.h"
#include "ui/pages/calibrate/calibrate_page.h"
#include "ui/pages/enroll/enroll_page.h"
#include "ui/pages/enroll/enrolled_types_dialog.h"
#include "ui/pages/fit/fit_page.h"
#include "ui/pages/history/history_page.h"
#include "ui/pages/inspect/inspect_page.h"
#include "ui/pages/live/live_page.h"
#include "ui/pages/quality/quality_page.h"
#include "ui/pages/types/types_page.h"
#include "ui/people/authorize.h"
#include "ui/settings/settings_dialog.h"
#include "ui/shell/window_bars.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/message_bar.h"
#include "ui/windows/question.h"
#include "ui/windows/stop_controls.h"
#include "ui/windows/window_guard.h"

#include <QButtonGroup>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {
constexpr int railWidth = 88;
constexpr QSize least(1024, 640);
} // namespace

MainWindow::MainWindow(Workbench& workbench, QWidget* parent) : QWidget(parent), m_workbench(&workbench)
{
    const Theme::PlainStyle plain;
    setWindowTitle(tr("Gripscope"));
    m_stack = new QStackedWidget(this);
    m_header = new HeaderBar(workbench, this);
    m_messages = new MessageBar(this);
    m_rail = new QButtonGroup(this);
    addPages();

    auto* column = new QVBoxLayout;
    setSpacing(column, 0, 0);
    column->addWidget(m_header);
    column->addWidget(makeRule(this));
    column->addWidget(m_messages);
    column->addWidget(new PageView(*m_stack, this), 1);
    m_foot = new QWidget(this);
    auto* foot = new QVBoxLayout(m_foot);
    setSpacing(foot, 0, 0);
    foot->addWidget(makeRule(m_foot));
    foot->addWidget(new StatusLine(workbench, m_foot));
    column->addWidget(m_foot);
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 0, 0);
    row->addWidget(makeRail());
    row->addLayout(column, 1);

    connect(&workbench.messages(), &Messages::reported, m_messages, &MessageBar::show);
    connect(&workbench.messages(), &Messages::told, m_messages, &MessageBar::tell);
    connect(&workbench.messages(), &Messages::withdrawn, m_messages, &MessageBar::withdraw);
    connect(m_messages, &MessageBar::changed, this, &MainWindow::makeRoom);
    connect(&workbench.navigator(), &Navigator::pageRequested, this,
            qOverload<const QString&>(&MainWindow::showPage));
    connect(&workbench.navigator(), &Navigator::typesAsked, this,
            [this] { (new EnrolledTypesDialog(*m_workbench, this))->open(); });
    auto* notice = new StopNotice(workbench.connection(), m_header, this);
    connect(&workbench, &Workbench::ticked, notice, &StopNotice::refresh);
    connect(&StopStanding::of(workbench), &StopStanding::changed, this, &MainWindow::tellDisarmed);
    makeShortcuts();
    answerForPeople(workbench, this);
    tellStationConflicts(workbench, this);
    connect(new WindowGuard(workbench, this), &WindowGuard::helpAsked, this, &MainWindow::showHelpOn);
    setMinimumSize(least);
    resize(1280, 800);
    showPage(0);
}

MainWindow::~MainWindow() = default;

/// In a low window a message takes the place of the status line and some of the page's margins: the window
/// stays as it is, for the screen may have no more. What that does not give, PageView scrolls.
void MainWindow::makeRoom()
{
    const int message =
        m_messages->messages().isEmpty() ? 0 : m_messages->heightForWidth(width() - railWidth);
    const bool tight = height() < least.height() + message;
    m_foot->setVisible(!tight);
    for (Page* page : m_pages)
        page->setTight(tight);
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    makeRoom();
}

void MainWindow::tellDisarmed()
{
    if (const std::optional<Error>& reason = StopStanding::of(*m_workbench).disarmReason())
        m_workbench->messages().report(reason->describe(), [bench = m_workbench, reason] {
            return StopStanding::of(*bench).disarmReason() == reason;
        });
}

void MainWindow::addPages()
{
    auto* history = new HistoryPage(*m_workbench);
    auto* quality = new QualityPage(*m_workbench);
    m_pages = {new LivePage(*m_workbench),
               new InspectPage(*m_workbench),
               new EnrollPage(*m_workbench),
               new TypesPage(*m_workbench),
               new FitPage(*m_workbench),
               new CalibratePage(*m_workbench),
               history,
               quality};
    connect(quality, &QualityPage::squeezeAsked, this, [this, history](const QString& graspId) {
        showPage(history->id());
        history->showSqueeze(graspId);
    });
    for (Page* page : m_pages)
        m_stack->addWidget(page);
}

QWidget* MainWindow::makeRail()
{
    auto* rail = new QFrame(this);
    rail->setObjectName("rail");
    setRole(rail, "rail");
    rail->setFixedWidth(railWidth);
    auto* column = new QVBoxLayout(rail);
    column->setContentsMargins(0, 8, 0, 8);
    column->setSpacing(4);
    m_rail->setExclusive(true);
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        auto* button = new RailButton(m_pages[i]->title(), m_pages[i]->iconName(), rail);
        button->setObjectName("rail-"_L1 + m_pages[i]->id());
        button->setCheckable(true);
        button->setToolTip(tr("%1 (Ctrl+%2)").arg(m_pages[i]->title()).arg(i + 1));
        m_rail->addButton(button, static_cast<int>(i));
        column->addWidget(button);
    }
    connect(m_rail, &QButtonGroup::idClicked, this, qOverload<int>(&MainWindow::showPage));
    column->addStretch(1);
    auto* settings = new RailButton(tr("Settings"), u"configure"_s, rail);
    settings->setObjectName("rail-settings");
    settings->setToolTip(tr("Language, theme, rates and more (Ctrl+,)"));
    connect(settings, &RailButton::clicked, this, &MainWindow::showSettings);
    column->addWidget(settings);
    auto* help = new RailButton(tr("Help"), u"help-about"_s, rail);
    help->setObjectName("rail-help");
    help->setToolTip(tr("The manual, at the page about this screen (F1)"));
    connect(help, &RailButton::clicked, this, &MainWindow::showHelp);
    column->addWidget(help);
    return rail;
}

void MainWindow::makeShortcuts()
{
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        auto* shortcut = new QShortcut(QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_1 + i)), this);
        connect(shortcut, &QShortcut::activated, this, [this, i] { showPage(static_cast<int>(i)); });
    }
    connect(new QShortcut(QKeySequence(Qt::Key_F1), this), &QShortcut::activated, this,
            &MainWindow::showHelp);
    connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_Comma), this), &QShortcut::activated, this,
            &MainWindow::showSettings);
    connect(new QShortcut(QKeySequence(Qt::Key_F9), this), &QShortcut::activated, this,
            [this] { DeviceInspector::open(*m_workbench, this); });
}

Page* MainWindow::currentPage() const
{
    return static_cast<Page*>(m_stack->currentWidget());
}

void MainWindow::showPage(int index)
{
    if (index < 0 || index >= static_cast<int>(m_pages.size()))
        return;
    Page* next = m_pages[static_cast<std::size_t>(index)];
    Page* before = currentPage();
    if (before != next || m_rail->checkedId() != index) {
        if (before != next)
            before->setActive(false);
        m_stack->setCurrentWidget(next);
        m_rail->button(index) ? m_rail->button(index)->setChecked(true) : void();
        m_header->setTitle(next->title());
        next->setActive(true);
    }
}

void MainWindow::showPage(const QString& id)
{
    for (std::size_t i = 0; i < m_pages.size(); ++i)
        if (m_pages[i]->id() == id)
            showPage(static_cast<int>(i));
}

void MainWindow::showHelp()
{
    showHelpOn({});
}

void MainWindow::showHelpOn(const QString& page)
{
    if (!m_manual) {
        m_manual = new ManualWindow(this);
        connect(m_manual, &ManualWindow::keysAsked, this, &MainWindow::showAbout);
    }
    m_manual->showPage(manualPageFor(page.isEmpty() ? currentPage()->id() : page));
    m_manual->open();
}

void MainWindow::showAbout()
{
    QStringList titles;
    for (const Page* page : m_pages)
        titles << page->title();
    (new AboutDialog(titles, m_manual ? static_cast<QWidget*>(m_manual) : this))->open();
}

void MainWindow::showSettings()
{
    if (!findChild<SettingsDialog*>())
        (new SettingsDialog(*m_workbench, this))->open();
}

void MainWindow::takeMessages(const MainWindow& other)
{
    const QStringList& messages = other.m_messages->messages();
    for (auto message = messages.rbegin(); message != messages.rend(); ++message)
        other.m_messages->isGood(*message) ? m_messages->tell(*message) : m_messages->show(*message);
}

QString MainWindow::message() const
{
    return m_messages->message();
}

void MainWindow::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    currentPage()->setActive(true); // only now can it take the focus
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    // The port's own close is bounded; what must not wait is that the gripper stops.
    m_workbench->stop();
    const InspectSession& inspection = m_workbench->inspection();
    // What is in the spill file is stored when the program runs again.
    if (inspection.unstored() > inspection.spilled() && !inspection.storing() && !m_closesAnyway) {
        event->ignore();
        return askWhetherToLose();
    }
    QWidget::closeEvent(event);
}

void MainWindow::askWhetherToLose()
{
    const InspectSession& session = m_workbench->inspection();
    const std::optional<Error> why = session.lastError();
    auto* question = new Question(
        tr("Close and lose what is not stored?"),
        tr("Not stored yet: %1. They are stored as soon as that can be, while the program runs. %2")
            .arg(session.unstored() - session.spilled())
            .arg(why ? why->describe() : QString()),
        tr("Close and lose them"), tr("Keep it open"), this);
    question->setObjectName("unstoredQuestion");
    question->yes()->setObjectName("unstoredClose");
    connect(question, &QDialog::accepted, this, [this] {
        m_closesAnyway = true;
        close();
    });
    question->open();
}

} // namespace gripscope
