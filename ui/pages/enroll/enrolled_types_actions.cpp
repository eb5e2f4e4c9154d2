// SPDX-License-Identifier: GPL-3.0-or-later
// What the dialog of enrolled types does to them: asks first, then changes the library on its thread.
#include "core/library/sql/time_ordered_id.h"
#include "ui/context/workbench.h"
#include "ui/pages/enroll/enroll_picture_field.h"
#include "ui/pages/enroll/enrolled_types_dialog.h"
#include "ui/pages/shared/type_limits_dialog.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/plain_text.h"

#include <QLabel>
#include <QVBoxLayout>

namespace gripscope {

namespace {

/// Holds the field in which a type's picture is chosen.
class TypePictureDialog : public Dialog {
public:
    using Dialog::Dialog;
};
const RegisteredDialog<TypePictureDialog> pictureRow("type picture", [](Workbench& bench, QWidget* over) {
    auto* dialog = new TypePictureDialog(over);
    auto* column = new QVBoxLayout(dialog);
    column->addWidget(new EnrollPictureField(bench, dialog));
    return dialog;
});

/// The lists are read again anyway.
constexpr auto ignoreValue = [](const auto&) {};

} // namespace

ChangeNote EnrolledTypesDialog::note(const TypeChangeForm& form) const
{
    return {m_workbench->operatorName(), form.reason()};
}

void EnrolledTypesDialog::change(Change work)
{
    m_workbench->background().ask<void>(this, std::move(work), [this](const Expected<void>& done) {
        if (!done) {
            m_state->setText(done.error().describe());
            return;
        }
        m_workbench->tellLibraryChanged();
        load();
    });
}

void EnrolledTypesDialog::changeSupervised(Change work, Permission permission)
{
    authorize(*m_workbench, this, permission, [this, work = std::move(work)] { change(work); });
}

void EnrolledTypesDialog::choosePicture()
{
    auto* dialog = new TypePictureDialog(this);
    dialog->setObjectName("typePictureDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(titleText(tr("Picture of %1").arg(selectedType()->name)));
    auto* column = new QVBoxLayout(dialog);
    setSpacing(column, 24, 16);
    auto* field = new EnrollPictureField(*m_workbench, dialog);
    QPushButton* close = makeButton(tr("Close"), {}, "primary", dialog);
    column->addWidget(field);
    column->addWidget(close, 0, Qt::AlignRight);
    connect(close, &QPushButton::clicked, dialog, &QDialog::accept);
    connect(field, &EnrollPictureField::chosen, this,
            [this, id = selectedType()->id](std::optional<PartPicture> picture) {
                if (picture)
                    picture->id = newTimeOrderedId();
                change([id, picture, who = m_workbench->operatorName()](Library& library) {
                    return library.atOnce([&]() -> Expected<void> {
                        if (picture)
                            RETURN_IF_ERROR(library.addPicture(*picture));
                        return library.setTypePicture(id, picture ? picture->id : QString(), who);
                    });
                });
            });
    m_workbench->background().ask<std::optional<PartPicture>>(
        field, [id = selectedType()->id](Library& library) { return library.typePicture(id); },
        [field](const Expected<std::optional<PartPicture>>& picture) {
            if (picture)
                field->showPicture(*picture);
        });
    dialog->resize(560, 200);
    dialog->open();
}

void EnrolledTypesDialog::rename()
{
    const TypeRecord type = *selectedType();
    auto* form = new TypeChangeForm(
        tr("Rename %1").arg(type.name),
        tr("Verdicts say the new name from now on. Inspections that were made keep “%1”.").arg(type.name),
        tr("Rename"), this);
    form->askName(tr("New name"), type.name);
    connect(form, &QDialog::accepted, this, [this, form, type] {
        changeSupervised([id = type.id, name = form->name(), why = note(*form)](Library& library) {
            return library.renameType(id, name, why).map(ignoreValue);
        });
    });
    form->open();
}

void EnrolledTypesDialog::editCode()
{
    const TypeRecord type = *selectedType();
    auto* form = new TypeChangeForm(
        tr("Code of %1").arg(type.name),
        tr("What a scanner reads on its parts or on its order: a GTIN, a part number. Scanned on the Inspect "
           "page, it makes %1 the expected type. Leave it empty to take the code away.")
            .arg(type.name),
        tr("Keep"), this);
    form->askCode(tr("Code, scanned or typed"), type.code);
    connect(form, &QDialog::accepted, this, [this, form, type] {
        changeSupervised([id = type.id, code = form->code(), why = note(*form)](Library& library) {
            return library.setTypeCode(id, code, why).map(ignoreValue);
        });
    });
    form->open();
}

void EnrolledTypesDialog::editLimits()
{
    auto* dialog = new TypeLimitsDialog(*m_workbench, selectedType()->name, this);
    connect(dialog, &QDialog::accepted, this, &EnrolledTypesDialog::load);
    dialog->open();
}

void EnrolledTypesDialog::merge()
{
    const TypeRecord type = *selectedType();
    QStringList others;
    for (const TypeRecord& other : m_contents.types)
        if (other.id != type.id && other.status != TypeStatus::Retired)
            others.append(other.name);
    auto* form = new TypeChangeForm(
        tr("Merge %1 into another type").arg(type.name),
        tr("The %1 squeezes of %2 will count for the other type, and %2 is no longer a type of its own. The "
           "other "
           "type needs approval again. Merge only types that are squeezed by the same recipe.")
            .arg(type.squeezes)
            .arg(type.name),
        tr("Merge"), this);
    form->askType(tr("The type that stays"), others);
    connect(form, &QDialog::accepted, this, [this, form, type] {
        QString into;
        for (const TypeRecord& other : m_contents.types)
            if (other.name == form->type())
                into = other.id;
        changeSupervised([id = type.id, into, why = note(*form)](Library& library) {
            return library.mergeTypes(id, into, why).map(ignoreValue);
        });
    });
    form->open();
}

void EnrolledTypesDialog::split()
{
    const TypeRecord type = *selectedType();
    using Grasps = std::vector<GraspRecord>;
    m_workbench->background().ask<Grasps>(
        this, [id = type.id](Library& library) { return library.grasps(id); },
        [this, type](const Expected<Grasps>& grasps) {
            if (!grasps) {
                m_state->setText(grasps.error().describe());
                return;
            }
            auto* form = new TypeChangeForm(
                tr("Split %1").arg(type.name),
                tr("The squeezes that you tick become a new type with the same recipe. Both types then need "
                   "approval."),
                tr("Split"), this);
            form->askName(tr("Name of the new type"));
            form->askSqueezes(tr("Squeezes of the new type"), *grasps);
            connect(form, &QDialog::accepted, this, [this, form, type] {
                changeSupervised([id = type.id, name = form->name(), squeezes = form->squeezes(),
                                  why = note(*form)](Library& library) {
                    return library.splitType(id, squeezes, name, why).map(ignoreValue);
                });
            });
            form->open();
        });
}

void EnrolledTypesDialog::approve()
{
    askWhy(this, m_approve->text(), [this, id = selectedType()->id](const QString& reason) {
        changeSupervised([id, reason, who = m_workbench->operatorName()](
                             Library& library) { return library.approveType(id, who, reason); },
                         Permission::ApproveTypes);
    });
}

void EnrolledTypesDialog::retire()
{
    const TypeRecord type = *selectedType();
    auto* form = new TypeChangeForm(tr("Retire %1").arg(type.name),
                                    tr("Parts of %1 are no longer recognised: they will be unknown. Its %2 "
                                       "squeezes are kept, and it can be "
                                       "put back.")
                                        .arg(type.name, QString::number(type.squeezes)),
                                    tr("Retire"), this);
    connect(form, &QDialog::accepted, this, [this, form, type] {
        changeSupervised(
            [id = type.id, why = note(*form)](Library& library) { return library.retireType(id, why); });
    });
    form->open();
}

void EnrolledTypesDialog::putBack()
{
    const TypeRecord type = *selectedType();
    auto* form = new TypeChangeForm(
        tr("Put %1 back into use").arg(type.name),
        tr("Parts of %1 are recognised again. The type then needs approval.").arg(type.name), tr("Put back"),
        this);
    connect(form, &QDialog::accepted, this, [this, form, type] {
        changeSupervised(
            [id = type.id, why = note(*form)](Library& library) { return library.reinstateType(id, why); });
    });
    form->open();
}

void EnrolledTypesDialog::restoreSelected()
{
    restore(selectedVersion()->version);
}

void EnrolledTypesDialog::undo()
{
    restore(m_contents.version - 1);
}

void EnrolledTypesDialog::restore(qint64 version)
{
    const qint64 since = m_contents.version - version;
    const QString done =
        since == 1 ? inWords(m_contents.changes.front()) : tr("%1 changes were made since.").arg(since);
    auto* form = new TypeChangeForm(
        tr("Restore version %1").arg(version),
        tr("%1 Types and squeezes will again be as they were at version %2. Nothing is deleted: this is a "
           "new "
           "version, and what was done since can be restored in turn. Inspections are not touched.")
            .arg(done)
            .arg(version),
        tr("Restore"), this);
    connect(form, &QDialog::accepted, this, [this, form, version] {
        changeSupervised([version, why = note(*form)](Library& library) {
            return library.restoreVersion(version, why).map(ignoreValue);
        });
    });
    form->open();
}

} // namespace gripscope
