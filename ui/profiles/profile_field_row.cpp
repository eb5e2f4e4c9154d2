// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profiles/profile_dialog.h"
#include "ui/widgets/controls.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLineEdit>
#include <QLocale>
#include <QSpinBox>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Numbers of a profile are written as in its document, with a point.
double number(const QLineEdit* edit, double otherwise)
{
    bool isNumber = false;
    const double value = QLocale::c().toDouble(edit->text().trimmed(), &isNumber);
    return isNumber ? value : otherwise;
}

QString text(double value)
{
    return QLocale::c().toString(value, 'g', QLocale::FloatingPointShortest);
}

/// "0 moving, 4 not fault".
QString textOf(const std::vector<ProfileFlag>& flags)
{
    QStringList parts;
    for (const ProfileFlag& flag : flags)
        parts << u"%1 %2%3"_s.arg(flag.bit).arg(flag.whenSet ? QString() : u"not "_s, flagName(flag.meaning));
    return parts.join(u", "_s);
}

std::vector<ProfileFlag> flagsIn(const QString& text)
{
    std::vector<ProfileFlag> flags;
    for (const QString& part : text.split(u',', Qt::SkipEmptyParts)) {
        const QStringList words = part.simplified().split(u' ');
        flags.push_back({words.value(0).toUInt(), flagFromName(words.last()), words.value(1) != u"not"});
    }
    return flags;
}

QStringList unitsFor(ProfileFieldRow::Kind kind)
{
    switch (kind) {
    case ProfileFieldRow::Kind::Force:
        return {u"uN"_s, u"mN"_s, u"N"_s, u"kN"_s};
    case ProfileFieldRow::Kind::Position:
        return {u"nm"_s, u"um"_s, u"mm"_s, u"cm"_s, u"m"_s};
    case ProfileFieldRow::Kind::Time:
        return {u"ns"_s, u"us"_s, u"ms"_s, u"s"_s};
    case ProfileFieldRow::Kind::Sequence:
        return {u"reports"_s, u"samples"_s};
    case ProfileFieldRow::Kind::Status:
        break;
    }
    return {};
}

} // namespace

ProfileFieldRow::ProfileFieldRow(Kind kind, QGridLayout* grid, int row, QWidget* parent)
    : QObject(parent), m_kind(kind)
{
    build(grid, row, parent);
    showWhatApplies();
}

QString ProfileFieldRow::name() const
{
    switch (m_kind) {
    case Kind::Force:
        return u"force"_s;
    case Kind::Position:
        return u"position"_s;
    case Kind::Sequence:
        return u"sequence"_s;
    case Kind::Time:
        return u"time"_s;
    case Kind::Status:
        break;
    }
    return u"status"_s;
}

void ProfileFieldRow::addEditor(QGridLayout* grid, QWidget* editor, int row, int column, int columns,
                                const QString& caption)
{
    editor->setAccessibleName(tr("%1: %2").arg(m_present->text(), caption));
    editor->setToolTip(caption);
    constexpr int widths[] = {0, 48, 72, 80, 60, 56, 76};
    editor->setMinimumWidth(widths[column]);
    if (columns == 1)
        editor->setMaximumWidth(widths[column]);
    editor->installEventFilter(this);
    grid->addWidget(editor, row, column, 1, columns);
}

void ProfileFieldRow::build(QGridLayout* grid, int row, QWidget* parent)
{
    const QStringList captions{tr("Force"), tr("Position"), tr("Counter"), tr("Clock"), tr("Flags")};
    m_present = new QCheckBox(captions[static_cast<int>(m_kind)], parent);
    const bool always = m_kind == Kind::Force || m_kind == Kind::Position;
    m_present->setChecked(always);
    m_present->setEnabled(!always);
    m_present->installEventFilter(this);
    grid->addWidget(m_present, row, 0);
    m_byte = new QSpinBox(parent);
    m_byte->setRange(0, 63);
    m_byte->setButtonSymbols(QAbstractSpinBox::NoButtons);
    addEditor(grid, m_byte, row, 1, 1, tr("first byte"));
    m_type = new QComboBox(parent);
    for (const QString& type : fieldTypeNames())
        if (always || type.startsWith(u'u'))
            m_type->addItem(type);
    addEditor(grid, m_type, row, 2, 1, tr("type"));
    m_endian = new QComboBox(parent);
    m_endian->addItems({tr("little"), tr("big")});
    addEditor(grid, m_endian, row, 3, 1,
              tr("which byte comes first: the lowest (little) or the highest (big)"));
    m_scale = new QLineEdit(u"1"_s, parent);
    m_offset = new QLineEdit(u"0"_s, parent);
    m_unit = new QComboBox(parent);
    m_flags = new QLineEdit(parent);
    m_flags->setPlaceholderText(tr("0 moving, 4 force_saturated"));
    if (m_kind == Kind::Status) {
        addEditor(grid, m_flags, row, 4, 3, tr("bits and what they mean: %1").arg(flagNames().join(u", "_s)));
    } else {
        m_unit->addItems(unitsFor(m_kind));
        m_unit->setCurrentText(m_kind == Kind::Force ? u"N"_s : m_kind == Kind::Position ? u"mm"_s : u"us"_s);
        if (m_kind == Kind::Sequence)
            addEditor(grid, m_unit, row, 4, 2, tr("what it counts"));
        else
            addEditor(grid, m_unit, row, 6, 1, tr("unit"));
    }
    if (always || m_kind == Kind::Time)
        addEditor(grid, m_scale, row, 4, 1, tr("units in one count"));
    if (always)
        addEditor(grid, m_offset, row, 5, 1, tr("added to the value, in its unit"));
    m_value = makeLabel({}, "strong", parent);
    m_value->setMinimumWidth(80);
    m_value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(m_value, row, 7);
    for (QWidget* unused : {static_cast<QWidget*>(m_scale), static_cast<QWidget*>(m_offset),
                            static_cast<QWidget*>(m_unit), static_cast<QWidget*>(m_flags)})
        unused->setVisible(grid->indexOf(unused) >= 0);

    const auto tell = [this] {
        showWhatApplies();
        if (!m_taking)
            emit edited();
    };
    connect(m_present, &QCheckBox::toggled, this, tell);
    connect(m_byte, &QSpinBox::valueChanged, this, tell);
    for (QComboBox* box : {m_type, m_endian, m_unit})
        connect(box, &QComboBox::currentIndexChanged, this, tell);
    for (QLineEdit* edit : {m_scale, m_offset, m_flags})
        connect(edit, &QLineEdit::textChanged, this, tell);
}

void ProfileFieldRow::showWhatApplies()
{
    const bool on = m_present->isChecked();
    for (QWidget* editor :
         {static_cast<QWidget*>(m_byte), static_cast<QWidget*>(m_type), static_cast<QWidget*>(m_scale),
          static_cast<QWidget*>(m_offset), static_cast<QWidget*>(m_unit), static_cast<QWidget*>(m_flags)})
        editor->setEnabled(on);
    m_endian->setEnabled(on && field().size() > 1);
}

void ProfileFieldRow::takeField(const ProfileField& field)
{
    m_field = field;
    m_byte->setValue(static_cast<int>(field.byte));
    m_type->setCurrentText(toString(field.type));
    m_endian->setCurrentIndex(field.bigEndian ? 1 : 0);
}

ProfileField ProfileFieldRow::field() const
{
    ProfileField field = m_field;
    field.byte = static_cast<std::size_t>(m_byte->value());
    field.type = fieldTypeFromString(m_type->currentText()).value_or(FieldType::U8);
    field.bigEndian = m_endian->currentIndex() == 1;
    return field;
}

ProfileChannel ProfileFieldRow::channel() const
{
    ProfileChannel channel = m_channel;
    channel.field = field();
    channel.scale = number(m_scale, 0); // which is told as a mistake
    channel.offset = number(m_offset, 0);
    channel.unit = m_unit->currentText();
    return channel;
}

void ProfileFieldRow::take(const GripperProfile& profile)
{
    m_taking = true;
    if (m_kind == Kind::Force || m_kind == Kind::Position) {
        m_channel = m_kind == Kind::Force ? profile.force : profile.position;
        takeField(m_channel.field);
        m_scale->setText(text(m_channel.scale));
        m_offset->setText(text(m_channel.offset));
        m_unit->setCurrentText(m_channel.unit);
    } else if (m_kind == Kind::Sequence && profile.sequence) {
        takeField(profile.sequence->field);
        m_unit->setCurrentIndex(profile.sequence->countsSamples ? 1 : 0);
    } else if (m_kind == Kind::Time && profile.time) {
        takeField(profile.time->field);
        m_scale->setText(text(profile.time->scale));
        m_unit->setCurrentText(profile.time->unit);
    } else if (m_kind == Kind::Status && profile.status) {
        takeField(profile.status->field);
        m_flags->setText(textOf(profile.status->flags));
    }
    if (m_kind == Kind::Sequence)
        m_present->setChecked(profile.sequence.has_value());
    if (m_kind == Kind::Time)
        m_present->setChecked(profile.time.has_value());
    if (m_kind == Kind::Status)
        m_present->setChecked(profile.status.has_value());
    m_taking = false;
    showWhatApplies();
}

void ProfileFieldRow::put(GripperProfile& profile) const
{
    const bool on = m_present->isChecked();
    if (m_kind == Kind::Force)
        profile.force = channel();
    else if (m_kind == Kind::Position)
        profile.position = channel();
    else if (m_kind == Kind::Sequence && on)
        profile.sequence = ProfileSequence{field(), m_unit->currentIndex() == 1};
    else if (m_kind == Kind::Time && on)
        profile.time = ProfileTime{field(), number(m_scale, 0), m_unit->currentText()};
    else if (m_kind == Kind::Status && on)
        profile.status = ProfileStatus{field(), flagsIn(m_flags->text())};
}

void ProfileFieldRow::setValue(const QString& text)
{
    m_value->setText(text);
}

bool ProfileFieldRow::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::Enter)
        emit chosen(name());
    return QObject::eventFilter(watched, event);
}

} // namespace gripscope
