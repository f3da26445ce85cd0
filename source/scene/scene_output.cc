#include <auxfem/scene/scene_sections.h>

namespace auxfem
{
  namespace
  {
    using Form = SubsectionKind::Form;
    using dealii::ParameterHandler;

    const Text directory = {
      "Directory",
      "output",
      "Folder for everything a run writes, from where auxfem is called."};
    const Boolean  graphics          = {"Graphics",
                                        true,
                                        "Whether files for ParaView are written."};
    const Quantity graphics_interval = {
      "Graphics interval",
      "0 s",
      "s",
      Range::non_negative(),
      "Time between two of them; 0: at start and end only."};
    const Integer history_interval = {
      "History interval",
      1,
      1,
      1000000000,
      "Number of steps between two rows of history.csv."};
    const Integer segments = {
      "Segments per element",
      8,
      1,
      100,
      "Number of straight pieces an element is drawn with."};
    const Boolean effective_strains = {
      "Effective strains",
      false,
      "Whether history.csv has the columns strain.x, strain.y and in space "
      "strain.z: the mean displacement of the joint set right minus that of "
      "left over their mean distance at rest, so too for top and bottom, front "
      "and back, where both sets exist and are apart. The last lines of a run "
      "then give effective Poisson's ratios for a load along y."};

    const Boolean verdict_fails = {
      "Exit code by verdict",
      true,
      "Whether auxfem ends with exit code 3 where the verdict on a run is that "
      "its results are not to be used."};

    void read_output(ParameterHandler &prm,
                     const std::string &,
                     const SceneContext &,
                     Scene &scene)
    {
      scene.output.directory         = get(prm, directory);
      scene.output.graphics          = get(prm, graphics);
      scene.output.graphics_interval = get(prm, graphics_interval);
      scene.output.history_interval  = get(prm, history_interval);
      scene.output.segments          = get(prm, segments);
      scene.output.effective_strains = get(prm, effective_strains);
      scene.output.verdict_fails     = get(prm, verdict_fails);
    }
  } // namespace



  std::vector<SubsectionKind> output_kinds()
  {
    return {
      {"Output",
       Form::fixed,
       "What a run writes.",
       [](ParameterHandler &prm) {
         declare(prm, directory);
         declare(prm, graphics);
         declare(prm, graphics_interval);
         declare(prm, history_interval);
         declare(prm, segments);
         declare(prm, effective_strains);
         declare(prm, verdict_fails);
       },
       "",
       {},
       read_output,
       {Model::lattice, Model::reduced_cell}},
      {"Probes",
       Form::free_entries,
       "Sets of joints whose mean motion goes to history.csv: the name "
       "of a set, or a selection of joints as in Sets (without "
       "\"joints: \"); or \"rigid: PARTS @ JOINTS\", PARTS a set of struts or "
       "the name of a group of Rigid parts, for the rotation of these parts "
       "and, if \"@ JOINTS\" is given, the forces of these "
       "joints on them.",
       {},
       "",
       {},
       [](ParameterHandler   &prm,
          const std::string  &name,
          const SceneContext &context,
          Scene              &scene) {
         scene.output.probes.push_back({name, prm.get(name), context.path});
       }}};
  }
} // namespace auxfem
