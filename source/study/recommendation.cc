#include <auxfem/study/recommendation.h>

#include <array>

namespace auxfem
{
  std::string recommendations_text(const Scene     &scene,
                                   const Recommend &recommend)
  {
    constexpr std::array<std::pair<double, const char *>, 6> targets = {
      {{1e-6, "0.0001 %"},
       {1e-5, "0.001 %"},
       {1e-4, "0.01 %"},
       {1e-3, "0.1 %"},
       {1e-2, "1 %"},
       {1e-1, "10 %"}}};
    const Settings          own = settings_of(scene);
    std::string             text;
    std::optional<Settings> latest;
    for (const auto &[target, name] : targets)
      {
        const auto recommended = recommend(target);
        if (!recommended || (latest && recommended->settings == *latest))
          continue;
        latest = recommended->settings;
        const std::string changes =
          command_line_text(overrides(own, recommended->settings));
        text = "- for " + std::string(name) + ":" +
          (changes.empty() ? " the scene as it is" : changes) + "  (" +
          recommended->remark + ")\n" + text;
      }
    return text.empty() ? "No settings of the study give an error below 10 %.\n"
                        : text;
  }
} // namespace auxfem
