// Which quadrilaterals between prisms are kept.
#pragma once

#include "Prisms/PrismShapes.h"

namespace ransmesh
{
// Gives up quadrilaterals until every group has sound cells with those that it keeps. What one prism gives up, the
// next one loses; prisms that can, take a new point instead of giving up more.
void chooseQuads(const MeshData& mesh, PrismGroups& groups);
} // namespace ransmesh
