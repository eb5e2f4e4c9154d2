// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

class SharedLink;

/// Brings and fetches until the link ends; may wait for the network.
void exchangeUntilEnd(SharedLink& state);

/// Counts what waits, notes how far the server is, and hangs up on a server that takes too long, until the
/// link ends; never waits for the network.
void watchUntilEnd(SharedLink& state);

} // namespace gripscope
