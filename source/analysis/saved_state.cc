#include <auxfem/analysis/saved_state.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/model/unknown_records.h>

#include <deal.II/base/mpi.h>

namespace auxfem
{
  namespace
  {
    const std::string record       = "state",
                      before       = record + " before the last step",
                      position     = record + " on a path",
                      displacement = ": displacement", residual = ": residual";

    /** Vectors that a state may have, by name. */
    template <class StateType>
    auto optional_vectors(StateType &state)
    {
      return std::array{std::pair(": velocity", &state.velocity),
                        std::pair(": acceleration", &state.acceleration),
                        std::pair(": algorithmic acceleration",
                                  &state.algorithmic_acceleration),
                        std::pair(": compensation", &state.compensation),
                        std::pair(": unknowns without mass",
                                  &state.is_massless)};
    }

    /** Large rotations in space are known by the first of their unknowns. */
    std::vector<unsigned int> rotation_items(const UnknownRecords &unknowns,
                                             const DofNumbering   &numbering,
                                             const std::size_t     n)
    {
      std::vector<unsigned int> items;
      for (unsigned int i = 0; i < n; ++i)
        items.push_back(unknowns.serial_number(numbering.rotations()[i][0]));
      return items;
    }

    void save_rotations(const State          &state,
                        const UnknownRecords &unknowns,
                        const DofNumbering   &numbering,
                        Records              &records)
    {
      std::vector<double> components;
      for (const Quaternion &rotation : state.rotations)
        {
          components.push_back(rotation.scalar);
          for (unsigned int d = 0; d < 3; ++d)
            components.push_back(rotation.vector[d]);
        }
      records.keep(record + ": rotations",
                   rotation_items(unknowns, numbering, state.rotations.size()),
                   4,
                   components);
    }

    void resume_rotations(const UnknownRecords &unknowns,
                          const DofNumbering   &numbering,
                          const Records        &records,
                          State                &state)
    {
      const std::vector<double> components = records.values(
        record + ": rotations",
        rotation_items(unknowns, numbering, state.rotations.size()),
        4);
      auto value = components.begin();
      for (Quaternion &rotation : state.rotations)
        {
          rotation.scalar = *value++;
          for (unsigned int d = 0; d < 3; ++d)
            rotation.vector[d] = *value++;
        }
    }

    void save_history(const State        &state,
                      const RecordLayout &layout,
                      Records            &records)
    {
      for (const Record &of_effect : layout.list())
        {
          const auto first = state.history.begin() + of_effect.first;
          records.keep(record + ": " + of_effect.name,
                       of_effect.items,
                       of_effect.values_per_item,
                       {first,
                        first +
                          of_effect.items.size() * of_effect.values_per_item});
        }
    }

    void resume_history(const RecordLayout &layout,
                        const Records      &records,
                        State              &state)
    {
      for (const Record &of_effect : layout.list())
        {
          const std::vector<double> values =
            records.values(record + ": " + of_effect.name,
                           of_effect.items,
                           of_effect.values_per_item);
          std::copy(values.begin(),
                    values.end(),
                    state.history.begin() + of_effect.first);
        }
    }

    /** Signs tell what is known. */
    void save_position(const PathPosition &at, Records &records)
    {
      records.keep(position,
                   {at.load_factor,
                    at.n_negative ? double(*at.n_negative) : -1.,
                    double(at.determinant_sign.value_or(0))});
    }

    /** Each rank has its share of them. */
    void
    save_energies(const State &state, const unsigned int rank, Records &records)
    {
      records.keep(record + ": energies", state.energies.amounts());
      records.keep(record + ": sums of energies",
                   {rank},
                   state.energy_sums.size(),
                   state.energy_sums);
    }

    void resume_energies(const UnknownLayout &layout,
                         const Records       &records,
                         State               &state)
    {
      state.energies.amounts() =
        records.values(record + ": energies", state.energies.amounts().size());
      const std::string        &sums  = record + ": sums of energies";
      std::vector<unsigned int> ranks = records.items(sums);
      // Shares of ranks that are no more go on on the first one.
      state.energy_sums.assign(state.energy_sums.size(), 0.);
      for (const unsigned int rank : ranks)
        if (rank == layout.rank() ||
            (layout.rank() == 0 && rank >= layout.n_ranks()))
          add_multiple(1.,
                       records.values(sums, {rank}, state.energy_sums.size()),
                       state.energy_sums);
    }
  } // namespace

  void
  save_state(const State &state, const Equations &equations, Records &records)
  {
    const DofNumbering  &numbering = equations.model().numbering;
    const UnknownRecords unknowns(numbering);
    records.keep(record,
                 {state.time,
                  double(state.step),
                  state.largest_force,
                  state.largest_energy});
    unknowns.keep(record + displacement, state.displacement, records);
    unknowns.keep(record + residual, state.residual, records);
    unknowns.keep(record + ": largest forces", state.largest_forces, records);
    for (const auto &[name, vector] : optional_vectors(state))
      if (*vector)
        unknowns.keep(record + name, **vector, records);
    if (state.before)
      {
        records.keep(before, {state.before->time_of_loads, state.before->dt});
        unknowns.keep(before + displacement,
                      state.before->displacement,
                      records);
        unknowns.keep(before + residual, state.before->residual, records);
      }
    if (state.path)
      save_position(*state.path, records);
    save_rotations(state, unknowns, numbering, records);
    save_history(state, equations.layout().history, records);
    save_energies(state, numbering.layout().rank(), records);
  }

  State saved_state(const Equations &equations, const Records &records)
  {
    const DofNumbering  &numbering = equations.model().numbering;
    const UnknownRecords unknowns(numbering);
    State                state = equations.initial_state();

    const std::vector<double> scalars = records.values(record, 4);
    state.time                        = scalars[0];
    state.step                        = scalars[1];
    state.largest_force               = scalars[2];
    state.largest_energy              = scalars[3];
    state.displacement = unknowns.values(record + displacement, records);
    state.residual     = unknowns.values(record + residual, records);
    state.largest_forces =
      unknowns.values(record + ": largest forces", records);
    for (const auto &[name, vector] : optional_vectors(state))
      if (records.has(record + name))
        *vector = unknowns.values(record + name, records);
    if (records.has(before))
      {
        const std::vector<double> then = records.values(before, 2);
        state.before.emplace(
          State::Before{then[0],
                        then[1],
                        unknowns.values(before + displacement, records),
                        unknowns.values(before + residual, records)});
      }
    state.path = saved_path_position(records);
    resume_rotations(unknowns, numbering, records, state);
    resume_history(equations.layout().history, records, state);
    resume_energies(numbering.layout(), records, state);
    return state;
  }

  Vector saved_displacement(const Equations &equations, const Records &records)
  {
    return UnknownRecords(equations.model().numbering)
      .values(record + displacement, records);
  }

  double time_of_saved_state(const Records &records)
  {
    return records.values(record, 4)[0];
  }

  unsigned long step_of_saved_state(const Records &records)
  {
    return records.values(record, 4)[1];
  }

  std::optional<PathPosition> saved_path_position(const Records &records)
  {
    if (!records.has(position))
      return std::nullopt;
    const std::vector<double> saved = records.values(position, 3);
    PathPosition              at;
    at.load_factor = saved[0];
    if (saved[1] >= 0)
      at.n_negative = saved[1];
    if (saved[2] != 0)
      at.determinant_sign = saved[2];
    return at;
  }
} // namespace auxfem
