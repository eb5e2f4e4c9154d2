// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit/opened_recordings.h"

#include "ui/imports/recording_opener.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/tool_button.h"
#include "ui/windows/file_dialog.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QShortcut>

#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

OpenedRecordings::OpenedRecordings(Workbench& workbench, QWidget* page)
    : QWidget(page), m_opener(new RecordingOpener(workbench, page)), m_page(page)
{
    setObjectName("openedRecordings");
    auto* line = new QHBoxLayout(this);
    setSpacing(line, 0, metrics::insideControl);
    m_previous = addArrow(u"go-up"_s, tr("The recording before (Alt+Up)"), -1);
    m_place = makeLabel({}, "second");
    line->addWidget(m_place);
    m_next = addArrow(u"go-down"_s, tr("The next recording (Alt+Down)"), 1);
    hide();
}

QToolButton* OpenedRecordings::addArrow(const QString& icon, const QString& words, int by)
{
    QToolButton* arrow = makeToolButton({}, icon, {});
    arrow->setMinimumSize(metrics::touchTarget, metrics::touchTarget);
    arrow->setAccessibleName(words);
    arrow->setToolTip(words);
    connect(arrow, &QToolButton::clicked, this, [this, by] { go(by); });
    auto* shortcut = new QShortcut(QKeySequence(Qt::ALT | (by < 0 ? Qt::Key_Up : Qt::Key_Down)), m_page);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, [this, by] { go(by); });
    layout()->addWidget(arrow);
    return arrow;
}

void OpenedRecordings::choose()
{
    auto* dialog = new FileDialog(m_page, tr("Open recordings"), QString(),
                                  tr("Recordings (*.csv *.tsv *.txt);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFiles);
    connect(dialog, &QFileDialog::filesSelected, this, &OpenedRecordings::open);
    dialog->open();
}

void OpenedRecordings::open(const QStringList& files)
{
    m_waiting = files;
    m_all = files.size();
    m_subjects.clear();
    m_at = 0;
    refresh();
    if (!m_reading)
        readNext();
}

void OpenedRecordings::cancel()
{
    m_waiting.clear();
}

void OpenedRecordings::readNext()
{
    m_reading = !m_waiting.isEmpty();
    if (!m_reading) {
        emit stateChanged({});
        return;
    }
    const QString file = m_waiting.takeFirst();
    const QString name = QFileInfo(file).fileName();
    const qsizetype number = m_all - m_waiting.size();
    emit stateChanged(
        m_all > 1 ? tr("reading %1 (%2 of %3)…").arg(name, QString::number(number), QString::number(m_all))
                  : tr("reading %1…").arg(name));
    m_opener->open(
        file, [this, name](const Recording& recording) { emit opened(name, recording); },
        [this] { readNext(); },
        number == 1 ? RecordingOpener::Asking::Always : RecordingOpener::Asking::OnlyOfNew);
}

void OpenedRecordings::add(FitSubject subject)
{
    m_subjects.push_back(std::move(subject));
    if (m_subjects.size() == 1)
        emit chosen(m_subjects.front());
    refresh();
    readNext();
}

void OpenedRecordings::skip()
{
    readNext();
}

void OpenedRecordings::follow(const FitSubject& shown)
{
    bool found = false;
    for (std::size_t i = 0; i < m_subjects.size() && !found; ++i)
        if (m_subjects[i].title == shown.title && m_subjects[i].recording == shown.recording) {
            m_at = i;
            found = true;
        }
    if (!found)
        m_subjects.clear(); // another squeeze has been chosen since
    refresh();
}

void OpenedRecordings::go(int by)
{
    const auto to = static_cast<std::ptrdiff_t>(m_at) + by;
    if (to < 0 || to >= std::ssize(m_subjects))
        return;
    m_at = static_cast<std::size_t>(to);
    emit chosen(m_subjects[m_at]);
    refresh();
}

void OpenedRecordings::refresh()
{
    const auto count = static_cast<qsizetype>(m_subjects.size());
    m_place->setText(tr("%1 of %2").arg(m_at + 1).arg(count));
    m_previous->setEnabled(m_at > 0);
    m_next->setEnabled(static_cast<qsizetype>(m_at) + 1 < count);
    setVisible(count > 1);
}

} // namespace gripscope
