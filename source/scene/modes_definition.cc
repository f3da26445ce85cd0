#include <auxfem/scene/modes_definition.h>

namespace auxfem
{
  namespace
  {
    const Integer number = {"Number",
                            10,
                            1,
                            1000,
                            "How many modes, those of the lowest frequencies."};
    const Choice  about  = {
        "About",
        "rest",
        {"rest", "static equilibrium"},
        "State that vibrates. rest: as the lattice is given, without loads; static "
          "equilibrium: that under the loads, weight and prescribed motions of t = "
          "0, with all they change of the stiffness."};
    const Quantity amplitude = {
      "Amplitude",
      "0.05",
      "1",
      Range::positive(),
      "Largest displacement in the files for ParaView, over the largest "
      "extension of the lattice."};
    const Integer pictures = {"Pictures",
                              16,
                              1,
                              1000,
                              "Files for ParaView of one period of each mode."};
  } // namespace

  SubsectionSchema modes_schema()
  {
    return {"Modes",
            SubsectionSchema::Form::fixed,
            "With Analysis = modes: natural frequencies and modes.",
            {number, about, amplitude, pictures},
            "",
            {},
            {Model::lattice}};
  }

  ModesDefinition read_modes(const ParameterValues &values)
  {
    ModesDefinition modes;
    modes.number            = values[number];
    modes.about_equilibrium = values[about] != "rest";
    modes.amplitude         = values[amplitude];
    modes.pictures          = values[pictures];
    return modes;
  }
} // namespace auxfem
