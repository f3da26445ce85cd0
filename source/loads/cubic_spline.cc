#include <auxfem/loads/cubic_spline.h>

#include <algorithm>
#include <cstddef>

namespace auxfem
{
  namespace
  {
    /** A row of equations for slopes at neighbouring points. */
    struct Row
    {
      double before, here, after, right_side;
    };

    /** Gaussian elimination without pivoting; first and last have two entries.
     */
    std::vector<double> solve(std::vector<Row> rows)
    {
      const std::size_t n = rows.size();
      for (std::size_t i = 1; i < n; ++i)
        {
          const double factor = rows[i].before / rows[i - 1].here;
          rows[i].here -= factor * rows[i - 1].after;
          rows[i].right_side -= factor * rows[i - 1].right_side;
        }
      std::vector<double> result(n);
      for (std::size_t i = n; i-- > 0;)
        result[i] = (rows[i].right_side -
                     (i + 1 < n ? rows[i].after * result[i + 1] : 0.)) /
          rows[i].here;
      return result;
    }

    /**
     * A third derivative that is continuous at the second point, with the
     * slopes at the first two: @p h, @p d are widths and slopes of the lines
     * between the first three.
     */
    Row end_row(const double (&h)[2], const double (&d)[2])
    {
      const double sum = h[0] + h[1];
      return {0,
              h[1],
              sum,
              ((h[0] + 2 * sum) * h[1] * d[0] + h[0] * h[0] * d[1]) / sum};
    }
  } // namespace

  CubicSpline::CubicSpline(std::vector<double> abscissas,
                           std::vector<double> values)
    : x(std::move(abscissas))
    , y(std::move(values))
  {
    const std::size_t n = x.size();
    const auto width = [this](const std::size_t i) { return x[i + 1] - x[i]; };
    const auto line  = [this, width](const std::size_t i) {
      return (y[i + 1] - y[i]) / width(i);
    };
    if (n < 3)
      {
        slopes.assign(n, n == 2 ? line(0) : 0.);
        return;
      }
    if (n == 3)
      {
        const double second = (line(1) - line(0)) / (x[2] - x[0]);
        slopes              = {line(0) - second * width(0),
                               line(0) + second * width(0),
                               line(1) + second * width(1)};
        return;
      }
    std::vector<Row> rows(n);
    rows.front() = end_row({width(0), width(1)}, {line(0), line(1)});
    for (std::size_t i = 1; i + 1 < n; ++i)
      rows[i] = {width(i),
                 2 * (width(i - 1) + width(i)),
                 width(i - 1),
                 3 * (width(i) * line(i - 1) + width(i - 1) * line(i))};
    const Row last =
      end_row({width(n - 2), width(n - 3)}, {line(n - 2), line(n - 3)});
    rows.back() = {last.after, last.here, 0, last.right_side};
    slopes      = solve(rows);
  }

  Jet CubicSpline::operator()(const double at) const
  {
    const std::size_t n = x.size();
    if (n == 1)
      return {y.front()};
    const std::size_t next =
      std::clamp<std::size_t>(std::upper_bound(x.begin(), x.end(), at) -
                                x.begin(),
                              1,
                              n - 1);
    const std::size_t i = next - 1;
    const double      h = x[next] - x[i], s = at - x[i];
    const double      line = (y[next] - y[i]) / h;
    const double      b    = (3 * line - 2 * slopes[i] - slopes[next]) / h,
                 c         = (slopes[i] + slopes[next] - 2 * line) / (h * h);
    return {y[i] + s * (slopes[i] + s * (b + s * c)),
            slopes[i] + s * (2 * b + 3 * c * s),
            2 * b + 6 * c * s};
  }
} // namespace auxfem
