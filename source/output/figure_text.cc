#include <auxfem/figures/figure_table.h>
#include <auxfem/output/figure_files.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    using Value = std::optional<double>;

    Json json_of_stress(const LargestStress &stress)
    {
      Json json = {{"von_mises", stress.von_mises},
                   {"fibre_stress", stress.fibre},
                   {"time", stress.time},
                   {"strut", stress.strut},
                   {"position", stress.position}};
      if (stress.use)
        json["use"] = *stress.use;
      return json;
    }

    std::string text_of_stress(const LargestStress &stress)
    {
      std::ostringstream text;
      text << "Largest stress of " << stress.name << ": "
           << rounded_text(stress.von_mises) << " Pa at " << stress.instant
           << ", in strut " << stress.strut << " at "
           << percentage_text(stress.position) << " of its length";
      if (stress.use)
        text << "; " << percentage_text(*stress.use) << " of the strength";
      text << '\n';
      return text.str();
    }

    /** Adds @p value to @p json unless it is empty. */
    void add(Json &json, const std::string &name, const Value &value)
    {
      if (value)
        json[name] = *value;
    }

    Json json_of_crush(const CrushResult &crush)
    {
      const CrushFigures &f    = crush.figures;
      Json                json = {{"axis", crush.axis},
                                  {"area", crush.area},
                                  {"height", crush.height},
                                  {"largest_strain", f.largest_strain},
                                  {"peak_stress", f.peak_stress},
                                  {"peak_crush_force", f.peak_stress * crush.area},
                                  {"absorbed_energy", crush.energy(f.work_to_largest)},
                                  {"energy_at_end", crush.energy(f.work_at_end)}};
      add(json, "specific_energy", crush.specific_energy(f.work_to_largest));
      add(json, "plateau_stress", f.plateau_stress);
      add(json, "plateau_end", f.plateau_end);
      add(json, "efficiency_at_plateau_end", f.efficiency_at_plateau_end);
      add(json, "densification_strain", f.densification_strain);
      if (!f.densification_strain)
        return json;
      add(json, "efficiency", f.efficiency);
      add(json, "plateau_stress_by_energy", f.plateau_stress_by_energy);
      add(json, "ideality", f.ideality);
      add(json, "crush_force_efficiency", f.crush_force_efficiency);
      json["energy_to_densification"] = crush.energy(*f.work_to_densification);
      add(json,
          "specific_energy_to_densification",
          crush.specific_energy(*f.work_to_densification));
      return json;
    }

    Json json_of_transmission(const Transmission &transmission)
    {
      Json json = {{"input_peak", transmission.input_peak.value},
                   {"output_peak", transmission.output_peak.value}};
      add(json, "peak_ratio", transmission.peak_ratio());
      add(json, "rms_ratio", transmission.rms_ratio());
      if (const TransmissionLine *const line = transmission.main_line())
        {
          json["main_frequency"]          = line->frequency;
          json["ratio_at_main_frequency"] = std::abs(*line->ratio);
        }
      return json;
    }
  } // namespace

  Json json_of(const RunFigures &figures)
  {
    Json json;
    if (figures.channel_class)
      json["filter_class"] = *figures.channel_class;
    for (const BodyFigures &body : figures.bodies)
      for (const BodyFigure &figure : body_figure_columns())
        if (const Value value = figure.value(body))
          json["bodies"][body.body][body.axis][figure.column.name] = *value;
    if (figures.crush)
      json["crush_curve"] = json_of_crush(*figures.crush);
    if (figures.transmission)
      json["transmission"] = json_of_transmission(*figures.transmission);
    for (const LargestStress &stress : figures.stresses)
      json["stresses"][stress.name] = json_of_stress(stress);
    return json;
  }

  namespace
  {
    /** Largest number of bodies and axes on the screen. */
    constexpr std::size_t most_rows = 12;

    /** @p cells in columns of equal width, the first one aligned left. */
    std::string aligned(const std::vector<std::vector<std::string>> &rows)
    {
      std::vector<std::size_t> widths(rows.front().size(), 0);
      for (const auto &row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
          widths[i] = std::max(widths[i], row[i].size());
      std::ostringstream text;
      for (const auto &row : rows)
        {
          text << "  " << std::left << std::setw(widths[0]) << row[0];
          for (std::size_t i = 1; i < row.size(); ++i)
            text << "  " << std::right << std::setw(widths[i]) << row[i];
          text << '\n';
        }
      return text.str();
    }

    std::string table_of_bodies(const RunFigures &figures)
    {
      std::vector<std::vector<std::string>> rows(1);
      rows[0].push_back(figures.channel_class ? "Figures, CFC " +
                            number_text(*figures.channel_class)
                                              : "Figures");
      const std::size_t n = std::min(most_rows, figures.bodies.size());
      for (std::size_t i = 0; i < n; ++i)
        rows.push_back({figures.bodies[i].body + " " + figures.bodies[i].axis});
      for (const BodyFigure &figure : body_figure_columns())
        {
          std::vector<Value> values;
          for (std::size_t i = 0; i < n; ++i)
            values.push_back(figure.value(figures.bodies[i]));
          if (figure.heading.empty() ||
              std::none_of(values.begin(), values.end(), [](const Value &v) {
                return v.has_value();
              }))
            continue;
          rows[0].push_back(figure.heading);
          for (std::size_t i = 0; i < n; ++i)
            rows[i + 1].push_back(values[i] ? rounded_text(*values[i]) : "-");
        }
      std::string text = aligned(rows).substr(2);
      if (n < figures.bodies.size())
        text += "  and " + std::to_string(figures.bodies.size() - n) +
          " more in evaluation.csv\n";
      return text;
    }

    std::string text_of(const CrushResult &crush)
    {
      const CrushFigures &f = crush.figures;
      std::ostringstream  text;
      text << "Crushed along " << crush.axis << " to a strain of "
           << rounded_text(f.largest_strain) << ": peak stress "
           << rounded_text(f.peak_stress) << " Pa";
      if (f.plateau_stress)
        text << ", plateau " << rounded_text(*f.plateau_stress) << " Pa";
      if (f.densification_strain)
        text << ", densification at " << rounded_text(*f.densification_strain);
      text << "; absorbed " << rounded_text(crush.energy(f.work_to_largest))
           << " J";
      if (const Value specific = crush.specific_energy(f.work_to_largest))
        text << ", " << rounded_text(*specific) << " J/kg";
      text << '\n';
      return text.str();
    }

    std::string text_of(const Transmission &transmission)
    {
      std::ostringstream text;
      if (const Value ratio = transmission.peak_ratio())
        text << "Transmitted: " << rounded_text(*ratio)
             << " of the input's peak";
      else
        return "";
      if (const TransmissionLine *const line = transmission.main_line())
        text << ", " << rounded_text(std::abs(*line->ratio)) << " at "
             << rounded_text(line->frequency)
             << " Hz, the main frequency of the input";
      text << '\n';
      return text.str();
    }
  } // namespace

  std::string text_of(const RunFigures &figures)
  {
    std::string text;
    if (!figures.bodies.empty())
      text += table_of_bodies(figures);
    for (const LargestStress &stress : figures.stresses)
      text += text_of_stress(stress);
    if (figures.crush)
      text += text_of(*figures.crush);
    if (figures.transmission)
      text += text_of(*figures.transmission);
    for (const std::string &note : figures.notes)
      text += note + '\n';
    return text;
  }
} // namespace auxfem
