#include <auxfem/rigid/effects/rigid_part_group.h>
#include <auxfem/time/small_displacement_error.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  struct SmallDisplacementEstimate::LargestError
  {
    enum class Kind
    {
      none,
      strut,
      rigid_part,
      connector
    };

    /** Errors of SmallDisplacementError without the location's text. */
    struct Errors
    {
      double rotation = 0, second_order = 0, strain = 0;

      double total() const
      {
        return SmallDisplacementError::total(rotation, second_order, strain);
      }
    };

    /** Adds the errors of a single part. */
    void add(const Errors      &candidate,
             const Kind         new_kind,
             const unsigned int new_number,
             const unsigned int new_group = 0)
    {
      if (candidate.total() <= error.total())
        return;
      error  = candidate;
      kind   = new_kind;
      number = new_number;
      group  = new_group;
    }

    /**
     * Takes the errors of the first rank with the largest total. Collective.
     */
    void reduce_over_ranks(const UnknownLayout &layout)
    {
      const double mine          = error.total();
      const double n_ranks       = layout.n_ranks(),
                   largest_total = layout.largest(mine),
                   source_rank   = n_ranks -
        layout.largest(mine == largest_total ? n_ranks - layout.rank() : 0.);
      std::vector<double> values(6, 0.);
      if (layout.rank() == source_rank)
        values = {error.rotation,
                  error.second_order,
                  error.strain,
                  double(kind),
                  double(number),
                  double(group)};
      values = layout.sum(values);
      error  = {values[0], values[1], values[2]};
      kind   = static_cast<Kind>(std::lround(values[3]));
      number = std::lround(values[4]);
      group  = std::lround(values[5]);
    }

    Errors       error;
    Kind         kind   = Kind::none;
    unsigned int number = 0, group = 0;
  };

  dealii::Tensor<1, 3> SmallDisplacementEstimate::Line::relative_displacement(
    const Vector &displacement) const
  {
    dealii::Tensor<1, 3> apart;
    for (unsigned int d = 0; d < 3; ++d)
      apart[d] = (unknowns[3 + d] >= 0 ? displacement[unknowns[3 + d]] : 0.) -
        (unknowns[d] >= 0 ? displacement[unknowns[d]] : 0.);
    return apart;
  }

  SmallDisplacementEstimate::SmallMotion
  SmallDisplacementEstimate::Line::motion(const Vector &displacement) const
  {
    const dealii::Tensor<1, 3> apart = relative_displacement(displacement);
    const double               along = apart * direction;
    return {(apart - along * direction).norm() / length, along / length};
  }

  SmallDisplacementEstimate::SmallDisplacementEstimate(
    const Equations &equations)
    : scene(equations.model().plan.scene)
    , equations(equations)
  {
    for (const StrutGroup &group : equations.reporting().struts)
      add_chords(group);
    count_struts();
    for (unsigned int group = 0; group < scene.connectors.size(); ++group)
      if (scene.connectors[group].geometry ==
          ConnectorDefinition::Geometry::line)
        add_connectors(group);
  }

  void SmallDisplacementEstimate::add_chords(const StrutGroup &group)
  {
    const LatticeModel &model        = equations.model();
    const DofNumbering &numbering    = model.numbering;
    const unsigned int  n_components = numbering.n_components();
    for (unsigned int e = group.forces->elements().begin;
         e < group.forces->elements().end;
         ++e)
      {
        const DofNumbering::Element &element = numbering.elements()[e];
        const Strut  &strut = model.lattice.struts[element.interval.strut];
        const Section section =
          model.sections[strut.section].at(element.interval.at(0));
        Line line;
        line.unknowns.fill(-1);
        std::array<dealii::Point<3>, 2> ends;
        for (unsigned int end = 0; end < 2; ++end)
          {
            dealii::Tensor<1, 3> tangent;
            model.lattice.axis(strut,
                               element.interval.at(end == 0 ? -1 : 1),
                               ends[end],
                               tangent);
            for (unsigned int d = 0; d < model.lattice.dimension; ++d)
              line.unknowns[3 * end + d] =
                numbering.element_unknowns(e)[n_components * end + d];
          }
        const dealii::Tensor<1, 3> span = ends[1] - ends[0];
        line.length                     = span.norm();
        line.direction                  = span / line.length;
        const double length             = model.lattice.length(strut);
        const double bending            = model.lattice.dimension == 2
                     ? section.bending_stiffness_3()
                     : std::min(section.bending_stiffness_2(),
                     section.bending_stiffness_3());
        // In small displacements its mean axial strain is that of its chord.
        const bool is_chord =
          strut.sagitta == 0 && !model.plan.simulated.large_rotation;
        using dealii::numbers::PI;
        chords.push_back({line,
                          is_chord ? nullptr : group.forces,
                          e,
                          element.interval.strut,
                          /*index=*/0,
                          PI * PI * bending / (length * length),
                          section.axial_stiffness(),
                          element.is_owned});
      }
  }

  void SmallDisplacementEstimate::count_struts()
  {
    for (const Chord &chord : chords)
      if (chord.is_counted)
        counted.push_back(chord.strut);
    std::sort(counted.begin(), counted.end());
    counted.erase(std::unique(counted.begin(), counted.end()), counted.end());
    for (Chord &chord : chords)
      chord.index =
        std::lower_bound(counted.begin(), counted.end(), chord.strut) -
        counted.begin();
  }

  void SmallDisplacementEstimate::add_connectors(const unsigned int group)
  {
    const LatticeModel &model     = equations.model();
    const DofNumbering &numbering = model.numbering;
    for (const JointPair &pair : model.connector_pairs[group])
      {
        if (!numbering.layout().is_owned(
              numbering.joint_unknown(pair.first, 0)))
          continue;
        const bool is_grounded = pair.second == invalid_index;
        Line       line;
        for (unsigned int i = 0; i < 6; ++i)
          line.unknowns[i] = i >= 3 && is_grounded
            ? -1
            : numbering.joint_unknown(i < 3 ? pair.first : pair.second, i % 3);
        const dealii::Tensor<1, 3> span = is_grounded
          ? scene.connectors[group].ground_offset
          : model.lattice.joints[pair.second] -
            model.lattice.joints[pair.first];
        line.length                     = span.norm();
        line.direction                  = span / line.length;
        connectors.push_back({line, group, pair.first});
      }
  }

  double
  SmallDisplacementEstimate::node_rotation(const Chord  &chord,
                                           const Vector &displacement) const
  {
    const DofNumbering &numbering    = equations.model().numbering;
    const unsigned int  n_components = numbering.n_components();
    const int          *unknowns = numbering.element_unknowns(chord.element);
    double              largest_square = 0;
    for (unsigned int end = 0; end < 2; ++end)
      {
        double square = 0;
        for (unsigned int c = equations.model().lattice.dimension;
             c < n_components;
             ++c)
          {
            const double angle = displacement[unknowns[n_components * end + c]];
            square += angle * angle;
          }
        largest_square = std::max(largest_square, square);
      }
    return std::sqrt(largest_square);
  }

  double
  SmallDisplacementEstimate::overall_second_order(const double own_work,
                                                  const double own_axial_energy,
                                                  const State &state) const
  {
    const std::vector<double> sums = equations.unknowns().layout.sum(
      std::vector<double>{own_work, own_axial_energy});
    const double elastic = state.energies.strain() + state.energies.stored(),
                 bending = elastic - sums[1];
    // Smaller errors are round-off.
    constexpr double negligible = 1e-10;
    return bending > negligible * elastic ? std::abs(sums[0]) / (2 * bending)
                                          : 0.;
  }

  double SmallDisplacementEstimate::axial_force(const Chord &chord,
                                                const State &state) const
  {
    return chord.struts == nullptr
      ? chord.axial_stiffness * chord.line.motion(state.displacement).strain
      : chord.struts->axial_force(state, chord.element);
  }

  Vector SmallDisplacementEstimate::forces_by_turning(const State &state) const
  {
    Vector forces(state.displacement.size(), 0.);
    for (const Chord &chord : chords)
      {
        const Line                &line = chord.line;
        const dealii::Tensor<1, 3> apart =
          line.relative_displacement(state.displacement);
        const dealii::Tensor<1, 3> force = axial_force(chord, state) /
          line.length * (apart - (apart * line.direction) * line.direction);
        for (unsigned int i = 0; i < 6; ++i)
          if (line.unknowns[i] >= 0)
            forces[line.unknowns[i]] += i < 3 ? -force[i] : force[i - 3];
      }
    return forces;
  }

  SmallDisplacementError SmallDisplacementEstimate::at(const State &state) const
  {
    const Vector       &displacement = state.displacement;
    LargestError        largest;
    double              work = 0, axial_energy = 0;
    std::vector<double> compressions(counted.size(), 0.);
    for (const Chord &chord : chords)
      {
        if (!chord.is_counted)
          continue;
        const double rotation = chord.line.motion(displacement).rotation,
                     force    = axial_force(chord, state);
        work += force * rotation * rotation * chord.line.length;
        axial_energy +=
          force * force * chord.line.length / (2 * chord.axial_stiffness);
        compressions[chord.index] =
          std::max(compressions[chord.index], -force / chord.buckling_force);
        largest.add({std::max(rotation, node_rotation(chord, displacement)),
                     // Below the Euler load the effect depends on bending.
                     -force > chord.buckling_force
                       ? -force / chord.buckling_force
                       : 0.,
                     std::abs(force) / chord.axial_stiffness},
                    LargestError::Kind::strut,
                    chord.strut);
      }
    for (const Connector &connector : connectors)
      largest.add({connector.line.motion(displacement).rotation, 0, 0},
                  LargestError::Kind::connector,
                  connector.joint,
                  connector.group);
    if (const auto *parts = equations.reporting().rigid_parts)
      for (unsigned int i = 0; i < parts->n_reported(); ++i)
        largest.add({parts->rotation(i, state).norm(), 0, 0},
                    LargestError::Kind::rigid_part,
                    parts->part(i));
    largest.reduce_over_ranks(equations.unknowns().layout);
    const double compression = compressions.empty()
      ? 0.
      : *std::max_element(compressions.begin(), compressions.end());
    return {largest.error.rotation,
            std::max(largest.error.second_order,
                     overall_second_order(work, axial_energy, state)),
            largest.error.strain,
            location_of(largest),
            equations.unknowns().layout.largest(compression),
            std::move(compressions)};
  }

  std::string
  SmallDisplacementEstimate::location_of(const LargestError &largest) const
  {
    switch (largest.kind)
      {
        case LargestError::Kind::strut:
          return "strut " + std::to_string(largest.number);
        case LargestError::Kind::rigid_part:
          return "rigid part " + std::to_string(largest.number);
        case LargestError::Kind::connector:
          return "connector " + scene.connectors[largest.group].name +
            " of joint " + std::to_string(largest.number);
        case LargestError::Kind::none:
          break;
      }
    return "";
  }
} // namespace auxfem
