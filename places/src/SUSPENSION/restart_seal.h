/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_RESTART_SEAL_H
#define LMP_RESTART_SEAL_H

// Checksum of what a style writes to restart files: a disk or a transfer that has changed a byte of
// it gives an error instead of another simulation. FNV-1a (Fowler, Noll, Vo) of 64 bits, of which a
// double holds 52 as a whole number.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <type_traits>

namespace LAMMPS_NS::Suspension_NS {

inline double seal(const void *data, std::size_t size)
{
  const auto *byte = static_cast<const unsigned char *>(data);
  std::uint64_t sum = 14695981039346656037ULL;
  for (std::size_t n = 0; n < size; n++) sum = (sum ^ byte[n]) * 1099511628211ULL;
  return static_cast<double>(sum >> 12);
}

// Part n of what the fixes keep of an atom, of total values: each part begins with its length. Null
// if a damaged length leads out of them.
inline const double *part_of_atom(const double *values, int n, int total)
{
  double begin = 0.0;
  for (int part = 0; part < n; part++) {
    const double length = values[static_cast<int>(begin)];
    if (!(length >= 1.0 && begin + length < total)) return nullptr;
    begin += length;
  }
  return values + static_cast<int>(begin);
}

// What a fix writes once: a mark with the length, the state, its seal. The length comes first,
// because LAMMPS hands over what it has read without saying how much that is.
template <class State> struct Sealed {
  static_assert(std::is_trivially_copyable<State>::value && sizeof(State) % sizeof(double) == 0,
                "doubles only: padding has no value to be sealed");
  static constexpr std::uint64_t MARK = 0x5355535000000000ULL;    // no plausible number as a double
  static constexpr std::uint64_t HEAD = MARK + sizeof(State);

  std::uint64_t head = HEAD;
  State state{};
  double sum = 0.0;
};

template <class State> void write_sealed(FILE *fp, const State &state)
{
  Sealed<State> record;
  record.state = state;
  record.sum = seal(&record.state, sizeof(State));
  const int size = sizeof(record);    // LAMMPS reads this one
  std::fwrite(&size, sizeof(size), 1, fp);
  std::fwrite(&record, sizeof(record), 1, fp);
}

// Null, or what is wrong; then the state is as before.
template <class State> const char *read_sealed(const char *buffer, State &state)
{
  Sealed<State> record;
  std::memcpy(&record.head, buffer, sizeof(record.head));
  if (record.head != record.HEAD)
    return "is damaged, or was written by another version of the package: use another file, or "
           "continue from a data file written by that version";
  std::memcpy(&record, buffer, sizeof(record));
  if (seal(&record.state, sizeof(State)) != record.sum) return "is damaged: use another one";
  state = record.state;
  return nullptr;
}

// What a pair style writes: bytes with their number and seal in front.
template <class T> void append_bytes(std::string &bytes, const T &value)
{
  static_assert(std::is_trivially_copyable<T>::value, "a value, not an object");
  bytes.append(reinterpret_cast<const char *>(&value), sizeof(T));
}

// Takes a value from their front; zeros beyond their end.
template <class T> void take_bytes(std::string &bytes, T &value)
{
  static_assert(std::is_trivially_copyable<T>::value, "a value, not an object");
  std::memset(&value, 0, sizeof(T));
  std::memcpy(&value, bytes.data(), std::min(sizeof(T), bytes.size()));
  bytes.erase(0, sizeof(T));
}

inline void write_bytes(FILE *fp, const std::string &bytes)
{
  const auto length = static_cast<int>(bytes.size());
  const double sum = seal(bytes.data(), bytes.size());
  std::fwrite(&length, sizeof(int), 1, fp);
  std::fwrite(&sum, sizeof(double), 1, fp);
  std::fwrite(bytes.data(), 1, bytes.size(), fp);
}

// False if they are damaged, or not there.
inline bool read_bytes(FILE *fp, std::string &bytes)
{
  static constexpr int MOST = 1 << 28;    // a million pairs of types and more
  int length = 0;
  double sum = 0.0;
  if (std::fread(&length, sizeof(int), 1, fp) != 1 || std::fread(&sum, sizeof(double), 1, fp) != 1)
    return false;
  if (length < 0 || length > MOST) return false;
  bytes.resize(length);
  return std::fread(&bytes[0], 1, length, fp) == bytes.size() &&
      seal(bytes.data(), bytes.size()) == sum;
}

}    // namespace LAMMPS_NS::Suspension_NS

#endif
