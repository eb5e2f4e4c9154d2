// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/csv.h"
#include "core/library/library.h"
#include "core/library/verification/library_verification.h"
#include "core/people/permission.h"
#include "ui/context/workbench.h"
#include "ui/format/date_text.h"
#include "ui/format/number_format.h"
#include "ui/people/people_dialogs.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/row_list.h"
#include "ui/windows/file_dialog.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QSaveFile>
#include <QStringList>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// What a consent was to is kept by its id.
QString subjectInWords(const AuditEntry& entry)
{
    if (entry.action == QString::fromUtf16(audit_action::authorised)) {
        if (const std::optional<Permission> permission = permissionFromString(entry.subject))
            return inWords(*permission);
    }
    return entry.subject;
}

} // namespace

void AuditModel::restart(qint64 total, std::vector<AuditEntry> page)
{
    beginResetModel();
    m_rows = std::move(page);
    m_total = total;
    m_waiting = false;
    endResetModel();
}

void AuditModel::append(int offset, const std::vector<AuditEntry>& page)
{
    const int first = rowCount();
    if (offset != first)
        return;
    m_waiting = false;
    if (page.empty()) {
        m_total = first;
        return;
    }
    beginInsertRows({}, first, first + static_cast<int>(page.size()) - 1);
    m_rows.insert(m_rows.end(), page.begin(), page.end());
    endInsertRows();
}

bool AuditModel::canFetchMore(const QModelIndex& parent) const
{
    return !parent.isValid() && !m_waiting && rowCount() < m_total;
}

void AuditModel::fetchMore(const QModelIndex& parent)
{
    if (!canFetchMore(parent))
        return;
    m_waiting = true;
    emit pageAsked(rowCount());
}

QString AuditModel::text(const AuditEntry& entry, Column column)
{
    switch (column) {
    case Column::Number:
        return QString::number(entry.number);
    case Column::Time:
        return exactTimeText(QDateTime::fromString(entry.utc, Qt::ISODateWithMs));
    case Column::Person: {
        const std::optional<Role> role = roleFromString(entry.role);
        return role ? tr("%1 (%2)").arg(entry.person, inWords(*role)) : entry.person;
    }
    case Column::Action:
        return actionInWords(entry.action);
    case Column::Subject:
        return subjectInWords(entry);
    case Column::Reason:
        return entry.reason;
    case Column::Details:
        return detailsInWords(entry);
    case Column::Station:
        return entry.station;
    }
    return {};
}

QVariant AuditModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const AuditEntry& row = entry(index.row());
    const auto column = static_cast<Column>(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return text(row, column);
    case Qt::EditRole:
        return column == Column::Number ? QVariant(row.number) : QVariant(text(row, column));
    case Qt::ToolTipRole:
        return column == Column::Time ? row.utc : text(row, column);
    case Qt::TextAlignmentRole:
        return static_cast<int>(Qt::AlignVCenter |
                                (column == Column::Number ? Qt::AlignRight : Qt::AlignLeft));
    default:
        return {};
    }
}

QVariant AuditModel::head(int section, int role) const
{
    const auto column = static_cast<Column>(section);
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignVCenter |
                                (column == Column::Number ? Qt::AlignRight : Qt::AlignLeft));
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case Column::Number:
        return tr("No.");
    case Column::Time:
        return tr("Time");
    case Column::Person:
        return tr("Who");
    case Column::Action:
        return tr("What");
    case Column::Subject:
        return tr("To what");
    case Column::Reason:
        return tr("Why");
    case Column::Details:
        return tr("Details");
    case Column::Station:
        return tr("Station");
    }
    return {};
}

QByteArray toCsv(const std::vector<AuditEntry>& entries)
{
    QString text =
        u"number,time_utc,station,person,role,action,subject,reason,details,previous_hash,hash\n"_s;
    for (const AuditEntry& entry : entries) {
        QStringList line;
        for (const QString& cell :
             {QString::number(entry.number), entry.utc, entry.station, entry.person, entry.role, entry.action,
              entry.subject, entry.reason, entry.details, entry.previousHash, entry.hash})
            line << csvCell(cell);
        text += line.join(u',') + u'\n';
    }
    return text.toUtf8();
}

Expected<QByteArray> auditCsv(Library& library)
{
    ASSIGN_OR_RETURN(auto entries,
                     library.auditTrail().entries({{}, {}, std::numeric_limits<int>::max(), 0}));
    std::reverse(entries.begin(), entries.end());
    return toCsv(entries);
}

using namespace std::chrono_literals;

namespace {

/// What one visit to the library brings back.
struct TrailStart {
    qint64 matching = 0;
    std::vector<AuditEntry> page;
};

const RegisteredDialog<AuditDialog> auditDialogRow("audit", [](Workbench& bench, QWidget* over) {
    return new AuditDialog(bench, over);
});
} // namespace

AuditDialog::AuditDialog(Workbench& workbench, QWidget* parent)
    : Dialog(parent), m_workbench(&workbench), m_model(new AuditModel(this)), m_table(new QTableView(this)),
      m_text(new QLineEdit(this)), m_action(new QComboBox(this)),
      m_verify(makeButton(tr("Verify"), u"checkmark"_s, "", this)), m_counts(makeLabel({}, "second", this)),
      m_result(makeLabel({}, "", this))
{
    setObjectName("auditDialog");
    setManualPage(u"people"_s);
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Audit trail"));
    m_typing.setSingleShot(true);
    m_typing.setInterval(250ms);
    m_result->setObjectName("auditResult");
    m_result->setWordWrap(true);
    m_result->hide();
    makeTable();
    QFrame* card = makeCard(this);
    auto* inside = new QVBoxLayout(card);
    setSpacing(inside, 1, 0);
    inside->addWidget(m_table);
    QPushButton* save = makeButton(tr("Export…"), u"document-save"_s, "", this);
    save->setObjectName("auditExport");
    save->setAutoDefault(false);
    QPushButton* close = makeButton(tr("Close"), {}, "primary", this);
    close->setAutoDefault(false);
    auto* foot = new QHBoxLayout;
    foot->setSpacing(8);
    foot->addWidget(m_counts, 1);
    foot->addWidget(save);
    foot->addWidget(close);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 12);
    column->addWidget(makeBar());
    column->addWidget(m_result);
    column->addWidget(card, 1);
    column->addLayout(foot);
    connect(&m_typing, &QTimer::timeout, this, &AuditDialog::reload);
    connect(m_model, &AuditModel::pageAsked, this, &AuditDialog::fetch);
    connect(save, &QPushButton::clicked, this, &AuditDialog::chooseExport);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    resize(960, 560);
    m_text->setFocus();
    reload();
}

QWidget* AuditDialog::makeBar()
{
    auto* bar = new QWidget(this);
    auto* line = new QHBoxLayout(bar);
    setSpacing(line, 0, 8);
    m_text->setObjectName("auditText");
    m_text->setPlaceholderText(tr("Filter by person, type, reason or station"));
    m_text->setAccessibleName(tr("Filter text"));
    m_text->setClearButtonEnabled(true);
    m_action->setObjectName("auditAction");
    m_action->setAccessibleName(tr("What"));
    m_action->addItem(tr("Everything"), QString());
    m_action->addItem(tr("Signing in and out"), u"sign_"_s);
    m_action->addItem(tr("Authorisations"), QString::fromUtf16(audit_action::authorised));
    m_action->addItem(tr("People"), u"person."_s);
    m_action->addItem(tr("Arming"), QString::fromUtf16(audit_action::gripperArmed));
    m_action->addItem(tr("Inspections"), u"inspection."_s);
    m_action->addItem(tr("Types"), QString::fromUtf16(audit_action::typePrefix));
    m_action->addItem(tr("Rates"), u"rates."_s);
    m_action->addItem(tr("Calibrations"), u"calibration."_s);
    m_action->addItem(tr("Settings"), u"setting."_s);
    m_action->addItem(tr("Batches"), u"batch."_s);
    m_action->addItem(tr("Exports"), u"export."_s);
    m_action->addItem(tr("Library"), u"library."_s);
    m_verify->setObjectName("auditVerify");
    m_verify->setAutoDefault(false);
    m_verify->setToolTip(
        tr("Read all of the library and check that no row was changed, removed or put in past the program"));
    line->addWidget(m_text, 1);
    line->addWidget(m_action);
    line->addWidget(m_verify);
    connect(m_text, &QLineEdit::textChanged, &m_typing, qOverload<>(&QTimer::start));
    connect(m_action, &QComboBox::currentIndexChanged, this, &AuditDialog::reload);
    connect(m_verify, &QPushButton::clicked, this, &AuditDialog::verify);
    return bar;
}

void AuditDialog::makeTable()
{
    m_table->setObjectName("auditTable");
    m_table->setAccessibleName(tr("Audit trail"));
    m_table->setModel(m_model);
    setUpRowList(m_table, 32);
    // Of fixed widths: to measure the texts of a long trail would take the screen's time.
    const int widths[AuditModel::columns] = {64, 168, 152, 192, 168, 160, 240, 160};
    for (int column = 0; column < AuditModel::columns; ++column)
        m_table->setColumnWidth(column, widths[column]);
}

AuditFilter AuditDialog::filter(int offset) const
{
    return {m_text->text(), m_action->currentData().toString(), AuditModel::pageSize, offset};
}

void AuditDialog::reload()
{
    m_workbench->background().ask<TrailStart>(
        this,
        [wanted = filter()](Library& library) -> Expected<TrailStart> {
            ASSIGN_OR_RETURN(const auto matching, library.auditTrail().count(wanted));
            ASSIGN_OR_RETURN(auto page, library.auditTrail().entries(wanted));
            return TrailStart{matching, std::move(page)};
        },
        [this, generation = ++m_generation](Expected<TrailStart> start) {
            if (generation != m_generation)
                return;
            if (!start)
                return m_counts->setText(start.error().describe());
            m_model->restart(start->matching, std::move(start->page));
            const bool all = m_text->text().trimmed().isEmpty() && m_action->currentIndex() == 0;
            m_counts->setText(
                start->matching > 0 ? tr("Entries: %1").arg(formatCount(start->matching))
                : all ? tr("Nothing yet: changes of types, rates and calibrations, and who signs in, "
                           "will be here.")
                      : tr("Nothing matches the filters."));
        });
}

void AuditDialog::fetch(int offset)
{
    using Page = std::vector<AuditEntry>;
    m_workbench->background().ask<Page>(
        this, [wanted = filter(offset)](Library& library) { return library.auditTrail().entries(wanted); },
        [this, offset, generation = m_generation](const Expected<Page>& page) {
            if (generation == m_generation)
                m_model->append(offset, page.value_or(Page{}));
        });
}

void AuditDialog::verify()
{
    m_verify->setEnabled(false);
    setRole(m_result, "second");
    m_result->setText(tr("Reading all of the library…"));
    m_result->show();
    // Beside the library's own thread, which goes on storing meanwhile.
    m_workbench->background().compute<Expected<LibraryVerification>>(
        this, [file = m_workbench->library().file()] { return verifyLibrary(file); },
        [this](const Expected<LibraryVerification>& found) {
            const bool whole = found && found->whole();
            setRole(m_result, whole ? "strong" : "error");
            m_result->setText(found ? inWords(*found) : found.error().describe());
            m_result->show();
            m_verify->setEnabled(true);
            m_verify->setFocus(); // it went elsewhere while it was disabled
        });
}

void AuditDialog::chooseExport()
{
    auto* dialog =
        new FileDialog(this, tr("Export the audit trail"), u"audit-trail.csv"_s, tr("CSV (*.csv)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(u"csv"_s);
    connect(dialog, &QFileDialog::fileSelected, this, &AuditDialog::exportTo);
    dialog->open();
}

void AuditDialog::exportTo(const QString& file)
{
    m_workbench->background().ask<void>(
        this,
        [file](Library& library) -> Expected<void> {
            ASSIGN_OR_RETURN(const QByteArray csv, auditCsv(library));
            QSaveFile out(file);
            if (!out.open(QIODevice::WriteOnly) || out.write(csv) != csv.size())
                return failure(ErrorCode::FileUnwritable, {file, out.errorString()});
            RETURN_IF_ERROR(library.tellExport(file, u"audit trail"_s, csv.count('\n') - 1));
            if (!out.commit())
                return failure(ErrorCode::FileUnwritable, {file, out.errorString()});
            return {};
        },
        [this, file](const Expected<void>& done) {
            m_counts->setText(done ? tr("Audit trail written to %1").arg(file) : done.error().describe());
        });
}

} // namespace gripscope
