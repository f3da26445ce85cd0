#include <auxfem/figures/cfc_filter.h>
#include <auxfem/figures/run_figures.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/text.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  std::optional<double> CrushResult::specific_energy(const double work) const
  {
    if (!mass || *mass == 0)
      return std::nullopt;
    return energy(work) / *mass;
  }

  namespace
  {
    constexpr std::array<char, 3> axis_letters = {{'x', 'y', 'z'}};

    /** Displacement of a body along an axis; zero without a column. */
    std::vector<double> displacement(const RecordedTable &history,
                                     const std::string   &body,
                                     const char           axis)
    {
      const std::vector<double> *const found = history.find(body + ".u" + axis);
      return found != nullptr ? *found
                              : std::vector<double>(history.n_rows(), 0.);
    }

    /** Displacement of the first body relative to the second one. */
    std::vector<double> relative_displacement(const CrushDefinition &definition,
                                              const RecordedTable   &history,
                                              const char             axis)
    {
      std::vector<double> first =
        displacement(history, definition.bodies[0], axis);
      const std::vector<double> second =
        displacement(history, definition.bodies[1], axis);
      for (std::size_t i = 0; i < first.size(); ++i)
        first[i] -= second[i];
      return first;
    }

    double largest_change(const std::vector<double> &values)
    {
      double largest = 0;
      for (const double value : values)
        largest = std::max(largest, std::abs(value - values.front()));
      return largest;
    }

    /** Axis of the largest relative displacement. */
    unsigned int loading_axis(const CrushDefinition &definition,
                              const RecordedTable   &history)
    {
      unsigned int axis    = 0;
      double       largest = -1;
      for (unsigned int d = 0; d < axis_letters.size(); ++d)
        {
          const double change = largest_change(
            relative_displacement(definition, history, axis_letters[d]));
          if (change > largest)
            {
              axis    = d;
              largest = change;
            }
        }
      return axis;
    }

    /** Force of the lattice on the first body along the axis: plates record it
     * as `f`, supports the opposite one as `r`. */
    std::vector<double> force_on_body(const RecordedTable &history,
                                      const std::string   &body,
                                      const char           axis)
    {
      if (const auto *const force = history.find(body + ".f" + axis))
        return *force;
      std::vector<double> force = history.history(body + ".r" + axis).values;
      for (double &value : force)
        value = -value;
      return force;
    }

    /** Last row before the force begins. */
    std::size_t first_touch(const std::vector<double> &force)
    {
      const auto begin =
        std::find_if(force.begin(), force.end(), [](const double value) {
          return value != 0;
        });
      const std::size_t row = begin - force.begin();
      return row == 0 || row == force.size() ? 0 : row - 1;
    }
  } // namespace

  std::optional<CrushResult> crush_result(const CrushDefinition &definition,
                                          const CrushGeometry   &geometry,
                                          const RecordedTable   &history)
  {
    const unsigned int d     = loading_axis(definition, history);
    const char         axis  = axis_letters[d];
    double             width = 1;
    for (unsigned int e = 0; e < (geometry.depth ? 2 : 3); ++e)
      if (e != d)
        width *= geometry.size[e];
    CrushResult result;
    result.axis = std::string(1, axis);
    result.area = definition.area.value_or(width * geometry.depth.value_or(1));
    result.height = definition.height.value_or(geometry.size[d]);
    result.mass   = geometry.mass;
    if (!(result.area > 0 && result.height > 0))
      return std::nullopt;
    // From the second body to the first one.
    const double direction =
      geometry.positions[0][d] < geometry.positions[1][d] ? -1 : 1;
    const auto motion = relative_displacement(definition, history, axis);
    const auto force  = force_on_body(history, definition.bodies[0], axis);
    const std::size_t start = first_touch(force);
    for (std::size_t i = start; i < force.size(); ++i)
      {
        result.curve.add(direction * (motion[start] - motion[i]) /
                           result.height,
                         direction * force[i] / result.area);
        result.times.push_back(history.columns[0][i]);
      }
    result.figures = crush_figures(result.curve, definition.options);
    return result;
  }

  namespace
  {
    void add_bodies(const FiguresDefinition        &definition,
                    const std::vector<std::string> &bodies,
                    const RecordedTable            &history,
                    RunFigures                     &found)
    {
      for (const std::string &body : bodies)
        for (const BodyFigures &figures :
             figures_of_body(body, history, definition.options))
          found.bodies.push_back(figures);
      const auto is_filtered = [](const BodyFigures &figures) {
        return figures.filtered_acceleration ||
          (figures.force && figures.force->filtered_peak);
      };
      if (std::any_of(found.bodies.begin(), found.bodies.end(), is_filtered))
        found.channel_class = definition.options.channel_class;
      else if (definition.options.channel_class && definition.options.in_time &&
               !found.bodies.empty())
        found.notes.push_back(
          "Rows of history.csv are too far apart for filtered peaks of CFC " +
          number_text(*definition.options.channel_class) + ", which needs " +
          rounded_text(
            1e3 *
            CfcFilter::longest_interval(*definition.options.channel_class)) +
          " ms.");
    }

    void add_transmission(const TransmissionDefinition &definition,
                          const RecordedTable          &history,
                          RunFigures                   &found)
    {
      found.transmission =
        transmission_between(history.history(definition.input),
                             history.history(definition.output),
                             definition.options);
      if (!found.transmission)
        found.notes.push_back(
          "Transmission: fewer than four rows of history.csv lie between From "
          "and To.");
      else if (found.transmission->input_peak.value == 0)
        found.notes.push_back("Transmission: the input \"" + definition.input +
                              "\" is zero.");
    }

    void add_crush_curve(const CrushDefinition &definition,
                         const CrushGeometry   &geometry,
                         const RecordedTable   &history,
                         RunFigures            &found)
    {
      found.crush = crush_result(definition, geometry, history);
      if (!found.crush)
        {
          found.notes.push_back(
            "Crush curve: the lattice has no extent or no known depth; give "
            "Crush curve/Area and Height.");
          return;
        }
      const CrushFigures &figures = found.crush->figures;
      if (!(figures.largest_strain > 0))
        found.notes.push_back("Crush curve: " + definition.bodies[0] + " and " +
                              definition.bodies[1] +
                              " do not approach each other: history.csv has no "
                              "displacement that closes the gap. A support has "
                              "one where it is moved, else give it a probe of "
                              "the same name.");
      else if (!figures.densification_strain)
        found.notes.push_back(
          "Crush curve: the efficiency still grows at the largest strain, " +
          rounded_text(figures.largest_strain) +
          ", so that the onset of densification is not reached.");
    }
  } // namespace

  namespace
  {
    LargestStress largest_stress(const StressProbeDefinition &definition,
                                 const RecordedTable         &history)
    {
      const auto column = [&](const std::string &quantity) {
        return history.history(definition.name + "." + quantity).values;
      };
      const std::vector<double> stress = column("von_mises");
      const std::size_t         row =
        std::max_element(stress.begin(), stress.end()) - stress.begin();
      const double      time = history.columns[0][row];
      const std::string text = number_text(time, 6);
      LargestStress     largest{definition.name,
                            stress[row],
                            column("fibre_stress")[row],
                            time,
                            history.names[0] == "time"
                                  ? "t = " + text + " s"
                                  : history.names[0] + " = " + text,
                            static_cast<unsigned int>(column("strut")[row]),
                            column("position")[row],
                            {}};
      if (definition.strength)
        largest.use = stress[row] / *definition.strength;
      return largest;
    }
  } // namespace

  RunFigures figures_of_run(const FiguresDefinition        &definition,
                            const std::vector<std::string> &bodies,
                            const CrushGeometry            &geometry,
                            const RecordedTable            &history)
  {
    RunFigures found;
    if (history.n_rows() < 2)
      return found;
    if (definition.figures)
      add_bodies(definition, bodies, history, found);
    if (definition.crush)
      add_crush_curve(*definition.crush, geometry, history, found);
    for (const StressProbeDefinition &probe : definition.stresses)
      found.stresses.push_back(largest_stress(probe, history));
    if (definition.transmission)
      add_transmission(*definition.transmission, history, found);
    return found;
  }

  namespace
  {
    void require_column(const std::string              &parameter,
                        const std::string              &name,
                        const std::vector<std::string> &names)
    {
      if (std::find(names.begin(), names.end(), name) == names.end())
        throw InputError(
          parameter + " = " + name +
          ": history.csv has no such column. Allowed: " + joined(names, 60));
    }
  } // namespace

  void require_columns(const FiguresDefinition        &definition,
                       const std::vector<std::string> &names)
  {
    if (definition.transmission)
      {
        require_column("Transmission/Input",
                       definition.transmission->input,
                       names);
        require_column("Transmission/Output",
                       definition.transmission->output,
                       names);
      }
  }
} // namespace auxfem
