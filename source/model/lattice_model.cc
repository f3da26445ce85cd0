#include <auxfem/mesh/sets.h>
#include <auxfem/model/lattice_model.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <utility>

namespace auxfem
{
  namespace
  {
    double mean_length(const Lattice &lattice)
    {
      double sum = 0;
      for (const Strut &strut : lattice.struts)
        sum += lattice.length(strut);
      return lattice.struts.empty() ? 1. : sum / lattice.struts.size();
    }

    /** Whether a strut comes close to the direction of @p reference anywhere. */
    bool leads_along(const Lattice              &lattice,
                     const Strut                &strut,
                     const dealii::Tensor<1, 3> &reference)
    {
      // Of a full circle every 5.6 degrees, where 10 are too close.
      const unsigned int n = strut.sagitta == 0 ? 1 : 64;
      for (unsigned int i = 0; i <= n; ++i)
        {
          dealii::Point<3>     position;
          dealii::Tensor<1, 3> tangent;
          lattice.axis(strut, double(i) / n, position, tangent);
          if (nearly_parallel(tangent, reference))
            return true;
        }
      return false;
    }

    /** A section cannot be oriented by the direction of its strut. */
    void refuse_references_along_struts(const Scene   &scene,
                                        const Lattice &lattice)
    {
      if (lattice.dimension == 2)
        return;
      for (unsigned int s = 0; s < lattice.struts.size(); ++s)
        {
          const Strut &strut = lattice.struts[s];
          if (strut.is_rigid())
            continue;
          const SectionDefinition &definition = scene.sections[strut.section];
          const auto              &reference  = definition.section.reference;
          if (reference && leads_along(lattice, strut, *reference))
            throw InputError(
              definition.path + "/Reference vector: strut " +
              std::to_string(s) + " (joints " +
              std::to_string(strut.joints[0]) + " - " +
              std::to_string(strut.joints[1]) +
              ") lies along it, or within 5 degrees, so it does not orient its "
              "section. Give another vector, or struts of this direction a "
              "section of their own; auto suits all directions.");
        }
    }

    std::vector<Section> sections_of(const Scene &scene, const Lattice &lattice)
    {
      refuse_references_along_struts(scene, lattice);
      std::vector<Section> sections;
      for (const SectionDefinition &definition : scene.sections)
        sections.push_back(definition.section);
      return sections;
    }

    std::vector<std::vector<JointPair>> pairs_of(const Scene   &scene,
                                                 const Lattice &lattice)
    {
      std::vector<std::vector<JointPair>> pairs;
      for (const ConnectorDefinition &definition : scene.connectors)
        pairs.push_back(select_pairs(lattice,
                                     definition.between,
                                     scene.context,
                                     definition.path + "/Between"));
      return pairs;
    }

    std::vector<StrutDivision>
    all_divisions(std::vector<StrutDivision> divisions,
                  const Scene               &scene,
                  const Lattice             &lattice)
    {
      return divisions.empty()
        ? std::vector<StrutDivision>(lattice.struts.size(),
                                     scene.discretization.common_division())
        : std::move(divisions);
    }

    Ties all_ties(const Scene                               &scene,
                  const Lattice                             &lattice,
                  const std::vector<JointRelease>           &releases,
                  const std::vector<std::vector<JointPair>> &connector_pairs)
    {
      Ties ties       = ties_of(releases, lattice);
      ties.prescribed = prescribed_motions(scene, lattice);
      for (const std::vector<JointPair> &pairs : connector_pairs)
        ties.connected.insert(ties.connected.end(), pairs.begin(), pairs.end());
      return ties;
    }
  } // namespace

  LatticeModel::LatticeModel(const Scene               &scene,
                             const Lattice             &lattice,
                             const MPI_Comm             communicator,
                             std::vector<StrutDivision> divisions)
    : lattice(lattice)
    , simulated(decide_effects(scene, lattice))
    , sections(sections_of(scene, lattice))
    , mean_strut_length(mean_length(lattice))
    , releases(simulated.hinges ? joint_releases(scene, lattice)
                                : std::vector<JointRelease>())
    , free_spins(auxfem::free_spins(scene, lattice, releases))
    , connector_pairs(pairs_of(scene, lattice))
    , shared_numbering(std::make_shared<const DofNumbering>(
        lattice,
        StrutPartition(lattice,
                       all_divisions(std::move(divisions), scene, lattice),
                       communicator),
        all_ties(scene, lattice, releases, connector_pairs),
        communicator))
    , numbering(*shared_numbering)
    , rows(numbering.unknowns().owned_rows())
    , supports(
        make_supports(scene, lattice, numbering, simulated.large_rotation))
    , bodies(rigid_bodies(lattice, numbering))
  {}

  LatticeModel::LatticeModel(const Scene        &scene,
                             const LatticeModel &other,
                             SimulatedEffects    simulated)
    : lattice(other.lattice)
    , simulated(std::move(simulated))
    , sections(other.sections)
    , mean_strut_length(other.mean_strut_length)
    , releases(other.releases)
    , free_spins(other.free_spins)
    , connector_pairs(other.connector_pairs)
    , shared_numbering(other.shared_numbering)
    , numbering(*shared_numbering)
    , rows(other.rows)
    , supports(make_supports(scene,
                             lattice,
                             numbering,
                             this->simulated.large_rotation))
    , bodies(other.bodies)
  {}

  namespace
  {
    template <class Decisions>
    auto &decision_on(Decisions &decisions, const std::string &effect)
    {
      return *std::find_if(decisions.begin(),
                           decisions.end(),
                           [&effect](const EffectDecision &decision) {
                             return decision.name == effect;
                           });
    }
  } // namespace

  const EffectDecision &LatticeModel::decision(const std::string &effect) const
  {
    return decision_on(simulated.decisions, effect);
  }

  void LatticeModel::explain(const EffectDecision &decision)
  {
    decision_on(simulated.decisions, decision.name) = decision;
  }
} // namespace auxfem
