#include <auxfem/mesh/imperfection.h>
#include <auxfem/mesh/strut_geometry.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    dealii::Tensor<1, 3> chord_of(const Lattice &lattice, const Strut &strut)
    {
      return lattice.joints[strut.joints[1]] - lattice.joints[strut.joints[0]];
    }

    /** Bends @p strut of the former @p rise (m): its middle moves by @p bow (m)
     * relative to its ends. */
    void bend(const dealii::Tensor<1, 3> &rise,
              const dealii::Tensor<1, 3> &bow,
              const Lattice              &lattice,
              Strut                      &strut)
    {
      const dealii::Tensor<1, 3> chord = chord_of(lattice, strut),
                                 along = chord / chord.norm();
      const dealii::Tensor<1, 3> bent  = rise + bow;
      // An offset of the middle along the strut does not bend it.
      const auto arc =
        arc_through(chord, chord / 2 + (bent - (bent * along) * along));
      if (!arc)
        return;
      strut.sagitta = arc->sagitta;
      strut.normal  = arc->normal;
    }
  } // namespace

  GeometryOffsets::GeometryOffsets(const Lattice &lattice)
    : joints(lattice.n_structural_joints())
    , middles(lattice.struts.size())
  {}

  double GeometryOffsets::largest() const
  {
    double largest = 0;
    for (const auto *offsets : {&joints, &middles})
      for (const dealii::Tensor<1, 3> &offset : *offsets)
        largest = std::max(largest, offset.norm());
    return largest;
  }

  void GeometryOffsets::add(const double factor, const GeometryOffsets &others)
  {
    for (std::size_t i = 0; i < joints.size(); ++i)
      joints[i] += factor * others.joints[i];
    for (std::size_t i = 0; i < middles.size(); ++i)
      middles[i] += factor * others.middles[i];
  }

  void disturb(const GeometryOffsets &offsets, Lattice &lattice)
  {
    const auto designed = std::make_shared<const Lattice>(lattice);
    for (std::size_t i = 0; i < lattice.joints.size(); ++i)
      lattice.joints[i] += offsets.joints[i];
    // Smaller offsets are round-off of positions.
    const double smallest_bow = 1e-12 * offsets.largest();
    for (std::size_t i = 0; i < lattice.struts.size(); ++i)
      {
        Strut                     &strut = lattice.struts[i];
        const dealii::Tensor<1, 3> bow =
          offsets.middles[i] - offsets.mean_of_ends(strut);
        if (bow.norm() > smallest_bow)
          bend(rise_of_arc(chord_of(*designed, strut),
                           strut.sagitta,
                           strut.normal),
               bow,
               lattice,
               strut);
      }
    lattice.as_designed = designed;
  }

  namespace
  {
    const Choice imperfection_type = {
      "Type",
      "random",
      {"random", "expression", "buckling mode", "result"},
      "Kind of deviation of the stress-free lattice."};
    const Quantity deviation = {
      "Standard deviation",
      "",
      "m",
      Range::non_negative(),
      "Standard deviation of each coordinate of a joint."};
    const Text                disturbed_joints = {"Joints",
                                                  "all",
                                                  "Set of joints that are displaced."};
    const Integer             seed             = {"Seed",
                                                  1,
                                                  0,
                                                  2147483647,
                                                  "Seed of the random numbers."};
    const std::array<Text, 3> disturbances     = {
          {{"Displacement x",
            "0",
            "Expression in x, y, z and xmin, xmax, ... (m), random(seed) and normal(seed)."},
           {"Displacement y",
            "0",
            "Expression in x, y, z and xmin, xmax, ... (m), random(seed) and normal(seed)."},
           {"Displacement z",
            "0",
            "Expression in x, y, z and xmin, xmax, ... (m), random(seed) and normal(seed)."}}};
    const Quantity largest_offset = {
      "Amplitude",
      "",
      "m",
      Range::any(),
      "Largest displacement; negative: in the opposite direction."};
    const Integer mode_number = {
      "Mode",
      1,
      1,
      1000,
      "Number of the linear buckling mode under the loads of Modes/Time of the "
      "loads; 1 for the lowest factor."};
    const Text result_folder = {
      "Folder",
      "",
      "Output folder of a run of the same lattice and mesh; its last checkpoint "
      "has the displacements.",
      true};
  } // namespace

  SubsectionSchema imperfections_schema()
  {
    return {
      "Imperfections",
      SubsectionSchema::Form::named_groups,
      "Deviations of the stress-free lattice from the designed one; several add "
      "up. Sets and positions refer to the designed lattice.",
      {imperfection_type},
      "Type",
      {{"random",
        "Normally distributed displacements of joints; struts keep their shape.",
        {deviation, disturbed_joints, seed}},
       {"expression",
        "Displacements of joints and strut middles by expressions; struts become "
        "arcs.",
        {disturbances[0], disturbances[1], disturbances[2]}},
       {"buckling mode",
        "Displacements of joints and strut middles by a buckling mode of the "
        "designed lattice.",
        {largest_offset, mode_number}},
       {"result",
        "Displacements of joints and strut middles at the end of another run.",
        {largest_offset, result_folder}}}};
  }

  ImperfectionDefinition read_imperfection(const ParameterValues &values)
  {
    ImperfectionDefinition imperfection;
    imperfection.name      = values.name();
    imperfection.path      = values.context.path;
    const std::string type = values[imperfection_type];
    if (type == "random")
      {
        imperfection.amplitude = values[deviation];
        imperfection.joints    = values[disturbed_joints];
        imperfection.seed      = values[seed];
      }
    else if (type == "expression")
      {
        imperfection.type = ImperfectionDefinition::Type::expression;
        for (unsigned int c = 0; c < 3; ++c)
          imperfection.displacement[c] = values[disturbances[c]];
        require_space(values, disturbances[2]);
      }
    else if (type == "result")
      {
        imperfection.type      = ImperfectionDefinition::Type::result;
        imperfection.amplitude = values[largest_offset];
        imperfection.folder    = values[result_folder];
      }
    else
      {
        imperfection.type      = ImperfectionDefinition::Type::buckling_mode;
        imperfection.amplitude = values[largest_offset];
        imperfection.mode      = values[mode_number];
      }
    return imperfection;
  }
} // namespace auxfem
