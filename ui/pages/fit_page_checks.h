// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/validity.h"
#include "core/signal/preparation.h"

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace gripscope {

/// A tick, a warning or a cross, drawn; told apart by shape, and named for a screen reader.
enum class CheckSign { Pass, Warning, Fail };

class CheckSignLabel : public QWidget {
    Q_OBJECT
public:
    explicit CheckSignLabel(CheckSign sign, QWidget* parent = nullptr);
    void setSign(CheckSign sign);
    QSize sizeHint() const override { return {20, 20}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    CheckSign m_sign;
};

/// The verdict on the measurement, with its sign: "Measurement valid".
class ValidityLine : public QWidget {
    Q_OBJECT
public:
    explicit ValidityLine(QWidget* parent = nullptr);
    void setVerdict(ValidityVerdict verdict);

private:
    CheckSignLabel* m_sign;
    QLabel* m_words;
};

/// Every check with what was found, those that failed first; then what was done to the recording before.
class CheckList : public QWidget {
    Q_OBJECT
public:
    explicit CheckList(QWidget* parent = nullptr);
    void setFindings(const Validity& validity, const std::vector<PreparationStep>& preparation);

private:
    QVBoxLayout* m_rows;
};

} // namespace gripscope
