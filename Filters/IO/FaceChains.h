// Numbers of faces, found by the faces' points: a chain at each point of the faces that have it as their smallest.
// Neighbouring cells' faces lie close together in memory, where a hash table would scatter them.
#ifndef FaceChains_h
#define FaceChains_h

#include "CellFaces.h"

#include <vector>

namespace ransmesh
{
class FaceChains
{
public:
  static constexpr std::uint32_t None = 0xFFFFFFFF;

  // Empties them, and makes room for faces 0 to faces - 1 on points 0 to points - 1 (less than 2^31).
  void reset(std::size_t points, std::size_t faces)
  {
    heads_.assign(points, None);
    links_.resize(faces);
  }

  void insert(const FaceKey& key, std::uint32_t face)
  {
    std::uint32_t& head = heads_[key.smallest[0]];
    links_[face] = linkOf(key, head);
    head = face;
  }

  // The face of that key, or None.
  std::uint32_t find(const FaceKey& key) const
  {
    const Link wanted = linkOf(key, None);
    std::uint32_t face = heads_[key.smallest[0]];
    while (face != None && !same(links_[face], wanted))
    {
      face = links_[face].next;
    }
    return face;
  }

  // The same, and takes it out.
  std::uint32_t take(const FaceKey& key)
  {
    const Link wanted = linkOf(key, None);
    std::uint32_t* at = &heads_[key.smallest[0]];
    while (*at != None && !same(links_[*at], wanted))
    {
      at = &links_[*at].next;
    }
    const std::uint32_t face = *at;
    if (face != None)
    {
      *at = links_[face].next;
    }
    return face;
  }

private:
  struct Link
  {
    std::uint32_t second; // the key's points after the smallest; the highest bit tells quadrilaterals
    std::uint32_t third;
    std::uint32_t next;
  };

  static Link linkOf(const FaceKey& key, std::uint32_t next)
  {
    const std::uint32_t quadrilateral = key.count == 4 ? 1u << 31 : 0;
    return { static_cast<std::uint32_t>(key.smallest[1]) | quadrilateral,
      static_cast<std::uint32_t>(key.smallest[2]), next };
  }
  static bool same(const Link& a, const Link& b) { return a.second == b.second && a.third == b.third; }

  std::vector<std::uint32_t> heads_; // by point
  std::vector<Link> links_;          // by face
};
} // namespace ransmesh

#endif
