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

    /** Whether a strut is nearly parallel to @p reference anywhere. */
    bool is_nearly_along(const Lattice              &lattice,
                         const Strut                &strut,
                         const dealii::Tensor<1, 3> &reference)
    {
      // A full circle is sampled every 5.6 degrees; within 5 degrees counts as
      // parallel.
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

    /** Rejects reference vectors parallel to a strut, which do not orient its
     * section. */
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
          if (reference && is_nearly_along(lattice, strut, *reference))
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

    /** Sections as the run simulates them. */
    std::vector<Section> sections_of(const RunPlan &plan,
                                     const Lattice &lattice)
    {
      std::vector<Section>    sections;
      const std::vector<bool> strained =
        sections_with_initial_strains(plan, lattice);
      for (const SectionDefinition &definition : plan.scene.sections)
        {
          const Section &section = definition.section;
          sections.push_back((section.yields()
                                ? plan.simulated.plasticity
                                : plan.simulated.strut_relaxation)
                               ? section
                               : section.relaxed());
          if (!sections.back().law && strained[sections.size() - 1])
            sections.back().law = make_elastic_section_law();
        }
      return sections;
    }

    /** The laws of @p sections, each once, the elastic one first. */
    std::vector<std::shared_ptr<const SectionLaw>>
    laws_of(const std::vector<Section> &sections)
    {
      std::vector<std::shared_ptr<const SectionLaw>> laws = {nullptr};
      for (const Section &section : sections)
        if (std::find(laws.begin(), laws.end(), section.law) == laws.end())
          laws.push_back(section.law);
      return laws;
    }

    /** @p laws with the elastic one in place of those that are not
     * simulated. */
    std::vector<std::shared_ptr<const SectionLaw>>
    simulated_laws(std::vector<std::shared_ptr<const SectionLaw>> laws,
                   const InitialStrains   &initial_strains,
                   const SimulatedEffects &simulated)
    {
      for (auto &law : laws)
        if (law && law->loses_energy() &&
            !(law->yields() ? simulated.plasticity
                            : simulated.strut_relaxation))
          law = initial_strains.strains.empty() ? nullptr
                                                : make_elastic_section_law();
      return laws;
    }

    /** Number in @p laws by section. */
    std::vector<unsigned int>
    law_numbers(const std::vector<Section>                           &sections,
                const std::vector<std::shared_ptr<const SectionLaw>> &laws)
    {
      std::vector<unsigned int> numbers;
      for (const Section &section : sections)
        numbers.push_back(std::find(laws.begin(), laws.end(), section.law) -
                          laws.begin());
      return numbers;
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

    RunPlan with_effects(RunPlan plan, SimulatedEffects simulated)
    {
      plan.simulated = std::move(simulated);
      return plan;
    }

    std::vector<StrutDivision> divisions_of(const RunPlan &plan,
                                            const Lattice &lattice)
    {
      return plan.elements && !plan.elements->divisions.empty()
        ? plan.elements->divisions
        : std::vector<StrutDivision>(lattice.struts.size(), plan.division);
    }

    std::vector<LinearRelation>
    all_relations(const RunPlan                   &plan,
                  const Lattice                   &lattice,
                  const std::vector<JointRelease> &releases,
                  const double                     length)
    {
      std::vector<LinearRelation> relations =
        linear_relations(plan.scene, lattice, length);
      // Waves have a phase between images.
      if (plan.analysis == Analysis::dispersion)
        return relations;
      for (LinearRelation &relation :
           periodic_relations(lattice, releases, length))
        relations.push_back(std::move(relation));
      return relations;
    }

    Ties all_ties(const Scene                               &scene,
                  const Lattice                             &lattice,
                  const std::vector<JointRelease>           &releases,
                  const std::vector<LinearRelation>         &relations,
                  const std::vector<std::vector<JointPair>> &connector_pairs)
    {
      Ties ties       = ties_of(releases, lattice);
      ties.relations  = relations;
      ties.prescribed = prescribed_motions(scene, lattice);
      for (const std::vector<JointPair> &pairs : connector_pairs)
        ties.connected.insert(ties.connected.end(), pairs.begin(), pairs.end());
      return ties;
    }
  } // namespace

  LatticeModel::LatticeModel(const RunPlan &given,
                             const Lattice &lattice,
                             const MPI_Comm communicator)
    : plan(with_effects(given, decide_effects(given, lattice)))
    , lattice(lattice)
    , sections(sections_of(plan, lattice))
    , initial_strains(make_initial_strains(plan, lattice, sections))
    , laws(laws_of(sections))
    , mean_strut_length(mean_length(lattice))
    , releases(plan.simulated.hinges ? joint_releases(plan.scene, lattice)
                                     : std::vector<JointRelease>())
    , relations(all_relations(plan, lattice, releases, mean_strut_length))
    , free_spins(auxfem::free_spins(plan, lattice, releases, relations))
    , connector_pairs(pairs_of(plan.scene, lattice))
    , shared_numbering(std::make_shared<const DofNumbering>(
        lattice,
        StrutPartition(lattice, divisions_of(plan, lattice), communicator),
        all_ties(plan.scene, lattice, releases, relations, connector_pairs),
        communicator,
        law_numbers(sections, laws)))
    , numbering(*shared_numbering)
    , rows(numbering.unknowns().owned_rows())
    , supports(
        make_supports(plan, lattice, numbering, plan.simulated.large_rotation))
    , bodies(rigid_bodies(lattice, numbering))
  {
    refuse_references_along_struts(plan.scene, lattice);
    check_relations(relations, numbering, plan.simulated.large_rotation);
  }

  LatticeModel::LatticeModel(const LatticeModel &other,
                             SimulatedEffects    simulated)
    : plan(with_effects(other.plan, std::move(simulated)))
    , lattice(other.lattice)
    , sections(sections_of(plan, lattice))
    , initial_strains(other.initial_strains)
    , laws(simulated_laws(other.laws, initial_strains, plan.simulated))
    , mean_strut_length(other.mean_strut_length)
    , releases(other.releases)
    , relations(other.relations)
    , free_spins(other.free_spins)
    , connector_pairs(other.connector_pairs)
    , shared_numbering(other.shared_numbering)
    , numbering(*shared_numbering)
    , rows(other.rows)
    , supports(
        make_supports(plan, lattice, numbering, plan.simulated.large_rotation))
    , bodies(other.bodies)
  {}
} // namespace auxfem
