#include <auxfem/connectors/elastic_law.h>

namespace auxfem
{
  namespace
  {
    /** f = k u + k3 u^3. */
    class CubicCurve : public ForceCurve
    {
    public:
      CubicCurve(const double linear, const double cubic)
        : linear(linear)
        , cubic(cubic)
      {}

      Value at(const double u) const override
      {
        return {(linear + cubic * u * u) * u, linear + 3 * cubic * u * u};
      }

      Value mean(const double u, const double w) const override
      {
        return {(linear / 2 + cubic / 4 * (u * u + w * w)) * (u + w),
                linear / 2 + cubic / 4 * (u * u + 2 * u * w + 3 * w * w)};
      }

      bool has_kinks() const override
      {
        return false;
      }

    private:
      const double linear; ///< k (N/m)
      const double cubic;  ///< k3 (N/m^3)
    };

    const Quantity cubic_spring_stiffness{"Spring stiffness",
                                          "",
                                          "N/m",
                                          Range::non_negative(),
                                          "Stiffness of the spring at rest."};

    const Quantity cubic_stiffness{
      "Cubic stiffness",
      "",
      "N/m^3",
      Range::any(),
      "Force per cube of extension; below 0 the spring softens."};

    std::unique_ptr<ConnectorLaw> make_cubic(ParameterValues &values)
    {
      return make_elastic_law(
        std::make_shared<CubicCurve>(values[cubic_spring_stiffness],
                                     values[cubic_stiffness]),
        {values[parallel_damping()]});
    }
  } // namespace

  RegistryEntry<ConnectorLaw> cubic_entry()
  {
    return {"cubic",
            "Spring with a linear and a cubic force, that hardens or softens "
            "(Duffing).",
            {cubic_spring_stiffness, cubic_stiffness, parallel_damping()},
            make_cubic};
  }
} // namespace auxfem
