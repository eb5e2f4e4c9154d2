// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/enroll/enroll_squeeze_panel.h"

#include "ui/context/connection_words.h"
#include "ui/context/workbench.h"
#include "ui/pages/page_state.h"
#include "ui/pages/part_picture.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/progress.h"
#include "ui/widgets/row_list.h"
#include "ui/windows/question.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

/// How many squeezes an enrolment is to have, as inWords() says it: those that bring its verdicts near the
/// best there is, ten where that takes more; never fewer than there must be.
int squeezesWanted(const EnrollmentProgress& progress)
{
    const int needed = std::max(int{EnrollSession::leastSqueezes}, progress.squeezes + progress.moreForGate);
    const int suggested = EnrollSession::suggestedSqueezes;
    const int nearTheBest =
        progress.moreForMost ? std::min(suggested, progress.squeezes + *progress.moreForMost) : suggested;
    return std::max(needed, nearTheBest);
}

} // namespace

EnrollSqueezePanel::EnrollSqueezePanel(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_advisor(workbench)
{
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 0, 16);
    row->addWidget(makeSide());
    row->addWidget(makeTable(), 1);
    connect(&m_advisor, &EnrollAdvisor::changed, this, &EnrollSqueezePanel::refresh);
    connect(m_workbench, &Workbench::ratesChanged, this, &EnrollSqueezePanel::refresh);
}

QWidget* EnrollSqueezePanel::makeSide()
{
    QFrame* card = makeCard(this);
    card->setFixedWidth(280);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    m_ring = new ProgressRing(card);
    m_ring->setObjectName("ring");
    m_arm = makeButton(tr("Arm the gripper"), u"object-unlocked"_s, "primary", card);
    m_arm->setObjectName("enrollArmButton");
    m_squeeze = makeButton(tr("Squeeze (Space)"), u"media-playback-start"_s, "primary", card);
    m_squeeze->setObjectName("enrollSqueezeButton");
    m_squeeze->hide(); // one of the two is there: see refresh()
    m_hint = makeLabel({}, "caption", card);
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignCenter);
    column->addWidget(m_ring, 1);
    column->addWidget(m_hint);
    column->addWidget(makePart(card));
    column->addWidget(m_arm);
    column->addWidget(m_squeeze);
    column->addWidget(makeRule(card));
    column->addWidget(makeLast(card));
    connect(m_squeeze, &QPushButton::clicked, this, &EnrollSqueezePanel::squeeze);
    connect(m_arm, &QPushButton::clicked, this, [this] { m_workbench->arm(); });
    return card;
}

QWidget* EnrollSqueezePanel::makePart(QWidget* parent)
{
    auto* box = new QWidget(parent);
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 8);
    auto* name = makeLabel(tr("Part"), "caption", box);
    m_part = new QLineEdit(box);
    m_part->setObjectName("partField");
    m_part->setMaxLength(20);
    m_part->setPlaceholderText(tr("another one each time"));
    m_part->setAccessibleName(tr("Which part is squeezed"));
    m_part->setToolTip(
        tr("Give parts a number or a mark when you squeeze one more than once: the type then knows "
           "how much its parts differ, and how much only the grip."));
    name->setBuddy(m_part);
    row->addWidget(name);
    row->addWidget(m_part, 1);
    connect(m_part, &QLineEdit::textEdited, this,
            [this](const QString& part) { m_workbench->enrollment().setPart(part); });
    // Space then squeezes again.
    connect(m_part, &QLineEdit::returnPressed, this, &EnrollSqueezePanel::focusNext);
    return box;
}

QWidget* EnrollSqueezePanel::makeLast(QWidget* parent)
{
    auto* box = new QWidget(parent);
    auto* column = new QVBoxLayout(box);
    setSpacing(column, 0, 4);
    m_lastTitle = makeLabel({}, "strong", box);
    m_lastNumbers = makeLabel({}, "", box);
    m_lastNumbers->setObjectName("squeezeNumbers");
    m_lastNumbers->setWordWrap(true);
    m_lastWords = makeLabel({}, "caption", box);
    m_lastWords->setObjectName("squeezeWords");
    m_lastWords->setWordWrap(true);
    column->addWidget(m_lastTitle);
    column->addWidget(m_lastNumbers);
    column->addWidget(m_lastWords);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    m_accept = makeButton(tr("Accept"), u"dialog-ok-apply"_s, "primary", box);
    m_accept->setObjectName("acceptButton");
    m_reject = makeButton(tr("Reject"), u"dialog-cancel"_s, "", box);
    m_reject->setObjectName("rejectButton");
    row->addWidget(m_accept, 1);
    row->addWidget(m_reject, 1);
    column->addLayout(row);
    connect(m_accept, &QPushButton::clicked, this, &EnrollSqueezePanel::accept);
    connect(m_reject, &QPushButton::clicked, this, &EnrollSqueezePanel::reject);
    return box;
}

QWidget* EnrollSqueezePanel::makeTable()
{
    QFrame* card = makeCard(this);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 2, 0);
    m_title = makeLabel({}, "heading", card);
    m_advice = makeLabel({}, "caption", card);
    m_advice->setObjectName("adviceLabel");
    m_advice->setWordWrap(true);
    m_picture = new PartPictureView(*m_workbench, 64, PartPictureView::Empty::Hidden, card);
    auto* words = new QVBoxLayout;
    words->setSpacing(4);
    words->addWidget(m_title);
    words->addWidget(m_advice);
    words->addStretch(1);
    auto* head = new QHBoxLayout;
    head->setContentsMargins(16, 12, 16, 8);
    head->setSpacing(12);
    head->addWidget(m_picture, 0, Qt::AlignTop);
    head->addLayout(words, 1);
    m_table = new QTableView(card);
    m_table->setObjectName("squeezeTable");
    m_table->setAccessibleName(tr("Squeezes of this type"));
    m_table->setModel(&m_model);
    setUpRowList(m_table, 38);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed); // see spreadColumns()
    m_table->viewport()->installEventFilter(this);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &EnrollSqueezePanel::refresh);
    m_itself = new QCheckBox(tr("Accept good squeezes by itself"), card);
    m_itself->setObjectName("acceptByItself");
    m_itself->setToolTip(tr("A valid squeeze that goes with the others is accepted without asking; any other "
                            "waits for you. Ctrl+Z undoes it."));
    m_itself->setChecked(true);
    rememberChoice(m_itself);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(16, 8, 16, 12);
    foot->setSpacing(8);
    m_drop = makeButton(tr("Drop selected…"), u"edit-delete"_s, "", card);
    m_drop->setObjectName("dropButton");
    m_drop->setToolTip(
        tr("Takes an accepted squeeze out of the type, with a reason; the library keeps both"));
    m_review = makeButton(tr("Review"), {}, "", card);
    m_review->setObjectName("reviewButton");
    foot->addWidget(m_itself);
    foot->addStretch(1);
    foot->addWidget(m_drop);
    foot->addWidget(m_review);
    column->addLayout(head);
    column->addWidget(m_table, 1);
    column->addWidget(makeRule(card));
    column->addLayout(foot);
    connect(m_drop, &QPushButton::clicked, this, &EnrollSqueezePanel::askDrop);
    connect(m_review, &QPushButton::clicked, this, &EnrollSqueezePanel::review);
    return card;
}

void EnrollSqueezePanel::refresh()
{
    EnrollSession& session = m_workbench->enrollment();
    ConnectSession& connection = m_workbench->connection();
    using Activity = EnrollSession::Activity;
    const Activity activity = session.activity();
    const int rows = m_model.rowCount();
    refreshAdvice();
    if (m_model.rowCount() > rows)
        m_table->scrollToBottom();
    const int accepted = session.acceptedCount();
    m_title->setText(tr("Squeezes of %1").arg(session.typeName()));
    m_picture->setPicture(session.picture());
    const bool enough = accepted >= m_wanted;
    m_ring->setCount(accepted, std::max(accepted, m_wanted));
    m_ring->setRunning(activity == Activity::Squeezing ? session.progress() : -1);
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const bool ready = connected && (connection.armed() || !connection.identity().commandable);
    m_arm->setVisible(!ready && activity != Activity::Squeezing);
    m_arm->setEnabled(connected);
    m_squeeze->setVisible(ready || activity == Activity::Squeezing);
    m_squeeze->setEnabled(ready && activity == Activity::Waiting);
    m_squeeze->setText(activity == Activity::Squeezing ? tr("Squeezing…") : tr("Squeeze (Space)"));
    if (!connected)
        m_hint->setText(u"%1. %2."_s.arg(missingWords(connection).headline, missingWords(connection).detail));
    else if (!ready)
        m_hint->setText(tr("Place a part of this type, hands clear, then arm."));
    else if (enough)
        m_hint->setText(tr("Enough squeezes: review them now."));
    else
        m_hint->setText(tr("Turn or change the part between squeezes, so that the type's spread is seen."));
    const bool waiting = activity == Activity::Waiting;
    const QModelIndexList selected = m_table->selectionModel()->selectedRows();
    const int toDrop = rowToDrop();
    m_drop->setText(selected.isEmpty() && toDrop >= 0 ? tr("Drop outlier %1…").arg(toDrop + 1)
                                                      : tr("Drop selected…"));
    m_drop->setEnabled(waiting && toDrop >= 0 && m_model.isAccepted(toDrop));
    m_review->setEnabled(waiting && accepted >= EnrollSession::leastSqueezes);
    m_review->setToolTip(
        accepted >= EnrollSession::leastSqueezes
            ? QString()
            : tr("A type needs at least %1 accepted squeezes").arg(EnrollSession::leastSqueezes));
    const char* look = enough ? "primary" : "";
    if (m_review->property("role").toString() != QLatin1String(look))
        setRole(m_review, look);
    acceptByItself();
    refreshLast();
    if (activity != m_shown || ready != m_ready) {
        m_shown = activity;
        m_ready = ready;
        if (isVisible())
            focusNext();
    }
}

void EnrollSqueezePanel::refreshAdvice()
{
    const EnrollSession& session = m_workbench->enrollment();
    if (session.activity() != EnrollSession::Activity::Squeezing)
        m_advisor.follow();
    if (m_part->text().trimmed() != session.part())
        m_part->setText(session.part());
    const std::optional<EnrollmentAdvice>& advice = m_advisor.advice();
    std::map<int, QString> outliers;
    if (session.squeezes().empty())
        m_wanted = EnrollSession::suggestedSqueezes; // of the enrolment before
    if (advice) {
        m_wanted = squeezesWanted(advice->progress);
        m_advice->setText(described(inWords(advice->progress)).join(u' '));
        for (const auto& [row, outlier] : advice->outliers)
            outliers.emplace(row, outlier.reason.describe());
    }
    m_advice->setVisible(session.acceptedCount() > 0 && !m_advice->text().isEmpty());
    const bool changed = m_model.refresh(session.squeezes(), outliers);
    m_table->setColumnHidden(static_cast<int>(EnrollSqueezeModel::Column::Part), !m_model.hasParts());
    if (changed)
        spreadColumns(m_table);
}

bool EnrollSqueezePanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && watched == m_table->viewport())
        spreadColumns(m_table);
    return QWidget::eventFilter(watched, event);
}

int EnrollSqueezePanel::rowToDrop() const
{
    const QModelIndexList selected = m_table->selectionModel()->selectedRows();
    if (!selected.isEmpty())
        return selected.first().row();
    if (m_advisor.advice())
        for (const auto& [row, outlier] : m_advisor.advice()->outliers)
            if (m_model.isAccepted(row))
                return row;
    return -1;
}

QString EnrollSqueezePanel::outlierReason(int row) const
{
    if (!m_advisor.advice())
        return {};
    const auto found = m_advisor.advice()->outliers.find(row);
    return found == m_advisor.advice()->outliers.end() ? QString() : found->second.reason.describe();
}

bool EnrollSqueezePanel::decidesByItself() const
{
    const EnrollSession& session = m_workbench->enrollment();
    const std::vector<EnrollSqueeze>& squeezes = session.squeezes();
    if (!m_itself->isChecked() || session.activity() != EnrollSession::Activity::Deciding ||
        m_ownSqueeze != static_cast<int>(squeezes.size()) - 1)
        return false;
    const EnrollSqueeze& last = squeezes.back();
    return last.reason.isEmpty() && last.identification.validity.verdict == ValidityVerdict::Valid &&
           outlierReason(m_ownSqueeze).isEmpty();
}

void EnrollSqueezePanel::acceptByItself()
{
    // Whether it goes with the others is known once the advice is there.
    if (!decidesByItself() || !m_advisor.advice())
        return;
    leaveToPerson(); // should the library refuse it
    if (const Expected<void> done = m_workbench->enrollment().accept(); !done)
        m_workbench->messages().report(done.error().describe());
}

bool EnrollSqueezePanel::showLive()
{
    const EnrollSession& session = m_workbench->enrollment();
    if (session.activity() != EnrollSession::Activity::Squeezing)
        return false;
    const LiveEstimate& estimate = m_workbench->live().estimate();
    const GripperIdentity identity = m_workbench->connection().identity();
    const LiveSqueezeWords live = liveSqueezeWords(estimate.following() ? estimate.state() : std::nullopt,
                                                   identity.forceUnit, identity.positionUnit);
    m_lastTitle->setText(tr("Squeeze %1, so far").arg(session.squeezes().size() + 1));
    m_lastNumbers->setText(live.numbers);
    m_lastNumbers->show();
    m_lastWords->setText(live.quality);
    return true;
}

void EnrollSqueezePanel::refreshLast()
{
    const EnrollSession& session = m_workbench->enrollment();
    const std::vector<EnrollSqueeze>& squeezes = session.squeezes();
    const bool deciding = session.activity() == EnrollSession::Activity::Deciding && !decidesByItself();
    m_accept->setVisible(deciding);
    m_reject->setVisible(deciding);
    if (showLive())
        return;
    if (session.activity() == EnrollSession::Activity::Identifying) {
        m_lastTitle->setText(tr("Finding m, b and k…"));
        return;
    }
    if (squeezes.empty()) {
        m_lastTitle->setText(tr("No squeeze yet"));
        m_lastNumbers->hide();
        m_lastWords->setText(tr("At least %1 are needed, 4 for the first type of a library; the ring is full "
                                "when more would gain little.")
                                 .arg(EnrollSession::leastSqueezes));
        return;
    }
    const EnrollSqueeze& last = squeezes.back();
    m_accept->setEnabled(last.reason.isEmpty());
    const QString numbers = numbersOf(last);
    m_lastTitle->setText(tr("Squeeze %1: %2").arg(squeezes.size()).arg(validityWord(last)));
    m_lastNumbers->setVisible(!numbers.isEmpty());
    m_lastNumbers->setText(numbers);
    m_lastWords->setText(
        last.decision == EnrollSqueeze::Decision::Rejected ? tr("Rejected: %1").arg(last.reason)
        : !last.reason.isEmpty()                           ? last.reason
        : deciding && !outlierReason(static_cast<int>(squeezes.size()) - 1).isEmpty()
            ? tr("It does not go with the others. %1 Accept it only if such parts belong to the type.")
                  .arg(outlierReason(static_cast<int>(squeezes.size()) - 1))
        : deciding                                          ? tr("Accept it (Space) or reject it.")
        : last.decision == EnrollSqueeze::Decision::Pending ? tr("Being accepted…")
                                                            : tr("Accepted and stored."));
}

void EnrollSqueezePanel::focusNext()
{
    switch (m_workbench->enrollment().activity()) {
    case EnrollSession::Activity::Deciding:
        (m_accept->isEnabled() ? m_accept : m_reject)->setFocus();
        break;
    case EnrollSession::Activity::Waiting:
        (m_squeeze->isEnabled() ? m_squeeze : m_arm)->setFocus();
        break;
    default:
        if (parentWidget())
            parentWidget()->setFocus();
        break;
    }
}

void EnrollSqueezePanel::squeezeOrAccept()
{
    const EnrollSession& session = m_workbench->enrollment();
    if (session.activity() == EnrollSession::Activity::Deciding) {
        if (m_accept->isEnabled())
            accept();
    } else if (session.activity() == EnrollSession::Activity::Waiting) {
        squeeze();
    }
}

void EnrollSqueezePanel::tell(const Expected<void>& done)
{
    if (!done)
        m_workbench->messages().report(done.error().describe());
    emit changed();
}

void EnrollSqueezePanel::squeeze()
{
    if (m_workbench->busyWithSqueeze())
        return;
    m_ownSqueeze = static_cast<int>(m_workbench->enrollment().squeezes().size());
    tell(m_workbench->enrollment().squeeze());
}

void EnrollSqueezePanel::setAcceptsByItself(bool on)
{
    m_itself->setChecked(on);
}

void EnrollSqueezePanel::accept()
{
    tell(m_workbench->enrollment().accept());
}

void EnrollSqueezePanel::reject()
{
    const std::vector<EnrollSqueeze>& squeezes = m_workbench->enrollment().squeezes();
    const bool advised = !squeezes.empty() && !squeezes.back().reason.isEmpty();
    tell(m_workbench->enrollment().reject(advised ? QString() : tr("by the operator")));
}

void EnrollSqueezePanel::askDrop()
{
    const int row = rowToDrop();
    if (row < 0)
        return;
    auto* dialog = new TextQuestion(tr("Drop squeeze %1").arg(row + 1),
                                    tr("Why is squeeze %1 dropped? The reason is kept.").arg(row + 1),
                                    outlierReason(row), tr("Drop"), this);
    dialog->setObjectName("dropDialog");
    connect(dialog, &TextQuestion::answered, this, [this, row](const QString& reason) {
        const QString why = reason.trimmed().isEmpty() ? tr("by the operator") : reason.trimmed();
        authorize(*m_workbench, this, Permission::DropSqueezes,
                  [this, row, why] { tell(m_workbench->enrollment().drop(row, why)); });
    });
    dialog->open();
}

void EnrollSqueezePanel::review()
{
    tell(m_workbench->enrollment().review());
}

} // namespace gripscope
