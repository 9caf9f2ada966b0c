// SPDX-License-Identifier: GPL-3.0-or-later
// A key of [joint] that states one member of a law; the reader and its checks go by it.
#pragma once

#include <functional>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

namespace blockweir::scene {

/// `Law`: a joint's law, or a part of it that it has as a base.
template <class Law>
struct LawKey {
  using Of = Law;
  enum class Range { any, not_negative, angle };

  const char* name;
  std::variant<double Law::*, std::optional<double> Law::*, bool Law::*> member;
  Range range = Range::any;
  /// Has the law a value of it that does nothing? Empty: it always does something.
  std::function<bool(const Law&)> is_idle;
  const char* without = "";              ///< what the joint then lacks
  std::vector<const char*> supplied_by;  ///< keys of what it lacks

  /// The same key of a law of which this one's is a part.
  template <class Whole>
  [[nodiscard]] LawKey<Whole> of() const {
    const auto whole = [](auto of_part) -> decltype(LawKey<Whole>::member) {
      if constexpr (std::is_same_v<decltype(of_part), double Law::*>)
        return static_cast<double Whole::*>(of_part);
      else if constexpr (std::is_same_v<decltype(of_part), bool Law::*>)
        return static_cast<bool Whole::*>(of_part);
      else
        return static_cast<std::optional<double> Whole::*>(of_part);
    };
    return {name,       std::visit(whole, member), static_cast<typename LawKey<Whole>::Range>(range), is_idle, without,
            supplied_by};
  }
};

}  // namespace blockweir::scene
