#include <auxfem/output/console.h>
#include <auxfem/output/verdict.h>

#include <algorithm>
#include <array>

namespace auxfem
{
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

  void add_verdict(JsonObject &summary, const std::vector<Finding> &findings)
  {
    std::vector<JsonObject> warnings;
    for (const Finding &finding : findings)
      {
        JsonObject warning;
        warning.add("verdict", name_of(finding.verdict));
        warning.add("text", finding.text);
        warning.add("time", finding.time);
        if (!finding.place.empty())
          warning.add("place", finding.place);
        warnings.push_back(warning);
      }
    summary.add("verdict", name_of(verdict_of(findings)));
    summary.add("warnings", warnings);
  }

  std::string verdict_text(const std::vector<Finding> &findings)
  {
    std::string text = "Verdict: " + name_of(verdict_of(findings));
    for (const Finding &finding : findings)
      text += '\n' + indented(finding.text);
    return text;
  }
} // namespace auxfem
