#include <auxfem/analysis/saved_state.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/model/unknown_records.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    const std::string record       = "state",
                      before       = record + " before the last step",
                      position     = record + " on a path",
                      displacement = record + ": displacement";

    void serialize_before(const UnknownRecords &unknowns,
                          CheckpointArchive    &archive,
                          State                &state)
    {
      bool is_there = state.before.has_value();
      archive.values(before + ": whether it is kept", is_there);
      if (!is_there)
        return state.before.reset();
      if (!archive.is_saving())
        state.before.emplace();
      archive.values(before, state.before->time_of_loads, state.before->dt);
      unknowns.serialize(before + ": displacement",
                         state.before->displacement,
                         archive);
      unknowns.serialize(before + ": residual",
                         state.before->residual,
                         archive);
    }

    /** Large rotations in space are known by the first of their unknowns. */
    void serialize_rotations(const UnknownRecords &unknowns,
                             const DofNumbering   &numbering,
                             CheckpointArchive    &archive,
                             State                &state)
    {
      std::vector<unsigned int> items;
      std::vector<double>       components;
      for (unsigned int i = 0; i < state.rotations.size(); ++i)
        {
          const Quaternion &rotation = state.rotations[i];
          items.push_back(unknowns.serial_number(numbering.rotations()[i][0]));
          components.push_back(rotation.scalar);
          components.insert(components.end(),
                            rotation.vector.begin_raw(),
                            rotation.vector.end_raw());
        }
      archive.items(record + ": rotations", items, 4, components);
      for (unsigned int i = 0; i < state.rotations.size(); ++i)
        {
          state.rotations[i].scalar = components[4 * i];
          std::copy_n(components.begin() + 4 * i + 1,
                      3,
                      state.rotations[i].vector.begin_raw());
        }
    }

    /** Internal variables. */
    void serialize_history(const RecordLayout &layout,
                           CheckpointArchive  &archive,
                           State              &state)
    {
      for (const Record &of_effect : layout.list())
        {
          const auto          first = state.history.begin() + of_effect.first;
          std::vector<double> values(first,
                                     first +
                                       of_effect.items.size() *
                                         of_effect.values_per_item);
          archive.items(record + ": " + of_effect.name,
                        of_effect.items,
                        of_effect.values_per_item,
                        values);
          std::copy(values.begin(), values.end(), first);
        }
    }

    /** Signs tell what is known. */
    void serialize_position(CheckpointArchive &archive, PathPosition &at)
    {
      double n_negative = at.n_negative ? double(*at.n_negative) : -1.,
             sign       = at.determinant_sign.value_or(0);
      archive.values(position, at.load_factor, n_negative, sign);
      at.n_negative.reset();
      at.determinant_sign.reset();
      if (n_negative >= 0)
        at.n_negative = n_negative;
      if (sign != 0)
        at.determinant_sign = sign;
    }
  } // namespace

  void serialize_state(const Equations   &equations,
                       CheckpointArchive &archive,
                       State             &state)
  {
    const DofNumbering  &numbering = equations.model().numbering;
    const UnknownRecords unknowns(numbering);
    archive.values(record,
                   state.time,
                   state.step,
                   state.largest_force,
                   state.largest_energy);
    unknowns.serialize(displacement, state.displacement, archive);
    unknowns.serialize(record + ": residual", state.residual, archive);
    unknowns.serialize(record + ": largest forces",
                       state.largest_forces,
                       archive);
    unknowns.serialize(record + ": velocity", state.velocity, archive);
    unknowns.serialize(record + ": acceleration", state.acceleration, archive);
    unknowns.serialize(record + ": algorithmic acceleration",
                       state.algorithmic_acceleration,
                       archive);
    unknowns.serialize(record + ": compensation", state.compensation, archive);
    unknowns.serialize(record + ": unknowns without mass",
                       state.is_massless,
                       archive);
    serialize_before(unknowns, archive, state);
    if (state.path)
      serialize_position(archive, *state.path);
    serialize_rotations(unknowns, numbering, archive, state);
    serialize_history(equations.layout().history, archive, state);
    archive.list(record + ": energies", state.energies.amounts());
    archive.sums(record + ": sums of energies", state.energy_sums);
  }

  Vector saved_displacement(const Equations &equations, const Records &records)
  {
    return UnknownRecords(equations.model().numbering)
      .values(displacement, records);
  }

  double time_of_saved_state(const Records &records)
  {
    return records.values(record, 4)[0];
  }

  unsigned long step_of_saved_state(const Records &records)
  {
    return records.values(record, 4)[1];
  }

  double load_factor_of_saved_state(const Records &records)
  {
    return records.values(position, 3)[0];
  }
} // namespace auxfem
