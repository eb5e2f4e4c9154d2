// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/enroll/enroll_name_step.h"

#include "ui/context/workbench.h"
#include "ui/pages/enroll/enroll_picture_field.h"
#include "ui/pages/enroll/enrolled_types_dialog.h"
#include "ui/widgets/controls.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QHBoxLayout* centred(QWidget* card)
{
    card->setMaximumWidth(680);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(card, 8);
    row->addStretch(1);
    return row;
}

} // namespace

QVBoxLayout* makeFormCard(QWidget* step)
{
    QFrame* card = makeCard(step);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 24, 12);
    auto* outer = new QVBoxLayout(step);
    setSpacing(outer, 0, 0);
    outer->addLayout(centred(card));
    outer->addStretch(1);
    return column;
}

EnrollNameStep::EnrollNameStep(Workbench& workbench, QWidget* parent)
    : QScrollArea(parent), m_workbench(&workbench)
{
    auto* content = new QWidget(this);
    m_drafts = new EnrollDrafts(workbench, content);
    auto* column = new QVBoxLayout(content);
    setSpacing(column, 0, 16);
    column->addLayout(centred(m_drafts));
    column->addWidget(makeForm(content));
    column->addStretch(1);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(content);
    connect(m_drafts, &EnrollDrafts::goOn, this, &EnrollNameStep::goOn);
    connect(m_drafts, &EnrollDrafts::changed, this, &EnrollNameStep::refresh);
    refresh();
}

QWidget* EnrollNameStep::makeForm(QWidget* parent)
{
    auto* form = new QWidget(parent);
    QVBoxLayout* column = makeFormCard(form);
    column->addWidget(makeLabel(tr("What is the type called?"), "heading", form));
    auto* why = makeLabel(tr("As a technician would say it, for instance “Cola 330 ml”. The name appears in "
                             "large letters when a part of this type is inspected."),
                          "second", form);
    why->setWordWrap(true);
    column->addWidget(why);
    m_name = new QLineEdit(form);
    m_name->setObjectName("typeName");
    m_name->setMaxLength(60);
    m_name->setAccessibleName(tr("Name of the type"));
    m_name->setPlaceholderText(tr("Name of the type"));
    column->addWidget(m_name);
    m_hint = makeLabel({}, "second", form);
    m_hint->setObjectName("nameHint");
    m_hint->setWordWrap(true);
    column->addWidget(m_hint);
    m_picture = new EnrollPictureField(*m_workbench, form);
    m_picture->setObjectName("pictureField");
    column->addWidget(m_picture);
    m_next = makeButton(tr("Continue (Enter)"), {}, "primary", form);
    m_next->setObjectName("nameNext");
    QPushButton* types = makeButton(tr("Enrolled types…"), {}, "", form);
    types->setObjectName("enrolledTypesButton");
    types->setToolTip(tr("Rename, merge, split or retire types; undo changes"));
    auto* row = new QHBoxLayout;
    row->addWidget(types);
    row->addStretch(1);
    row->addWidget(m_next);
    column->addLayout(row);
    connect(types, &QPushButton::clicked, this,
            [this] { (new EnrolledTypesDialog(*m_workbench, this))->open(); });
    connect(m_name, &QLineEdit::textChanged, this, &EnrollNameStep::refresh);
    connect(m_next, &QPushButton::clicked, this, &EnrollNameStep::submit);
    connect(m_picture, &EnrollPictureField::chosen, this, [this](const std::optional<PartPicture>& picture) {
        m_workbench->enrollment().setPicture(picture);
    });
    return form;
}

QString EnrollNameStep::suggestion() const
{
    QStringList taken = m_drafts->names();
    for (const TypeRecord& type : m_workbench->inspection().types())
        taken << type.name;
    int number = 1;
    while (taken.contains(tr("Type %1").arg(number)))
        ++number;
    return tr("Type %1").arg(number);
}

void EnrollNameStep::begin()
{
    m_suggested.clear();
    m_name->clear();
    m_picture->clear();
    m_drafts->load();
    refresh();
}

void EnrollNameStep::refresh()
{
    if (m_name->text() == m_suggested) {
        const QString better = suggestion();
        if (better != m_suggested) {
            m_suggested = better;
            m_name->setText(better); // comes back here
            m_name->selectAll();
            return;
        }
    }
    const QString name = m_name->text().trimmed();
    m_next->setEnabled(!name.isEmpty());
    QString hint;
    for (const TypeRecord& type : m_workbench->inspection().types())
        if (type.name == name)
            hint = tr("This type is known (squeezes so far: %1). The enrolment goes on with its own recipe.")
                       .arg(type.squeezes);
    if (hint.isEmpty() && m_drafts->names().contains(name))
        hint = tr("This enrolment was begun before. It goes on with the squeezes that it has.");
    m_hint->setText(hint);
    m_hint->setVisible(!hint.isEmpty());
    m_picture->showPicture(m_workbench->enrollment().picture());
}

void EnrollNameStep::submit()
{
    if (!m_name->text().trimmed().isEmpty())
        emit named(m_name->text());
}

void EnrollNameStep::focusField()
{
    m_name->setFocus();
    if (m_name->text() == m_suggested)
        m_name->selectAll(); // typing replaces it
}

} // namespace gripscope
