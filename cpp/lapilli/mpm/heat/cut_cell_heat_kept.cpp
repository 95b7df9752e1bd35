#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/cut_cell_heat.hpp"

namespace lapilli {
namespace {

using Vector = SurfaceTerm::Vector;

void write(Archive& archive, const std::string& name, const Vector& values) {
  archive.write(name,
                std::span<const double>(values.data(), static_cast<std::size_t>(values.size())));
}

Vector read(const Archive& archive, const std::string& name) {
  const std::vector<double> values = archive.read_numbers(name);
  return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

template <int Dim>
void CutCellHeat<Dim>::save_stepping(Archive& archive) const {
  adaptive_.save(archive);
  archive.write("heat/stepping/lowest", lowest_);
  archive.write("heat/stepping/highest", highest_);
  archive.write("heat/stepping/explicit_error", explicit_error_);
  archive.write("heat/stepping/implicit_steps", implicit_steps_);
  archive.write("heat/stepping/staged_steps", staged_steps_);
  archive.write("heat/stepping/bend", bend_);
  archive.write("heat/stepping/calming", calming_);
  archive.write("heat/stepping/factor_size", factor_size_);
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    const Solved& one = solved_[k];
    archive.write(message("heat/stepping/earlier ", k), one.earlier);
    archive.write(message("heat/stepping/rise ", k), one.rates.rise);
    archive.write(message("heat/stepping/by_law ", k), one.rates.by_law);
    archive.write(message("heat/stepping/by_sources ", k), one.rates.by_sources);
    archive.write(message("heat/stepping/nodal_error ", k), one.error);
    if (const auto& all = one.all) {
      write(archive, message("heat/stepping/error ", k), all->error);
      write(archive, message("heat/stepping/rate ", k), all->rate);
    }
  }
}

template <int Dim>
void CutCellHeat<Dim>::load_stepping(const Archive& archive) {
  adaptive_.load(archive);
  lowest_ = archive.read_number("heat/stepping/lowest");
  highest_ = archive.read_number("heat/stepping/highest");
  explicit_error_ = archive.read_number("heat/stepping/explicit_error");
  implicit_steps_ = archive.read_index("heat/stepping/implicit_steps");
  staged_steps_ = archive.read_index("heat/stepping/staged_steps");
  bend_ = archive.read_number("heat/stepping/bend");
  calming_ = archive.read_index("heat/stepping/calming");
  factor_size_ = archive.read_number("heat/stepping/factor_size");
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    Solved& one = solved_[k];
    one.earlier = archive.read_numbers(message("heat/stepping/earlier ", k));
    one.rates = {archive.read_numbers(message("heat/stepping/rise ", k)),
                 archive.read_numbers(message("heat/stepping/by_law ", k)),
                 archive.read_number(message("heat/stepping/by_sources ", k))};
    one.error = archive.read_numbers(message("heat/stepping/nodal_error ", k));
    one.all.reset();
    if (adaptive_.kind() == SteppingKind::implicit) {
      number_all_leaders(one);
      one.all->error = read(archive, message("heat/stepping/error ", k));
      one.all->rate = read(archive, message("heat/stepping/rate ", k));
    }
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                 \
  template void CutCellHeat<Dim>::save_stepping(Archive&) const; \
  template void CutCellHeat<Dim>::load_stepping(const Archive&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
