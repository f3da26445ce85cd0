#include <auxfem/mesh/arc.h>
#include <auxfem/mesh/imperfection.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    dealii::Tensor<1, 3> chord_of(const Lattice &lattice, const Strut &strut)
    {
      return lattice.joints[strut.joints[1]] - lattice.joints[strut.joints[0]];
    }

    /** Of @p strut, whose middle moves by @p bow (m) against its ends. */
    void bend(const dealii::Tensor<1, 3> &rise,
              const dealii::Tensor<1, 3> &bow,
              const Lattice              &lattice,
              Strut                      &strut)
    {
      const dealii::Tensor<1, 3> chord = chord_of(lattice, strut),
                                 along = chord / chord.norm();
      const dealii::Tensor<1, 3> bent  = rise + bow;
      // Along the strut a middle has nowhere to go.
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
    // Less is the round-off of positions.
    const double least = 1e-12 * offsets.largest();
    for (std::size_t i = 0; i < lattice.struts.size(); ++i)
      {
        Strut                     &strut = lattice.struts[i];
        const dealii::Tensor<1, 3> bow =
          offsets.middles[i] - offsets.mean_of_ends(strut);
        if (bow.norm() > least)
          bend(rise_of_arc(chord_of(*designed, strut),
                           strut.sagitta,
                           strut.normal),
               bow,
               lattice,
               strut);
      }
    lattice.as_designed = designed;
  }
} // namespace auxfem
