#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace ramify {

/// Memory that this process may use, in bytes: nine tenths of the machine's, or of what its limits (ulimit
/// -v, -d; the control group) leave of it.
double usable_memory();

/// From now on this process is one of several that share the machine: usable_memory() is a share of it.
void share_memory(unsigned processes);

/// "12.3 GB".
std::string in_bytes(double bytes);

/// Work that needs memory in proportion to a size, before it begins: throws Error where that is more than
/// usable_memory(), saying how much, and which size would fit.
/// @param what   "trees as newick"
/// @param name   of the size, as it is asked for: "--n"
/// @param bytes  needed at a size; does not fall as it grows
void require_memory(std::string_view what, std::string_view name, std::uint64_t size,
                    const std::function<double(std::uint64_t)>& bytes);

/// From now on an allocation beyond usable_memory() fails, instead of the machine: main's last resort for
/// what nobody has estimated.
void bound_memory();

}  // namespace ramify
