#include <auxfem/output/console.h>
#include <auxfem/output/verdict.h>

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

namespace auxfem
{
  Finding nothing_computed(const double time)
  {
    return {Verdict::not_to_be_used,
            "The run ended before its first step was done: nothing is computed "
            "but what it starts from.",
            time,
            ""};
  }

  Finding incomplete(const double time)
  {
    return {Verdict::doubtful,
            "The run is incomplete: it ended before its end. All results, "
            "largest values too, are those of the part that was done.",
            time,
            ""};
  }

  Verdict verdict_of(const std::vector<Finding> &findings)
  {
    Verdict worst = Verdict::sound;
    for (const Finding &finding : findings)
      worst = std::max(worst, finding.verdict);
    return worst;
  }

  const std::string &name_of(const Verdict verdict)
  {
    static const std::array<std::string, 3> names = {
      {"sound", "doubtful", "not to be used"}};
    return names[static_cast<unsigned int>(verdict)];
  }

  void add_verdict(Json &summary, const std::vector<Finding> &findings)
  {
    Json warnings = Json::array();
    for (const Finding &finding : findings)
      {
        Json warning = {{"verdict", name_of(finding.verdict)},
                        {"text", finding.text},
                        {"time", finding.time}};
        if (!finding.location.empty())
          warning["location"] = finding.location;
        warnings.push_back(warning);
      }
    summary["verdict"]  = name_of(verdict_of(findings));
    summary["warnings"] = warnings;
  }

  std::string verdict_text(const std::vector<Finding> &findings)
  {
    std::string text = "Verdict: " + name_of(verdict_of(findings));
    for (const Finding &finding : findings)
      text += '\n' + indented(finding.text);
    return text;
  }
} // namespace auxfem
