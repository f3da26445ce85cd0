#include <auxfem/state/step_report.h>

namespace auxfem
{
  void Work::add_effort(const Work &other)
  {
    iterations += other.iterations;
    factorizations += other.factorizations;
    retries += other.retries;
    shortened += other.shortened;
    linear_solutions += other.linear_solutions;
    linear_iterations += other.linear_iterations;
    wall.setup += other.wall.setup;
    wall.residual += other.wall.residual;
    wall.tangent += other.wall.tangent;
    wall.factorize += other.wall.factorize;
    wall.solve += other.wall.solve;
    wall.contact += other.wall.contact;
    wall.output += other.wall.output;
  }
} // namespace auxfem
