#include <auxfem/scene/output_parameters.h>

namespace auxfem
{
  namespace
  {
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
      "Time between two of them, from within steps if these do not end there; 0: "
      "at start and end only."};
    const Integer checkpoints = {
      "Checkpoints",
      20,
      0,
      1000000,
      "Number of checkpoints, after equal numbers of steps. `auxfem --resume DIR` "
      "continues from the last one, with equal digits. They are written as often "
      "as 0.3 % of the run's time allow, and after SIGINT and SIGTERM. 0: none."};
    const Integer history_interval = {
      "History interval",
      1,
      1,
      1000000000,
      "Number of steps between two rows of history.csv."};
    const Quantity row_interval = {
      "Time between rows",
      "none",
      "s",
      Range::positive(),
      "Time between two rows of history.csv, in place of a number of steps: from "
      "within steps, by polynomials of the order of the time scheme, if these do "
      "not end there. So steps may be as long as accuracy allows. Forces and "
      "energies are straight lines where that motion is out of equilibrium. "
      "none: at ends of steps.",
      {"none"}};
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
      "then give effective Poisson's ratios for the axis that is loaded, y if "
      "that is not one alone."};

    const Boolean verdict_fails = {
      "Exit code by verdict",
      true,
      "Whether auxfem ends with exit code 3 where the verdict on a run is that "
      "its results are not to be used."};
  } // namespace



  SubsectionSchema output_schema()
  {
    return {"Output",
            SubsectionSchema::Form::fixed,
            "What a run writes.",
            {directory,
             graphics,
             graphics_interval,
             history_interval,
             checkpoints,
             row_interval,
             segments,
             effective_strains,
             verdict_fails},
            "",
            {},
            {Model::lattice, Model::reduced_cell}};
  }



  OutputParameters read_output(ParameterValues &values)
  {
    OutputParameters output;
    output.directory         = values[directory];
    output.graphics          = values[graphics];
    output.graphics_interval = values[graphics_interval];
    output.history_interval  = values[history_interval];
    output.checkpoints       = values[checkpoints];
    if (!values.is_word(row_interval))
      output.row_interval = values[row_interval];
    output.segments          = values[segments];
    output.effective_strains = values[effective_strains];
    output.verdict_fails     = values[verdict_fails];
    return output;
  }



  SubsectionSchema probes_schema()
  {
    return {
      "Probes",
      SubsectionSchema::Form::free_entries,
      "Sets of joints whose mean motion goes to history.csv: the name "
      "of a set, or a selection of joints as in Sets (without "
      "\"joints: \"); or \"rigid: PARTS @ JOINTS\", PARTS a set of struts or "
      "the name of a group of Rigid parts, for the rotation of these parts "
      "and, if \"@ JOINTS\" is given, the forces of these "
      "joints on them."};
  }



  ProbeDefinition read_probe(ParameterValues &values)
  {
    return {values.name(), text_of_free_entry(values), values.context.path};
  }
} // namespace auxfem
