#include <auxfem/output/first_rank.h>
#include <auxfem/output/notes.h>
#include <auxfem/output/run_report.h>
#include <auxfem/output/summary.h>

#include <iostream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  RunReport::RunReport(const Scene          &scene,
                       const Equations      &equations,
                       const FileRules      &rules,
                       const FolderContents &further)
    : scene(scene)
    , notes(notes_on(equations))
  {
    const UnknownLayout &layout = equations.unknowns().layout;
    const Counts         counts = count(equations);
    on_first_rank(layout.communicator(), [&]() {
      files.emplace(scene, rules, further);
      console.emplace(std::cout,
                      terminal_width(layout.n_ranks()),
                      files->log());
      print(overview_text(scene,
                          counts,
                          equations.model().plan.simulated.decisions,
                          notes) +
            '\n');
    });
  }

  void RunReport::print(const std::string &text)
  {
    console->print(text);
  }

  void RunReport::claim_series(const std::vector<std::string> &names)
  {
    for (const std::string &name : names)
      files->claim_series(name);
  }

  void RunReport::finish(const Json                 &found,
                         const std::vector<Finding> &findings)
  {
    Json json = json_of_run(scene, "completed", 0);
    add_verdict(json, findings);
    json.update(found);
    if (!notes.empty())
      json["notes"] = notes;
    const std::string &folder = scene.output.directory;
    replace_file(folder + "/summary.json", json.dump(2) + '\n');
    print("  Results are in " + folder);
    print(verdict_text(findings));
  }
} // namespace auxfem
