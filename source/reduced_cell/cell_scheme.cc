#include <auxfem/reduced_cell/cell_scheme.h>

namespace auxfem
{
  std::unique_ptr<CellScheme> make_cell_scheme(const Scene &scene)
  {
    const auto *own = dynamic_cast<const CellMethod *>(scene.time.scheme.get());
    return own != nullptr ? own->begin(scene)
                          : make_implicit_cell_scheme(scene);
  }
} // namespace auxfem
