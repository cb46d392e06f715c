// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command waves: histories and peak velocities at gauges, with a law fitted to the peaks.
// Scope: what fix muckpile/gauges wrote; formulas of practice stand beside it under names of their
// own.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "draw/png_file.h"
#include "explosive/charge_window.h"
#include "io/csv_writer.h"
#include "io/fired_charges.h"
#include "io/gauges_file.h"
#include "io/mine_frame.h"
#include "measure/blast_formulas.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "report/waves_plot.h"

namespace muckpile {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void require_charge_mass(const ResultFolder& folder) {
  const auto has = [&](const char* key) { return folder.scene_has(key); };
  if (std::filesystem::exists(folder.dump("holes.csv")) || has("charge_mass_kg") ||
      (has("hole_diameter_m") && has("charge_length_m") && has("explosive_density_kg_m3")))
    return;
  throw NotMeasurable(
      "waves: needs the mass of a charge for the scaled distance: charge_mass_kg in " +
      folder.dump("scene.json").string() + ", by write_scene");
}

// The last row of the first phase of the run, in which the waves pass, or the first of the second
// where there is no such row after time 0; the end of the run where there is no history.
double end_of_waves(const ResultFolder& folder) {
  const std::filesystem::path path = folder.dump("history.csv");
  constexpr double kAll = std::numeric_limits<double>::max();
  if (!std::filesystem::exists(path)) return kAll;
  const CsvTable table = CsvTable::read(path);
  const auto phase = table.find_column("phase");
  if (!phase || table.rows() == 0) return kAll;
  const size_t time = table.column("time_s");
  for (size_t row = 1; row < table.rows(); ++row) {
    if (table.word(row, *phase) != table.word(0, *phase))
      return row > 1 ? table.number(row - 1, time) : table.number(row, time);
  }
  return kAll;
}

// `until` is not before the first sample.
GaugePeak peak_of(const GaugeHistory& gauge, double until) {
  constexpr double kNone = -std::numeric_limits<double>::max();
  GaugePeak peak{&gauge, 0.0, 0.0, 0.0, 0.0, kNaN, kNone, kNone, kNone};
  const auto passes = [&](size_t k) { return k < gauge.time.size() && gauge.time[k] <= until; };
  for (size_t k = 0; passes(k); ++k) {
    peak.pressure = std::max(peak.pressure, gauge.pressure[k]);
    peak.compression = std::max(peak.compression, gauge.principal[k].x());
    peak.tension = std::max(peak.tension, 0.0 - gauge.principal[k].z());
    if (gauge.velocity[k].norm() <= peak.speed) continue;
    peak.speed = gauge.velocity[k].norm();
    peak.time = gauge.time[k];
  }
  for (size_t k = 0; peak.speed > 0.0 && passes(k); ++k) {
    if (gauge.velocity[k].norm() < 0.1 * peak.speed) continue;
    peak.arrival = gauge.time[k];
    break;
  }
  return peak;
}

std::vector<GaugePeak> peaks_of(const std::vector<GaugeHistory>& gauges,
                                const std::vector<FiredCharge>& charges, double mass,
                                double until) {
  std::vector<GaugePeak> peaks;
  for (const GaugeHistory& gauge : gauges) {
    GaugePeak peak = peak_of(gauge, until);
    peak.distance = distance_to_charges(gauge.place, charges);
    peak.scaled = peak.distance / std::sqrt(mass);
    peaks.push_back(peak);
  }
  return peaks;
}

// Gauges of one block move as one: they are one point, at their mean logarithms.
std::vector<Vec2> points_of_blocks(const std::vector<GaugePeak>& peaks) {
  std::map<int, std::pair<Vec2, int>> sums;  // of the logarithms, by block
  for (const GaugePeak& peak : peaks) {
    if (peak.speed <= 0.0 || peak.scaled <= 0.0) continue;
    auto& [sum, count] = sums.try_emplace(peak.gauge->block, Vec2::Zero(), 0).first->second;
    sum += Vec2(std::log(peak.scaled), std::log(peak.speed));
    ++count;
  }
  std::vector<Vec2> points;
  for (const auto& [block, of] : sums)
    points.emplace_back((of.first / of.second).array().exp().matrix());
  return points;
}

void write_histories(const ResultFolder& folder, const std::vector<GaugePeak>& peaks,
                     double until) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(folder.file("waves.csv"),
                with_mine_points("gauge,distance_m,time_s,speed_m_s,vx_m_s,vy_m_s,vz_m_s,"
                                 "pressure_Pa,s1_Pa,s2_Pa,s3_Pa",
                                 frame, {""}));
  for (const GaugePeak& peak : peaks) {
    const GaugeHistory& gauge = *peak.gauge;
    for (size_t k = 0; k < gauge.time.size() && gauge.time[k] <= until; ++k) {
      const Vec3 &v = gauge.velocity[k], &s = gauge.principal[k];
      csv.row_at({static_cast<double>(gauge.number), peak.distance, gauge.time[k], v.norm(), v.x(),
                  v.y(), v.z(), gauge.pressure[k], s.x(), s.y(), s.z()},
                 mine_points(frame, {gauge.place}));
    }
  }
}

void write_peaks(const ResultFolder& folder, const std::vector<GaugePeak>& peaks,
                 const std::optional<PowerFit>& fit) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(
      folder.file("ppv.csv"),
      with_mine_points(
          "gauge,x_m,y_m,z_m,distance_m,scaled_distance_m_kg05,ppv_m_s,ppv_time_s,arrival_s,"
          "largest_pressure_Pa,largest_compression_Pa,largest_tension_Pa,fit_m_s,band_low_m_s,band_"
          "high_m_s,"
          "formula_bureau_of_mines_m_s",
          frame, {""}));
  for (const GaugePeak& peak : peaks) {
    const bool on = fit && peak.scaled > 0.0;
    const Interval band = on ? fit->band(peak.scaled) : Interval{kNaN, kNaN};
    const Vec3& at = peak.gauge->place;
    csv.row_at({static_cast<double>(peak.gauge->number), at.x(), at.y(), at.z(), peak.distance,
                peak.scaled, peak.speed, peak.time, peak.arrival, peak.pressure, peak.compression,
                peak.tension, on ? fit->at(peak.scaled) : kNaN, band.low, band.high,
                peak.scaled > 0.0 ? bureau_of_mines_ppv(peak.scaled) : kNaN},
               mine_points(frame, {at}));
  }
}

nlohmann::ordered_json keys_of_fit(const std::optional<PowerFit>& fit) {
  nlohmann::ordered_json keys;
  for (const char* key : {"ppv_fit_K_m_s", "ppv_fit_K_low_m_s", "ppv_fit_K_high_m_s", "ppv_fit_n",
                          "ppv_fit_n_low", "ppv_fit_n_high", "ppv_fit_r_squared", "ppv_fit_blocks"})
    keys[key] = nullptr;
  keys["ppv_fit_note"] = "PPV = K (R/sqrt(W))^-n, R in m, W in kg; low and high: 95 % confidence";
  if (!fit) {
    keys["ppv_fit_note"] =
        "no fit: it needs gauges in three blocks that moved, at different distances";
    return keys;
  }
  keys["ppv_fit_K_m_s"] = fit->factor;
  keys["ppv_fit_K_low_m_s"] = fit->factor_range.low;
  keys["ppv_fit_K_high_m_s"] = fit->factor_range.high;
  keys["ppv_fit_n"] = fit->exponent;
  keys["ppv_fit_n_low"] = fit->exponent_range.low;
  keys["ppv_fit_n_high"] = fit->exponent_range.high;
  keys["ppv_fit_r_squared"] = fit->r_squared;
  keys["ppv_fit_blocks"] = fit->points;
  return keys;
}

void require_samples(const std::vector<GaugeHistory>& gauges, double until) {
  for (const GaugeHistory& gauge : gauges)
    if (gauge.time.empty() || gauge.time.front() > until)
      throw NotMeasurable("waves: gauge " + std::to_string(gauge.number) +
                          " has no sample before " + std::to_string(until) +
                          " s, the end of the waves (--until)");
}

void measure_waves(const ResultFolder& folder, const WavesOptions& options) {
  const std::filesystem::path path = folder.dump(options.file);
  if (!std::filesystem::exists(path))
    throw NotMeasurable("waves: needs " + path.string() +
                        "; run the input with gauges (fix muckpile/gauges)");
  require_charge_mass(folder);
  const std::vector<GaugeHistory> gauges = read_gauges(path, folder.run_id());
  const std::vector<FiredCharge> charges = fired_charges(folder);
  const double mass = largest_mass_within(charges, kVibrationWindow);
  if (!(mass > 0.0))
    throw NotMeasurable(
        "waves: needs the mass of the charges: an explosive of the hole table is not among the "
        "shipped ones");
  const double until = options.until.value_or(end_of_waves(folder));
  require_samples(gauges, until);
  const std::vector<GaugePeak> peaks = peaks_of(gauges, charges, mass, until);
  const std::optional<PowerFit> fit = fit_decay_law(points_of_blocks(peaks));
  write_histories(folder, peaks, until);
  write_peaks(folder, peaks, fit);
  write_png(draw_waves(peaks), folder.file("waves.png"));
  write_png(draw_peaks(peaks, fit, mass), folder.file("ppv.png"));
  nlohmann::ordered_json keys;
  if (std::filesystem::exists(folder.dump("run.json"))) keys = common_keys(folder);
  keys["gauges"] = gauges.size();
  keys["largest_charge_within_8_ms_kg"] = mass;
  keys["ppv_largest_m_s"] = std::ranges::max(peaks, {}, &GaugePeak::speed).speed;
  keys.update(keys_of_fit(fit));
  folder.merge_into_summary(keys, {refusal_key("waves")});
}

}  // namespace

void report_waves(const ResultFolder& folder, const WavesOptions& options) {
  try {
    measure_waves(folder, options);
  } catch (const NotMeasurable& why) {
    for (const char* ending : {".csv", ".png"})
      std::filesystem::remove(folder.file(std::string("ppv") + ending));
    nlohmann::ordered_json keys = keys_of_fit(std::nullopt);
    for (const char* key : {"gauges", "ppv_largest_m_s"}) keys[key] = nullptr;
    if (std::filesystem::exists(folder.dump("run.json"))) take_back(folder, "waves", keys, why);
    throw;
  }
}

}  // namespace muckpile
