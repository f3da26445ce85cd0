#include <auxfem/scene/modes_definition.h>

namespace auxfem
{
  namespace
  {
    const Integer number = {
      "Number",
      10,
      1,
      1000,
      "How many modes, those of the lowest frequencies or "
      "factors of the loads."};
    const Choice about = {
      "About",
      "rest",
      {"rest", "static equilibrium"},
      "State that vibrates or, with further loads, buckles. rest: as the lattice "
      "is given, without loads; static equilibrium: that under the loads, weight and prescribed motions of t = "
      "0, with all they change of the stiffness."};
    const Quantity load_time = {
      "Time of the loads",
      "none",
      "s",
      Range::non_negative(),
      "Of Analysis = buckling: the lattice buckles under a multiple of the loads "
      "and prescribed motions of this time or, about a static equilibrium, of "
      "what they differ from those of t = 0. none: Time/End time.",
      {"none"}};
    const Boolean reversed_loads = {
      "Reversed loads",
      false,
      "Of Analysis = buckling: whether the opposite of the loads is multiplied."};
    const Boolean damped = {
      "Damped",
      false,
      "Of Analysis = modes: whether frequency and damping ratio of each mode are "
      "computed with connectors and damping of struts, too; where loads follow "
      "their joints, whether modes are those with damping."};
    const Integer relaxations = {
      "Relaxations",
      0,
      0,
      1000,
      "Of Analysis = modes: how many of the slowest motions that decay without "
      "swinging are computed, by connectors and damping of struts."};
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
    return {
      "Modes",
      SubsectionSchema::Form::fixed,
      "With Analysis = modes: natural frequencies and modes; with Analysis "
      "= buckling: factors of the loads and buckling modes.",
      {number,
       about,
       load_time,
       reversed_loads,
       damped,
       relaxations,
       amplitude,
       pictures}};
  }

  ModesDefinition read_modes(const ParameterValues &values)
  {
    ModesDefinition modes;
    modes.number            = values[number];
    modes.about_equilibrium = values[about] != "rest";
    if (!values.is_word(load_time))
      modes.load_time = values[load_time];
    modes.reversed_loads = values[reversed_loads];
    modes.damped         = values[damped];
    modes.relaxations    = values[relaxations];
    modes.amplitude      = values[amplitude];
    modes.pictures       = values[pictures];
    return modes;
  }
} // namespace auxfem
