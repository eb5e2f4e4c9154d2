// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

/// The schema as numbered scripts, one file each, never edited after a release (a checksum in every library
/// sees it).
extern const char* const migrationScript1;
extern const char* const migrationScript2;
extern const char* const migrationScript3;
extern const char* const migrationScript4;
extern const char* const migrationScript5;
extern const char* const migrationScript6;
extern const char* const migrationScript7;
extern const char* const migrationScript8;
extern const char* const migrationScript9;
extern const char* const migrationScript10;

} // namespace gripscope
