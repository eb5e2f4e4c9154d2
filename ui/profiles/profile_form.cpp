// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/field_values.h"
#include "ui/profiles/profile_dialog.h"
#include "ui/widgets/controls.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QLocale>
#include <QSpinBox>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QSpinBox* spinBox(int least, int most, QWidget* parent)
{
    auto* box = new QSpinBox(parent);
    box->setRange(least, most);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    return box;
}

QString hex(std::uint16_t number)
{
    return u"%1"_s.arg(number, 4, 16, QLatin1Char('0'));
}

QString valueText(const FieldValue& value)
{
    if (value.name == u"status")
        return value.words.isEmpty() ? u"–"_s : value.words;
    return QLocale().toString(value.value, 'g', 5) + (value.unit.isEmpty() ? QString() : u' ' + value.unit);
}

} // namespace

ProfileForm::ProfileForm(QWidget* parent)
    : QWidget(parent), m_name(new QLineEdit(this)), m_vendor(new QLineEdit(this)),
      m_product(new QLineEdit(this)), m_rate(new QLineEdit(this)), m_id(spinBox(0, 255, this)),
      m_length(spinBox(1, 64, this)), m_samples(spinBox(1, 32, this)), m_stride(spinBox(0, 63, this)),
      m_hold(new QComboBox(this))
{
    build();
    const auto tell = [this] {
        if (!m_taking)
            emit edited();
    };
    for (QLineEdit* edit : {m_name, m_vendor, m_product, m_rate})
        connect(edit, &QLineEdit::textChanged, this, tell);
    for (QSpinBox* box : {m_id, m_length, m_samples, m_stride})
        connect(box, &QSpinBox::valueChanged, this, tell);
    connect(m_hold, &QComboBox::currentIndexChanged, this, tell);
    for (ProfileFieldRow* row : m_rows) {
        connect(row, &ProfileFieldRow::edited, this, &ProfileForm::edited);
        connect(row, &ProfileFieldRow::chosen, this, &ProfileForm::fieldChosen);
    }
}

void ProfileForm::build()
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 16);
    column->addWidget(buildDevice());
    column->addWidget(buildFields());
    column->addStretch(1);
}

QWidget* ProfileForm::buildDevice()
{
    auto* panel = new QWidget(this);
    auto* grid = new QGridLayout(panel);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    m_id->setSpecialValueText(tr("none"));
    m_stride->setSpecialValueText(tr("none"));
    m_hold->addItems({tr("held (zoh)"), tr("straight (foh)")});
    const auto add = [&](QWidget* editor, const QString& caption, int row, int at, int columns = 1) {
        grid->addWidget(makeLabel(caption, "second", panel), 2 * row, at, 1, columns);
        grid->addWidget(editor, 2 * row + 1, at, 1, columns);
        editor->setAccessibleName(caption);
        editor->setMinimumWidth(64);
    };
    add(m_name, tr("Name"), 0, 0, 4);
    add(m_vendor, tr("USB vendor"), 0, 4);
    add(m_product, tr("USB product"), 0, 5);
    add(m_id, tr("Report ID"), 1, 0);
    add(m_length, tr("Bytes"), 1, 1);
    add(m_samples, tr("Samples"), 1, 2);
    add(m_stride, tr("Bytes apart"), 1, 3);
    add(m_rate, tr("Samples/s"), 1, 4);
    add(m_hold, tr("Force goes on"), 1, 5);
    grid->setColumnStretch(5, 1);
    return panel;
}

QWidget* ProfileForm::buildFields()
{
    using Kind = ProfileFieldRow::Kind;
    auto* panel = new QWidget(this);
    auto* grid = new QGridLayout(panel);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(4);
    int column = 0;
    for (const QString& caption : {tr("Field"), tr("Byte"), tr("Type"), tr("Order"), tr("Scale"), tr("Added"),
                                   tr("Unit"), tr("Says now")}) {
        QLabel* label = makeLabel(caption, "second", panel);
        if (column == 7)
            label->setAlignment(Qt::AlignRight);
        grid->addWidget(label, 0, column++);
    }
    int row = 1;
    for (const Kind kind : {Kind::Force, Kind::Position, Kind::Sequence, Kind::Time, Kind::Status})
        m_rows.push_back(new ProfileFieldRow(kind, grid, row++, panel));
    grid->setColumnStretch(7, 1);
    return panel;
}

void ProfileForm::setProfile(const GripperProfile& profile)
{
    m_taking = true;
    m_profile = profile;
    m_name->setText(profile.name);
    m_vendor->setText(hex(profile.vendor));
    m_product->setText(hex(profile.product));
    m_rate->setText(QLocale::c().toString(profile.samplesPerSecond, 'g', 10));
    m_id->setValue(profile.reportId.value_or(0));
    m_length->setValue(static_cast<int>(profile.reportLength));
    m_samples->setValue(static_cast<int>(profile.samples));
    m_stride->setValue(static_cast<int>(profile.stride));
    m_hold->setCurrentIndex(profile.hold == ForceHold::Zero ? 0 : 1);
    for (ProfileFieldRow* row : m_rows)
        row->take(profile);
    m_taking = false;
    emit edited();
}

GripperProfile ProfileForm::profile() const
{
    GripperProfile profile = m_profile;
    profile.name = m_name->text().trimmed();
    profile.vendor = m_vendor->text().toUShort(nullptr, 16);
    profile.product = m_product->text().toUShort(nullptr, 16);
    profile.samplesPerSecond = QLocale::c().toDouble(m_rate->text());
    profile.reportId.reset();
    if (m_id->value() > 0)
        profile.reportId = static_cast<std::uint8_t>(m_id->value());
    profile.reportLength = static_cast<std::size_t>(m_length->value());
    profile.samples = static_cast<std::size_t>(m_samples->value());
    profile.stride = static_cast<std::size_t>(m_stride->value());
    profile.hold = m_hold->currentIndex() == 0 ? ForceHold::Zero : ForceHold::First;
    profile.sequence.reset();
    profile.time.reset();
    profile.status.reset();
    for (const ProfileFieldRow* row : m_rows)
        row->put(profile);
    return profile;
}

void ProfileForm::showValues(const std::optional<GripperProfile>& profile,
                             const std::vector<std::uint8_t>& report)
{
    const std::vector<FieldValue> values =
        profile ? fieldValues(*profile, report) : std::vector<FieldValue>();
    for (ProfileFieldRow* row : m_rows) {
        QString text;
        for (const FieldValue& value : values)
            if (value.name == row->name() && value.index == 0)
                text = valueText(value);
        row->setValue(text);
    }
}

} // namespace gripscope
