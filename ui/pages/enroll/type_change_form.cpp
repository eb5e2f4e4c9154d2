// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/parameter_text.h"
#include "ui/pages/enroll/enrolled_types_dialog.h"
#include "ui/widgets/controls.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
const RegisteredDialog<TypeChangeForm> typeChangeFormRow("type change", [](Workbench&, QWidget* over) {
    auto* form = new TypeChangeForm(u"Rename A"_s, u"Verdicts say the new name."_s, u"Rename"_s, over);
    form->askName(u"New name"_s);
    return form;
});
} // namespace

TypeChangeForm::TypeChangeForm(const QString& title, const QString& consequence, const QString& verb,
                               QWidget* parent)
    : Dialog(parent), m_fields(new QVBoxLayout), m_reason(new QLineEdit(this)),
      m_accept(makeButton(verb, {}, "primary", this))
{
    setObjectName("typeChangeForm");
    setManualPage(u"enroll"_s);
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 16);
    column->addWidget(makeLabel(title, "heading", this));
    QLabel* words = makeLabel(consequence, "", this);
    words->setObjectName("consequence");
    words->setWordWrap(true);
    column->addWidget(words);
    m_fields->setSpacing(4);
    column->addLayout(m_fields, 1);
    m_reason->setObjectName("reasonField");
    m_reason->setMaxLength(200);
    m_reason->setAccessibleName(tr("Why"));
    column->addWidget(makeLabel(tr("Why? The reason is kept with the change."), "caption", this));
    column->addWidget(m_reason);
    auto* row = new QHBoxLayout;
    QPushButton* cancel = makeButton(tr("Cancel"), {}, "", this);
    cancel->setAutoDefault(false);
    m_accept->setObjectName("changeAccept");
    m_accept->setDefault(true);
    row->addStretch(1);
    row->addWidget(cancel);
    row->addWidget(m_accept);
    column->addLayout(row);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_accept, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_reason, &QLineEdit::textChanged, this, &TypeChangeForm::refresh);
    resize(480, sizeHint().height());
    refresh();
}

void TypeChangeForm::addField(const QString& label, QWidget* field)
{
    field->setAccessibleName(label);
    m_fields->addWidget(makeLabel(label, "caption", this));
    m_fields->addWidget(field);
    refresh();
}

void TypeChangeForm::askName(const QString& label, const QString& initial)
{
    m_name = new QLineEdit(initial, this);
    m_name->setObjectName("nameField");
    m_name->setMaxLength(60);
    m_name->selectAll();
    connect(m_name, &QLineEdit::textChanged, this, &TypeChangeForm::refresh);
    addField(label, m_name);
    m_name->setFocus();
}

void TypeChangeForm::askCode(const QString& label, const QString& initial)
{
    m_code = new QLineEdit(initial, this);
    m_code->setObjectName("codeField");
    m_code->setMaxLength(60);
    m_code->selectAll();
    // A scanner ends with Enter: that goes on to the reason, and accepts nothing.
    connect(m_code, &QLineEdit::returnPressed, m_reason, qOverload<>(&QWidget::setFocus));
    addField(label, m_code);
    m_code->setFocus();
}

void TypeChangeForm::askType(const QString& label, const QStringList& names)
{
    m_type = new QComboBox(this);
    m_type->setObjectName("typeField");
    m_type->addItems(names);
    addField(label, m_type);
}

void TypeChangeForm::askSqueezes(const QString& label, const std::vector<GraspRecord>& grasps)
{
    m_squeezes = new QListWidget(this);
    m_squeezes->setObjectName("squeezesField");
    int number = 0;
    for (const GraspRecord& grasp : grasps) {
        ++number;
        if (!grasp.accepted || !grasp.parameters)
            continue;
        const ParameterTexts texts =
            parameterTextsWithin(*grasp.parameters, std::nullopt, grasp.forceUnit, grasp.positionUnit);
        QString text =
            tr("%1:  k %2   b %3   m %4").arg(number).arg(texts.k.text(), texts.b.text(), texts.m.text());
        if (!grasp.part.isEmpty())
            text += tr("   part %1").arg(grasp.part);
        auto* item = new QListWidgetItem(text, m_squeezes);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        item->setCheckState(Qt::Unchecked);
        item->setData(Qt::UserRole, grasp.id);
    }
    m_squeezes->setMinimumHeight(160);
    connect(m_squeezes, &QListWidget::itemChanged, this, &TypeChangeForm::refresh);
    addField(label, m_squeezes);
}

QString TypeChangeForm::name() const
{
    return m_name ? m_name->text().trimmed() : QString();
}

QString TypeChangeForm::code() const
{
    return m_code ? m_code->text().trimmed() : QString();
}

QString TypeChangeForm::type() const
{
    return m_type ? m_type->currentText() : QString();
}

QStringList TypeChangeForm::squeezes() const
{
    QStringList keys;
    for (int row = 0; m_squeezes && row < m_squeezes->count(); ++row)
        if (m_squeezes->item(row)->checkState() == Qt::Checked)
            keys.append(m_squeezes->item(row)->data(Qt::UserRole).toString());
    return keys;
}

QString TypeChangeForm::reason() const
{
    return m_reason->text().trimmed();
}

void TypeChangeForm::refresh()
{
    const auto ticked = squeezes().size();
    const bool some = !m_squeezes || (ticked > 0 && ticked < m_squeezes->count());
    m_accept->setEnabled(!reason().isEmpty() && (!m_name || !name().isEmpty()) &&
                         (!m_type || !type().isEmpty()) && some);
}

} // namespace gripscope
