#include <auxfem/parameters/short_lines.h>
#include <auxfem/parameters/suggest.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace auxfem
{
  namespace
  {
    std::string lower_case(std::string text)
    {
      for (char &letter : text)
        letter =
          static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
      return text;
    }

    bool begins_with(const std::string &text, const std::string &beginning)
    {
      return text.compare(0, beginning.size(), beginning) == 0;
    }

    /**
     * Insertions, deletions, replacements and swaps of neighbours that turn
     * one word into the other (optimal string alignment).
     */
    std::size_t edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> before_last(b.size() + 1);
      std::vector<std::size_t> last(b.size() + 1);
      std::vector<std::size_t> current(b.size() + 1);
      std::iota(last.begin(), last.end(), std::size_t(0));
      for (std::size_t i = 1; i <= a.size(); ++i)
        {
          current[0] = i;
          for (std::size_t j = 1; j <= b.size(); ++j)
            {
              current[j] = std::min({last[j] + 1,
                                     current[j - 1] + 1,
                                     last[j - 1] + (a[i - 1] != b[j - 1])});
              if (i > 1 && j > 1 && a[i - 1] == b[j - 2] &&
                  a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], before_last[j - 2] + 1);
            }
          before_last.swap(last);
          last.swap(current);
        }
      return last.back();
    }

    bool is_near(const std::string &a, const std::string &b)
    {
      const std::size_t shorter  = std::min(a.size(), b.size());
      const std::size_t distance = edit_distance(a, b);
      // Beyond a third of the letters suggestions mislead; a short name needs
      // one letter of freedom, but not to become any other of its length.
      const std::size_t limit =
        std::max<std::size_t>(1, std::max(a.size(), b.size()) / 3);
      return (distance <= limit && distance < shorter) || distance == 0 ||
        (shorter >= 2 && (begins_with(a, b) || begins_with(b, a)));
    }
  } // namespace

  std::vector<std::string> nearest_names(const std::string              &name,
                                         const std::vector<std::string> &known)
  {
    const std::string                                wanted = lower_case(name);
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const auto &candidate : known)
      if (is_near(wanted, lower_case(candidate)))
        near.emplace_back(edit_distance(wanted, lower_case(candidate)),
                          candidate);
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());

    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(n_listed, near.size()); ++i)
      names.push_back(near[i].second);
    return names;
  }

  std::string did_you_mean(const std::string              &name,
                           const std::vector<std::string> &known)
  {
    const auto names = nearest_names(name, known);
    if (names.empty())
      return ".";
    std::string text = "; did you mean ";
    for (std::size_t i = 0; i < names.size(); ++i)
      text += (i == 0 ? "\"" : " or \"") + names[i] + "\"";
    return text + "?";
  }
} // namespace auxfem
