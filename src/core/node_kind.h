#pragma once

#include <cstddef>
#include <string>

namespace aoscore {

/// The kind of node that this machine is: what the environment variable AOSCORE_NODE_KIND says, else the
/// processor's name with the number of cores that this process may use. Machines of one kind count as equally
/// fast.
std::string own_node_kind();

/// Chooses the kind of node whose times count, in place of this machine's own.
void choose_node_kind(const std::string& kind);
/// The kind of node whose times count.
std::string node_kind();

/// Whether this machine may take times: it is of the kind whose times count.
bool takes_times();
/// Throws usage_error where it may not; `what` is what would take them.
void require_times_here(const std::string& what);

/// Says where times are taken, and that this machine is none of those.
std::string times_elsewhere_text();
/// Says that `count` times are left out, since this machine may not take them.
std::string times_left_out_text(std::size_t count);

/// What times are kept by: node_kind(), and the number of threads where the user chose one.
std::string timed_on();

/// How results name the machine: by its processor, by the kind of node too where that has a name, and where
/// the times are another kind's, by that.
std::string machine_name();

}  // namespace aoscore
