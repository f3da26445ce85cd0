#include <auxfem/time/schemes/alpha_family.h>
#include <auxfem/time/schemes/time_scheme.h>

namespace auxfem
{
  namespace
  {
    const std::string generalized_alpha_name = "generalized-alpha";

    const Quantity radius_entry = {
      "Spectral radius",
      "0.8",
      "1",
      Range::closed(0, 1),
      "Spectral radius at infinite frequency of Scheme = generalized-alpha; 1 "
      "is undamped."};

    /** The member of the family with a given spectral radius at infinity. */
    class GeneralizedAlpha : public AlphaFamily
    {
    public:
      explicit GeneralizedAlpha(const double spectral_radius)
        : AlphaFamily(generalized_alpha_name,
                      AlphaFamily::generalized_alpha(spectral_radius))
        , spectral_radius(spectral_radius)
      {}

      std::optional<std::string> note_on_rigid_parts() const override
      {
        // Near 1 errors propagate, and the algorithmic acceleration feeds them
        // back: rates cannot be restored.
        if (spectral_radius <= 0.9)
          return {};
        return "Errors of rigid parts grow with their rotation; Scheme = "
               "newmark, or a Spectral radius of at most 0.9, is stable.";
      }

    private:
      const double spectral_radius;
    };

    std::unique_ptr<TimeScheme> make_generalized_alpha(ParameterValues &values)
    {
      return std::make_unique<GeneralizedAlpha>(values[radius_entry]);
    }
  } // namespace

  AlphaFamily::Coefficients
  AlphaFamily::generalized_alpha(const double spectral_radius)
  {
    const double r       = spectral_radius;
    const double alpha_m = (2 * r - 1) / (1 + r), alpha_f = r / (1 + r);
    const double shift = alpha_f - alpha_m;
    return {alpha_m, alpha_f, (1 + shift) * (1 + shift) / 4, 0.5 + shift};
  }

  TimeSchemeEntry generalized_alpha_entry()
  {
    return {{generalized_alpha_name,
             "Chung-Hulbert, of second order, damps high frequencies",
             {radius_entry},
             make_generalized_alpha},
            {Model::lattice, Model::reduced_cell}};
  }
} // namespace auxfem
