#include <auxfem/struts/shapes/profiles.h>
#include <auxfem/struts/shapes/rolled_shape.h>
#include <auxfem/struts/shapes/shape_table.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const Text profile_name = {
      "Profile",
      "",
      "Name of a standard profile, e.g. IPE 200, HEA 300, HEB 300, UPE 200 or L "
      "100x100x10.",
      true};

    /** A row of the table of profiles. */
    struct Profile
    {
      std::string        name;
      const RolledShape *shape;
      RolledDimensions   dimensions;
    };

    /** Profile in a line of the table (name, shape, dimensions in mm). */
    Profile read_profile(const std::string &line)
    {
      std::istringstream stream(line);
      Profile            profile;
      std::string        text;
      std::getline(stream, profile.name, ',');
      std::getline(stream, text, ',');
      profile.shape       = find_by_name(rolled_shapes(), text);
      RolledDimensions &d = profile.dimensions;
      for (double *const dimension :
           {&d.height, &d.width, &d.web, &d.flange, &d.fillet, &d.toe})
        {
          std::getline(stream, text, ',');
          *dimension = std::stod(text) * 1e-3;
        }
      return profile;
    }

    std::vector<Profile> read_profiles()
    {
      std::istringstream   table(profile_table);
      std::vector<Profile> profiles;
      std::string          line;
      std::getline(table, line);
      while (std::getline(table, line))
        profiles.push_back(read_profile(line));
      return profiles;
    }

    /** Letters before the size, e.g. IPE. */
    std::string series_of(const std::string &name)
    {
      return {name.begin(),
              std::find_if_not(name.begin(), name.end(), [](const char c) {
                return std::isalpha(static_cast<unsigned char>(c));
              })};
    }

    /** Profiles of the series of @p name, or all series. */
    std::string known_profiles(const std::vector<Profile> &profiles,
                               const std::string          &name)
    {
      std::vector<std::string> series, names;
      for (const Profile &profile : profiles)
        {
          const std::string letters = series_of(profile.name);
          if (series.empty() || series.back() != letters)
            series.push_back(letters);
          if (letters == series_of(name))
            names.push_back(profile.name);
        }
      return names.empty() ? "Known series: " + joined(series)
                           : "Known: " + joined(names);
    }

    std::unique_ptr<CrossSection> make_profile(ParameterValues &values)
    {
      static const std::vector<Profile> profiles = read_profiles();
      const std::string                 name     = values[profile_name];
      const Profile *const              profile  = find_by_name(profiles, name);
      if (profile == nullptr)
        values.refuse(profile_name,
                      "no such profile. " + known_profiles(profiles, name) +
                        ". Draw others by Shape = I, C or L");
      return section_of_outline(values,
                                profile->shape->outline(profile->dimensions));
    }
  } // namespace

  RegistryEntry<CrossSection> profile_entry()
  {
    return {"profile",
            "Rolled steel section of EN 10365 or EN 10056, drawn as I, C or L.",
            {profile_name, torsion_constant_parameter()},
            make_profile};
  }
} // namespace auxfem
