#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/imperfections.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>

namespace auxfem
{
  namespace
  {
    void add_random(const ImperfectionDefinition &definition,
                    const Lattice                &lattice,
                    const SceneContext           &context,
                    GeometryOffsets              &offsets)
    {
      GeometryOffsets added(lattice);
      // The same numbers whatever the standard library.
      boost::random::mt19937                     generator(definition.seed);
      boost::random::normal_distribution<double> distances(
        0.,
        definition.amplitude);
      for (const unsigned int joint : joints_of(definition, lattice, context))
        for (unsigned int c = 0; c < lattice.dimension; ++c)
          added.joints[joint][c] = distances(generator);
      for (unsigned int i = 0; i < lattice.struts.size(); ++i)
        added.middles[i] = added.mean_of_ends(lattice.struts[i]);
      offsets.add(1., added);
    }

    void add_expressions(const ImperfectionDefinition &definition,
                         const Lattice                &lattice,
                         const SceneContext           &context,
                         GeometryOffsets              &offsets)
    {
      for (unsigned int c = 0; c < lattice.dimension; ++c)
        {
          PositionFunction displacement(definition.displacement[c],
                                        "expression",
                                        "",
                                        lattice,
                                        context,
                                        definition.path + "/Displacement " +
                                          "xyz"[c]);
          for (unsigned int i = 0; i < lattice.joints.size(); ++i)
            offsets.joints[i][c] += displacement.value_at(lattice.joints[i]);
          for (unsigned int i = 0; i < lattice.struts.size(); ++i)
            {
              dealii::Point<3>     middle;
              dealii::Tensor<1, 3> tangent;
              lattice.axis(lattice.struts[i], 0.5, middle, tangent);
              offsets.middles[i][c] += displacement.value_at(middle);
            }
        }
    }
  } // namespace

  GeometryOffsets given_offsets(const Scene &scene, const Lattice &lattice)
  {
    using Type = ImperfectionDefinition::Type;
    GeometryOffsets offsets(lattice);
    for (const ImperfectionDefinition &definition : scene.imperfections)
      if (definition.type == Type::random)
        add_random(definition, lattice, scene.context, offsets);
      else if (definition.type == Type::expression)
        add_expressions(definition, lattice, scene.context, offsets);
    return offsets;
  }
} // namespace auxfem
