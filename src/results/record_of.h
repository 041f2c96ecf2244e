#pragma once

#include <concepts>
#include <type_traits>

namespace aoscore {

/// A record of that type, const or not: what the member lists of records are written for.
template <class Record, class Of>
concept RecordOf = std::same_as<std::remove_const_t<Record>, Of>;

}  // namespace aoscore
