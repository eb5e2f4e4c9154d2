// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/style_sheet.h"

#include <QFile>
#include <QHash>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr int indicatorSide = 20; ///< of a check box and of a radio button, frame included

/// Replaces @name by the value of a token, so that the rules below read like plain style sheets.
QString fill(QString rules, const ThemeTokens& t)
{
    const bool contrast = t.kind == ThemeKind::HighContrast;
    const QColor hover = Theme::mix(t.surface, t.text, contrast ? 0.2 : 0.06);
    const QColor pressed = Theme::mix(t.surface, t.text, contrast ? 0.35 : 0.12);
    const QColor control = contrast ? t.line : Theme::mix(t.line, t.secondText, 0.35);
    const auto px = [](int value) { return QString::number(value) + "px"_L1; };
    const std::pair<QLatin1StringView, QString> values[] = {
        {"@onAccent"_L1, Theme::onColor(t.accent).name()},
        {"@onStop"_L1, Theme::onColor(t.stop).name()},
        {"@accentHover"_L1, Theme::mix(t.accent, t.text, 0.15).name()},
        {"@accentTint"_L1, Theme::mix(t.surface, t.accent, contrast ? 0.0 : 0.12).name()},
        {"@selectedEdge"_L1, u"%1px solid %2"_s.arg(t.selectedEdgeWidth).arg(t.selectedEdge.name())},
        {"@selectedFrame"_L1, contrast ? t.accent.name() : u"transparent"_s},
        {"@selected"_L1, t.selected.name()},
        {"@stopHover"_L1, Theme::mix(t.stop, t.text, 0.12).name()},
        {"@secondText"_L1, t.secondText.name()},
        {"@disabledLine"_L1, contrast ? u"dashed "_s + t.disabled.name() : u"solid "_s + t.line.name()},
        {"@disabled"_L1, t.disabled.name()},
        {"@indicator"_L1, px(indicatorSide - 2 * t.lineWidth)},
        {"@surface"_L1, t.surface.name()},
        {"@page"_L1, t.page.name()},
        {"@control"_L1, control.name()},
        {"@hover"_L1, hover.name()},
        {"@pressed"_L1, pressed.name()},
        {"@lineWidth"_L1, px(t.lineWidth)},
        {"@line"_L1, t.line.name()},
        {"@text"_L1, t.text.name()},
        {"@accent"_L1, t.accent.name()},
        {"@stop"_L1, t.stop.name()},
        {"@notValid"_L1, t.notValid.name()},
        {"@radius"_L1, px(metrics::radius)},
        {"@touch"_L1, px(metrics::touchTarget - 2 * t.lineWidth)},
        {"@fontSmall"_L1, px(metrics::fontSmall)},
        {"@fontBase"_L1, px(metrics::fontBase)},
        {"@fontLarge"_L1, px(metrics::fontLarge)},
        {"@fontTitle"_L1, px(metrics::fontTitle)},
        {"@fontNumber"_L1, px(metrics::fontNumber)},
    };
    for (const auto& [name, value] : values)
        rules.replace(name, value);
    return rules;
}

} // namespace

QString StyleSheet::text(const ThemeTokens& tokens)
{
    ++m_version;
    return fill(frames(tokens) + texts(tokens) + buttons(tokens) + inputs(tokens) + views(tokens), tokens);
}

QString StyleSheet::sign(const QString& name, const QString& path, const QColor& color)
{
    // A new file name for each version: Qt keeps pictures by name.
    const QString file = m_signs.filePath(u"%1-%2.svg"_s.arg(name).arg(m_version));
    QFile out(file);
    if (!m_signs.isValid() || !out.open(QIODevice::WriteOnly))
        return u"none"_s;
    out.write(u"<svg xmlns='http://www.w3.org/2000/svg' width='16' height='16' viewBox='0 0 16 16'><path "
              u"d='%1' fill='none' "
              "stroke='%2' stroke-width='2' stroke-linecap='round' stroke-linejoin='round'/></svg>"_s
                  .arg(path, color.name())
                  .toUtf8());
    return u"url(%1)"_s.arg(file);
}

QString StyleSheet::frames(const ThemeTokens&) const
{
    return uR"(
QWidget { color: @text; }
QWidget:disabled { color: @disabled; }
QMainWindow, QDialog, Page, QStackedWidget { background: @page; }
QFrame[role="card"] { background: @surface; border: @lineWidth solid @line; border-radius: @radius; }
QFrame[role="rail"] { background: @surface; border: none; border-right: @lineWidth solid @line; }
QFrame[role="bar"] { background: @surface; border: none; }
QFrame[role="strip"] { background: @surface; border: none; border-bottom: @lineWidth solid @line; }
QFrame[role="message"] { background: @surface; border: none; border-left: 4px solid @notValid; border-bottom: @lineWidth solid @line; }
QFrame[role="rule"] { background: @line; border: none; max-height: @lineWidth; min-height: @lineWidth; }
QToolTip { background: @surface; color: @text; border: @lineWidth solid @control; padding: 4px 8px; }
QScrollArea { background: transparent; border: none; }
QScrollArea > QWidget > QWidget { background: transparent; }
QScrollArea > QWidget > QDialog { background: @page; }
QScrollArea > QWidget > QMenu { background: @surface; }
QSplitter::handle { background: transparent; }
QSplitter::handle:hover { background: @line; }
QStatusBar { background: @surface; }
QProgressBar { background: @pressed; border: none; border-radius: 4px; min-height: 8px; max-height: 8px; }
QProgressBar::chunk { background: @accent; border-radius: 4px; }
)"_s;
}

QString StyleSheet::texts(const ThemeTokens&) const
{
    return uR"(
QLabel { background: transparent; }
QLabel[role="title"] { font-size: @fontTitle; font-weight: 600; }
QLabel[role="heading"] { font-size: @fontLarge; font-weight: 600; }
QLabel[role="strong"] { font-weight: 600; }
QLabel[role="caption"] { font-size: @fontSmall; color: @secondText; }
QLabel[role="second"] { color: @secondText; }
QLabel[role="number"] { font-size: @fontTitle; font-weight: 600; }
QLabel[role="big-number"] { font-size: @fontNumber; font-weight: 600; }
QLabel:disabled { color: @disabled; }
QLabel[role="error"] { color: @notValid; }
QLabel[role="stopped"] { font-size: @fontLarge; font-weight: 600; color: @notValid; }
)"_s;
}

QString StyleSheet::buttons(const ThemeTokens&) const
{
    return uR"(
QPushButton, QToolButton { background: @surface; border: @lineWidth solid @control; border-radius: @radius;
  min-height: @touch; padding: 0 16px; outline: none; }
QToolButton { padding: 0 8px; min-width: 22px; }
QPushButton:hover, QToolButton:hover { background: @hover; }
QPushButton:pressed, QToolButton:pressed { background: @pressed; }
QPushButton:checked, QToolButton:checked { background: @accentTint; border-color: @accent; color: @accent; font-weight: 600; }
QPushButton:focus, QToolButton:focus { border: 2px solid @accent; padding: 0 15px; }
QToolButton:focus { padding: 0 7px; }
QPushButton:disabled, QToolButton:disabled { color: @disabled; border: @lineWidth @disabledLine; background: @page; }
QPushButton[role="primary"] { background: @accent; color: @onAccent; border: @lineWidth solid @accent; font-weight: 600; }
QPushButton[role="primary"]:hover { background: @accentHover; }
QPushButton[role="primary"]:focus { border: 2px solid @text; }
QPushButton[role="primary"]:disabled { background: @page; color: @disabled; border: @lineWidth @disabledLine; }
QPushButton[large="true"] { min-height: 54px; font-size: @fontLarge; }
QPushButton[role="quiet"] { background: transparent; color: @accent; }
QPushButton[role="quiet"]:disabled { color: @disabled; background: transparent; border: @lineWidth @disabledLine; }
QToolButton[role="quiet"] { background: transparent; border-color: transparent; }
QToolButton[role="quiet"]:disabled { color: @disabled; background: transparent; border: @lineWidth solid transparent; }
QPushButton[role="quiet"]:hover, QToolButton[role="quiet"]:hover { background: @hover; }
QPushButton[role="quiet"]:focus, QToolButton[role="quiet"]:focus { border: 2px solid @accent; }
QPushButton[role="stop"] { background: @stop; color: @onStop; border: @lineWidth solid @stop; font-size: @fontLarge;
  font-weight: 700; padding: 0 24px; min-width: 72px; }
QPushButton[role="stop"]:hover, QPushButton[role="stop"]:pressed { background: @stopHover; }
QPushButton[role="stop"]:focus { border: 2px solid @text; }
QToolButton::menu-indicator, QPushButton::menu-indicator { width: 0; height: 0; }
)"_s;
}

QString StyleSheet::inputs(const ThemeTokens& t)
{
    const QString down = sign(u"down"_s, u"M4 6 L8 10 L12 6"_s, t.secondText);
    const QString up = sign(u"up"_s, u"M4 10 L8 6 L12 10"_s, t.secondText);
    const QString downOff = sign(u"down-off"_s, u"M4 6 L8 10 L12 6"_s, t.disabled);
    const QString upOff = sign(u"up-off"_s, u"M4 10 L8 6 L12 10"_s, t.disabled);
    const QString check = sign(u"check"_s, u"M3 8 L7 12 L13 4"_s, Theme::onColor(t.accent));
    return uR"(
QLineEdit, QComboBox, QAbstractSpinBox, QPlainTextEdit, QTextEdit { background: @surface; border: @lineWidth solid @control;
  border-radius: @radius; min-height: @touch; padding: 0 8px; selection-background-color: @accent; selection-color: @onAccent; }
QPlainTextEdit, QTextEdit { padding: 4px; }
QLineEdit:focus, QComboBox:focus, QAbstractSpinBox:focus, QPlainTextEdit:focus { border: 2px solid @accent; padding: 0 7px; }
QLineEdit:disabled, QComboBox:disabled, QAbstractSpinBox:disabled, QPlainTextEdit:disabled {
  color: @disabled; background: @page; border: @lineWidth @disabledLine; }
QLineEdit[invalid="true"], QAbstractSpinBox[invalid="true"] { border: 2px solid @notValid; padding: 0 7px; }
QComboBox::drop-down { border: none; width: 28px; }
QComboBox::down-arrow { image: %1; width: 16px; height: 16px; }
QComboBox::down-arrow:disabled, QAbstractSpinBox::down-arrow:disabled, QAbstractSpinBox::down-arrow:off { image: %4; }
QAbstractSpinBox::up-arrow:disabled, QAbstractSpinBox::up-arrow:off { image: %5; }
QComboBox QAbstractItemView { background: @surface; border: @lineWidth solid @control; outline: none; padding: 4px; }
QComboBox QAbstractItemView::item { min-height: 36px; padding: 0 8px; }
QComboBox QAbstractItemView::item:selected { background: @selected; color: @text; }
QAbstractSpinBox::up-button { border: none; width: 28px; subcontrol-position: top right; }
QAbstractSpinBox::down-button { border: none; width: 28px; subcontrol-position: bottom right; }
QAbstractSpinBox::up-button:hover, QAbstractSpinBox::down-button:hover { background: @hover; }
QAbstractSpinBox::up-arrow { image: %2; width: 12px; height: 12px; }
QAbstractSpinBox::down-arrow { image: %1; width: 12px; height: 12px; }
QCheckBox, QRadioButton { spacing: 8px; min-height: 32px; background: transparent; }
QCheckBox::indicator, QRadioButton::indicator, QAbstractItemView::indicator { width: @indicator; height: @indicator;
  border: @lineWidth solid @secondText; background: @surface; }
QCheckBox::indicator, QAbstractItemView::indicator { border-radius: 4px; }
QCheckBox::indicator:checked, QAbstractItemView::indicator:checked { background: @accent; border-color: @accent; image: %3; }
QRadioButton::indicator { border-radius: 10px; }
QRadioButton::indicator:checked { width: 8px; height: 8px; border: 6px solid @accent; }
QCheckBox::indicator:disabled, QRadioButton::indicator:disabled { border: @lineWidth @disabledLine; background: @page; }
QCheckBox::indicator:checked:disabled { background: @disabled; border-color: @disabled; }
QRadioButton::indicator:checked:disabled { border: 6px solid @disabled; }
QCheckBox:focus, QRadioButton:focus { outline: none; text-decoration: underline; }
QSlider { min-height: 40px; background: transparent; }
QSlider::groove:horizontal { height: 4px; background: @control; border-radius: 2px; }
QSlider::sub-page:horizontal { background: @accent; border-radius: 2px; }
QSlider::handle:horizontal { width: 20px; height: 20px; margin: -8px 0; border-radius: 10px; background: @surface; border: 2px solid @accent; }
QSlider::sub-page:horizontal:disabled { background: @disabled; }
QSlider::handle:horizontal:disabled { background: @page; border-color: @disabled; }
QSlider:focus { border: 2px solid @accent; border-radius: @radius; }
)"_s.arg(down, up, check, downOff, upOff);
}

QString StyleSheet::views(const ThemeTokens&) const
{
    return uR"(
QAbstractItemView { background: @surface; alternate-background-color: @page; border: none; outline: none;
  selection-background-color: @selected; selection-color: @text; gridline-color: @line; }
QTableView::item, QListView::item, QTreeView::item { padding: 0 5px; border: none; border-bottom: 1px solid @line; }
QTableView::item:selected, QListView::item:selected, QTreeView::item:selected { background: @selected; color: @text;
  border-bottom: @selectedEdge; }
QTableView:focus, QListView:focus, QTreeView:focus { border: 2px solid @accent; border-radius: @radius; }
QHeaderView { background: @surface; border: none; }
QHeaderView::section { background: @surface; color: @secondText; font-size: @fontSmall; font-weight: 600; border: none;
  border-bottom: @lineWidth solid @line; padding: 8px; }
QTableCornerButton::section { background: @surface; border: none; }
QScrollBar:vertical { background: transparent; width: 14px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 14px; margin: 0; }
QScrollBar::handle { background: @control; border-radius: 4px; margin: 3px; min-width: 32px; min-height: 32px; }
QScrollBar::handle:hover { background: @secondText; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QMenu { background: @surface; border: @lineWidth solid @control; padding: 4px; }
QMenu::item { padding: 8px 30px 8px 14px; border: 2px solid transparent; border-radius: 4px; }
QMenu::item:selected { background: @selected; border-color: @selectedFrame; }
QMenu::item:disabled { color: @disabled; }
QMenu::separator { height: 1px; background: @line; margin: 4px 8px; }
QTabWidget::pane { border: none; }
QTabBar { background: transparent; }
QTabBar::tab { background: transparent; color: @secondText; padding: 0 16px; min-height: 38px; border: none; border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: @text; font-weight: 600; border-bottom: 2px solid @accent; }
QTabBar::tab:focus { color: @accent; }
)"_s;
}

} // namespace gripscope
