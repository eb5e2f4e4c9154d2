// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/settings_dialog.h"
#include "ui/settings/values/settings.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/windows/file_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int controlWidth = 248;

} // namespace

SettingRow::SettingRow(Settings& settings, const Setting& setting, QWidget* parent)
    : QFrame(parent), m_settings(&settings), m_setting(&setting), m_key(QString::fromLatin1(setting.key))
{
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(makeLabel(setting.shownName(), "strong", this));
    auto* explanation = makeLabel(setting.shownExplanation(), "caption", this);
    explanation->setWordWrap(true);
    words->addWidget(explanation);

    QWidget* control = makeControl();
    control->setObjectName("setting-"_L1 + m_key);
    control->setAccessibleName(setting.shownName());
    control->setAccessibleDescription(setting.shownExplanation());
    control->setFixedWidth(controlWidth);
    control->setFocusPolicy(Qt::StrongFocus);
    control->installEventFilter(this);

    m_reset = makeButton({}, u"edit-undo"_s, "quiet", this);
    m_reset->setObjectName("reset-"_L1 + m_key);
    m_reset->setAccessibleName(tr("Reset %1").arg(setting.shownName()));
    m_reset->setToolTip(tr("Back to the default: %1").arg(setting.shownValue(setting.fallback)));
    m_reset->setFixedWidth(48);
    m_reset->setAutoDefault(false);
    connect(m_reset, &QPushButton::clicked, this,
            [this] { guarded(m_setting->fallback, [this] { m_settings->reset(m_key); }); });

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 8, 0, 8);
    row->setSpacing(16);
    row->addLayout(words, 1);
    if (setting.kind == SettingKind::Folder || setting.kind == SettingKind::Picture ||
        setting.kind == SettingKind::File)
        row->addWidget(makeFileButton());
    row->addWidget(control);
    row->addWidget(m_reset);
    connect(m_settings, &Settings::changed, this, [this](const QString& key) {
        if (key == m_key)
            refresh();
    });
    refresh();
}

bool SettingRow::matches(const QString& search) const
{
    QStringList all{m_setting->shownName(), m_setting->shownExplanation(), settingGroupName(m_setting->group),
                    m_key};
    for (const SettingChoice& choice : m_setting->choices)
        all << m_setting->shownValue(QString::fromLatin1(choice.value));
    const QString text = all.join(u' ');
    const QStringList words = search.split(u' ', Qt::SkipEmptyParts);
    return std::all_of(words.begin(), words.end(),
                       [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

QWidget* SettingRow::makeControl()
{
    switch (m_setting->kind) {
    case SettingKind::Switch:
        return makeSwitch();
    case SettingKind::Choice:
        return makeChoice();
    case SettingKind::Number:
        return makeNumber();
    case SettingKind::Text:
    case SettingKind::Folder:
    case SettingKind::Picture:
    case SettingKind::File:
        break;
    }
    return makeText();
}

QWidget* SettingRow::makeSwitch()
{
    auto* box = new QCheckBox(this);
    box->setMinimumHeight(metrics::touchTarget);
    m_show = [this, box](const QVariant& value) {
        box->setChecked(value.toBool());
        box->setText(m_setting->shownValue(value));
    };
    connect(box, &QCheckBox::clicked, this, [this](bool on) { store(on); });
    return box;
}

QWidget* SettingRow::makeChoice()
{
    auto* box = new QComboBox(this);
    for (const SettingChoice& choice : m_setting->choices) {
        const QString value = QString::fromLatin1(choice.value);
        box->addItem(m_setting->shownValue(value), value);
    }
    m_show = [box](const QVariant& value) { box->setCurrentIndex(box->findData(value.toString())); };
    connect(box, &QComboBox::activated, this, [this, box] { store(box->currentData()); });
    return box;
}

QWidget* SettingRow::makeNumber()
{
    auto* box = new QDoubleSpinBox(this);
    const double factor = m_setting->factor;
    box->setDecimals(m_setting->decimals);
    box->setRange(factor * m_setting->least, factor * m_setting->most);
    box->setSingleStep(std::pow(10.0, std::floor(std::log10(box->maximum() / 20))));
    if (const QString unit = QString::fromUtf8(m_setting->unit); !unit.isEmpty())
        box->setSuffix(QChar(QChar::Nbsp) + unit);
    if (m_setting->zeroMeans)
        box->setSpecialValueText(m_setting->shownValue(0.0));
    box->setKeyboardTracking(false); // half a number is not stored
    m_show = [box, factor](const QVariant& value) { box->setValue(factor * value.toDouble()); };
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, factor](double shown) { store(shown / factor); });
    return box;
}

QWidget* SettingRow::makeText()
{
    auto* edit = new QLineEdit(this);
    edit->setPlaceholderText(m_setting->shownValue(m_setting->fallback));
    m_show = [edit](const QVariant& value) { edit->setText(value.toString()); };
    connect(edit, &QLineEdit::editingFinished, this, [this, edit] { store(edit->text().trimmed()); });
    return edit;
}

QWidget* SettingRow::makeFileButton()
{
    auto* button = makeButton(tr("Choose…"), u"folder-open"_s, "", this);
    button->setAutoDefault(false);
    button->setAccessibleName(tr("Choose: %1").arg(m_setting->shownName()));
    connect(button, &QPushButton::clicked, this, [this] {
        const bool picture = m_setting->kind == SettingKind::Picture;
        const bool folder = m_setting->kind == SettingKind::Folder;
        const QString chosen = m_settings->value(m_key).toString();
        auto* dialog = new FileDialog(this, m_setting->shownName(), picture ? QString() : chosen,
                                      picture ? tr("Pictures (*.png *.svg)") : QString());
        dialog->setFileMode(folder ? QFileDialog::Directory : QFileDialog::ExistingFile);
        dialog->setOption(QFileDialog::ShowDirsOnly, folder);
        connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { store(file); });
        dialog->open();
    });
    return button;
}

void SettingRow::store(const QVariant& value)
{
    // Before anybody is asked, or told, of it.
    const bool fits = m_setting->accepted(value).has_value();
    if (m_teller)
        m_teller(fits ? QString() : m_setting->whyNot(value));
    if (!fits)
        return;
    guarded(value, [this, value] { (void)m_settings->setValue(m_key, value); });
    refresh(); // what is in force, which may still be what it was
}

void SettingRow::guarded(const QVariant& after, std::function<void()> apply)
{
    const QVariant before = m_settings->value(m_key);
    if (!m_guard || after == before)
        apply();
    else
        m_guard({m_key, before, after}, std::move(apply));
}

void SettingRow::refresh()
{
    auto* control = findChild<QWidget*>("setting-"_L1 + m_key);
    const QSignalBlocker blocked(control);
    m_show(m_settings->value(m_key));
    m_reset->setEnabled(!m_settings->isDefault(m_key));
}

bool SettingRow::eventFilter(QObject* watched, QEvent* event)
{
    // The wheel scrolls the page, unless the control was chosen.
    if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();
        return true;
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace gripscope
