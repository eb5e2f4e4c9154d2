// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

#ifdef __x86_64__
namespace detail {

[[gnu::target("avx")]] inline void releaseUpperHalves()
{
    __builtin_ia32_vzeroupper();
}

} // namespace detail
#endif

/// Says to the processor that nothing is left in the upper halves of this thread's vector registers, which no
/// function may count on. To be called by a thread before it computes for long.
///
/// Qt's hash of a text (6.4, where the processor has VAES) leaves them in use, and a thread hands that on to
/// those that it starts. From then on an x86 processor waits at each change between instructions of SSE,
/// which this program is compiled to, and of AVX, which the C library chooses as it runs: erfc and log in
/// turn take ten times as long.
inline void releaseVectorRegisters()
{
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx"))
        detail::releaseUpperHalves();
#endif
}

} // namespace gripscope
