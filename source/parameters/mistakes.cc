#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/mistakes.h>
#include <auxfem/parameters/short_lines.h>

#include <algorithm>

namespace auxfem
{
  void Mistakes::add(const std::string &message)
  {
    messages.push_back(with_short_lines(message));
  }



  void Mistakes::throw_if_any(const std::string &file) const
  {
    // at two or three lines a mistake, these fill a screen
    constexpr std::size_t n_shown = 10;
    if (messages.empty())
      return;
    if (messages.size() == 1)
      throw InputError(messages.front());
    std::string text =
      file + " has " + std::to_string(messages.size()) + " mistakes:";
    for (std::size_t i = 0; i < std::min(n_shown, messages.size()); ++i)
      text += "\n" + messages[i];
    if (messages.size() > n_shown)
      text += "\n... and " + std::to_string(messages.size() - n_shown) +
        " more, shown once these are corrected";
    throw InputError(text);
  }
} // namespace auxfem
