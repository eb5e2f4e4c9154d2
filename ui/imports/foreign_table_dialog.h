// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/foreign_table.h"
#include "ui/windows/dialog.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace gripscope {

/// Asks what in a table of another program is what: how it is written, which columns hold time, force and
/// position, in which units. Below it stand the first rows and what would be taken of them, or what is wrong
/// with line and column. Goes when it is closed; stays when the file could not be read so.
class ForeignTableDialog : public Dialog {
    Q_OBJECT
public:
    /// `name` stands for the file in words; `head` is its beginning in UTF-8; `proposal` has columns.
    ForeignTableDialog(const QString& name, QByteArray head, const CsvReadOptions& proposal, QWidget* parent);

    [[nodiscard]] CsvReadOptions options() const; ///< as it stands now
    void setReading(bool reading);                ///< the whole file is being read
    void showProblem(const QString& words);

signals:
    void wanted(const gripscope::CsvReadOptions& options); ///< Import was pressed

private:
    [[nodiscard]] QWidget* buildFormat(const CsvFormat& format);
    [[nodiscard]] QWidget* buildColumns(const CsvReadOptions& proposal);
    [[nodiscard]] QWidget* buildPreview();
    [[nodiscard]] QWidget* buildButtons();
    void ask(QGridLayout* grid, int row, int column, const QString& words, QWidget* control);
    [[nodiscard]] CsvFormat format() const;
    void setColumns(const CsvColumns& columns);
    void examine(); ///< the format is another one
    void refresh(); ///< columns or units are other ones
    void showRows();

    QString m_name;
    QByteArray m_head;
    ForeignTable m_table;
    CsvColumns m_columns; ///< as chosen when the table last had some
    bool m_reading = false;
    QComboBox *m_delimiter = nullptr, *m_mark = nullptr;
    QSpinBox *m_skipped = nullptr, *m_below = nullptr;
    QCheckBox* m_header = nullptr;
    QComboBox *m_time = nullptr, *m_force = nullptr, *m_position = nullptr, *m_hold = nullptr;
    QComboBox *m_timeUnit = nullptr, *m_forceUnit = nullptr, *m_positionUnit = nullptr;
    QDoubleSpinBox* m_sampleTime = nullptr;
    QTableWidget* m_preview = nullptr;
    QLabel* m_words = nullptr;
    QPushButton* m_import = nullptr;
};

} // namespace gripscope
