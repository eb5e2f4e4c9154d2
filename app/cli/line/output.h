// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QJsonObject>
#include <QString>

#include <optional>

namespace gripscope::cli {

/// One document on standard output, on a line of its own. Numbers in their shortest form that reads back the
/// same.
void printJson(const QJsonObject& document);
/// Text for a person, on standard output.
void print(const QString& text);
/// Progress and errors, on standard error, at once.
void message(const QString& text);

/// {"error": {"code": .., "message": ..}}
[[nodiscard]] QJsonObject errorDocument(const Error& error);
/// The same with the file it is about.
[[nodiscard]] QJsonObject errorDocument(const QString& file, const Error& error);

/// What went wrong with the whole run: told on standard error, as a document too when `json`. Returns the
/// exit code.
int fail(const Error& error, bool json = false);

/// "0.03961 ± 0.00024": half of the 95 % interval, as on screen, with two digits; without a standard error
/// six significant digits.
[[nodiscard]] QString withInterval(double value, std::optional<double> standardError);
/// Fixed digits, or "-" for a number that does not exist.
[[nodiscard]] QString fixed(std::optional<double> value, int decimals);

} // namespace gripscope::cli
