// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

class Database;
struct LibraryVerification;

/// What follows from something else is worked out again: each recording is unpacked and held against its own
/// SHA-256, the pictures and the recordings of enrolments under way likewise, and the estimate that stands
/// for a squeeze is made anew from its recording. The estimate may differ by a standard error: the squeezes
/// of a session tell together how a gripper holds its force, and a later program may estimate a little
/// better. Takes as long as identifying all of them.
void recompute(Database& database, LibraryVerification& found);

} // namespace gripscope
