#include <auxfem/analysis/small_motions/complex_shape.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    std::vector<double> conjugate(const UnknownLayout &layout,
                                  std::vector<double>  x)
    {
      const unsigned int n = layout.n_owned();
      for (unsigned int i = 0; i < n; ++i)
        x[n + i] *= -1;
      return x;
    }
  } // namespace

  std::complex<double> product(const UnknownLayout       &layout,
                               const std::vector<double> &x,
                               const std::vector<double> &y)
  {
    const unsigned int   n    = layout.n_owned();
    std::complex<double> mine = 0;
    for (unsigned int i = 0; i < n; ++i)
      mine += std::complex<double>(x[i], x[n + i]) *
        std::complex<double>(y[i], y[n + i]);
    const std::vector<double> sums =
      layout.sum(std::vector<double>{mine.real(), mine.imag()});
    return {sums[0], sums[1]};
  }

  double size(const UnknownLayout &layout, const std::vector<double> &x)
  {
    double sum = 0;
    for (const double value : x)
      sum += value * value;
    return std::sqrt(layout.sum(sum));
  }

  bool are_parallel(const UnknownLayout       &layout,
                    const std::vector<double> &x,
                    const std::vector<double> &y)
  {
    constexpr double parallel = 0.999;
    return std::abs(product(layout, conjugate(layout, x), y)) >
      parallel * size(layout, x) * size(layout, y);
  }

  void turn_phase(const UnknownLayout &layout, std::vector<double> &shape)
  {
    const unsigned int         n = layout.n_owned();
    const std::complex<double> turn =
      std::polar(1., -std::arg(product(layout, shape, shape)) / 2);
    for (unsigned int i = 0; i < n; ++i)
      {
        const std::complex<double> value =
          turn * std::complex<double>(shape[i], shape[n + i]);
        shape[i]     = value.real();
        shape[n + i] = value.imag();
      }
  }
} // namespace auxfem
