// A front that still lies on the wall, with what moves its tops.
#pragma once

#include "Insertion/FrontMoves.h"
#include "Layers/ColumnBuilder.h"
#include "Support/Invariants.h"

struct RisingFront
{
  RisingFront(
    const ransmesh::MeshData& data, const ransmesh::PatchTable& patches, const ransmesh::LayerPlan& plan)
    : mesh(invariants::build(data))
    , set(buildColumns(mesh, ransmesh::BoundaryStars(mesh), patches, plan))
    , classes(classify(mesh, patches))
    , front(mesh, set)
    , turns(mesh, set, 10)
    , moves(mesh, set, classes, turns, front)
  {
  }
  RisingFront(const RisingFront&) = delete;

  ransmesh::TetMesh mesh;
  ransmesh::ColumnSet set;
  ransmesh::Classification classes;
  ransmesh::Front front;
  ransmesh::SideTurns turns;
  ransmesh::FrontMoves moves;
};
